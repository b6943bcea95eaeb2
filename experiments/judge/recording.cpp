#include "experiments/judge/recording.h"

#include <xxhash.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "experiments/judge/state_text.h"
#include "sim/files/regular_file.h"

namespace judge {
namespace {

constexpr std::string_view magic = "matchday judged game 2\n";
constexpr std::string_view magic_without_checks = "matchday judged game 1\n";
constexpr char tick_follows = 'T';
constexpr char end_follows = 'E';
constexpr std::size_t buffer_size = 1 << 20;
constexpr std::uint8_t no_number = 255;
constexpr std::uint32_t longest_text = 1 << 20;  // more is damage

// What is beyond these is damage, not a game. All ours: several times what a simulated game can hold.
constexpr double farthest = 100;            // [m]
constexpr double fastest = 1000;            // [m/s], and of impulses [N s]
constexpr double fastest_turn = 1e6;        // [rad/s]
constexpr double largest_angle = 1e6;       // [rad]
constexpr std::size_t most_robots = 32;     // 16 patterns of each team
constexpr std::size_t most_contacts = 512;  // of 4 substeps with 32 robots
constexpr std::size_t most_images = 256;
constexpr std::size_t most_objects = 1024;  // of a kind in one image
constexpr int last_camera = 255;
constexpr std::int64_t most_ticks = 1'000'000;  // four and a half hours
// an image is delivered up to a second after its capture
constexpr world::Duration behind = std::chrono::seconds{10};
constexpr world::Duration ahead = std::chrono::seconds{1};

template <class Value>
void put(std::string& bytes, Value value) {
  static_assert(std::is_arithmetic_v<Value>);
  bytes.append(std::bit_cast<std::array<char, sizeof value>>(value).data(), sizeof value);
}
void put_text(std::string& bytes, const std::string& text) {
  put(bytes, static_cast<std::uint32_t>(text.size()));
  bytes += text;
}
void put_robot(std::string& bytes, world::RobotId id) {
  put(bytes, static_cast<std::uint8_t>(id.team));
  put(bytes, id.number);
}
template <class Vector>
void put_all(std::string& bytes, const Vector& vector) {
  for (const double value : vector) put(bytes, value);
}
template <class List>
void put_count(std::string& bytes, const List& list) {
  put(bytes, static_cast<std::uint16_t>(list.size()));
}
std::int64_t ns(world::Time time) { return time.time_since_epoch().count(); }

// Millimetres as the wire's float; world::as_on_wire gives the same bits back.
void put_on_wire(std::string& bytes, const world::Vector2d& metres) {
  for (const double value : metres) put(bytes, static_cast<float>(value * 1000.0));
}

void put_truth(std::string& bytes, const truth::Frame& truth) {
  put(bytes, truth.tick);
  put(bytes, ns(truth.time));
  put_all(bytes, truth.ball.position);
  put_all(bytes, truth.ball.velocity);
  put_all(bytes, truth.ball.spin);
  put_count(bytes, truth.robots);
  for (const truth::Robot& robot : truth.robots) {
    put_robot(bytes, robot.id);
    put_all(bytes, robot.position);
    put(bytes, robot.orientation);
    put_all(bytes, robot.velocity);
    put(bytes, robot.angular_velocity);
    put(bytes, static_cast<std::uint8_t>(robot.ball_contact));
  }
  put_count(bytes, truth.contacts);
  for (const truth::Contact& contact : truth.contacts) {
    put(bytes, ns(contact.time));
    put_robot(bytes, contact.robot);
    put_all(bytes, contact.point);
    put(bytes, contact.impulse);
  }
  put_count(bytes, truth.kicks);
  for (const truth::Kick& kick : truth.kicks) {
    put(bytes, ns(kick.time));
    put_robot(bytes, kick.robot);
    put_all(bytes, kick.position);
    put_all(bytes, kick.velocity);
  }
}

void put_images(std::string& bytes, std::span<const world::Detection> images) {
  put_count(bytes, images);
  for (const world::Detection& image : images) {
    put(bytes, static_cast<std::int32_t>(image.camera));
    put(bytes, image.frame_number);
    put(bytes, ns(image.t_capture));
    put(bytes, ns(image.t_sent));
    put_count(bytes, image.balls);
    for (const world::DetectedBall& ball : image.balls) put_on_wire(bytes, ball.position);
    put_count(bytes, image.robots);
    for (const world::DetectedRobot& robot : image.robots) {
      put(bytes, static_cast<std::uint8_t>(robot.team));
      put(bytes, robot.number.value_or(no_number));
      put_on_wire(bytes, robot.position);
      put(bytes, robot.orientation ? static_cast<float>(*robot.orientation)
                                   : std::numeric_limits<float>::quiet_NaN());
    }
  }
}

}  // namespace

RecordingWriter::RecordingWriter(std::filesystem::path file, const std::string& job)
    : file_(std::move(file)), buffer_(buffer_size) {
  if (file_.has_parent_path()) std::filesystem::create_directories(file_.parent_path());
  stream_.rdbuf()->pubsetbuf(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  stream_.open(file_.string() + ".part", std::ios::binary);
  if (!stream_) throw std::runtime_error(file_.string() + ": cannot be written");
  bytes_ = magic;
  put_text(bytes_, job);
  write_checked();
}

void RecordingWriter::write_checked() {
  check_ = XXH3_64bits_withSeed(bytes_.data(), bytes_.size(), check_);
  put(bytes_, check_);
  stream_ << bytes_;
}

void RecordingWriter::add(const truth::Frame& truth, std::span<const world::Detection> images,
                          const world::GameState& state) {
  bytes_.clear();
  bytes_ += tick_follows;
  put_truth(bytes_, truth);
  put_images(bytes_, images);
  std::string text = state_text(state);
  const bool changed = text != state_;
  put_text(bytes_, changed ? text : "");
  state_ = std::move(text);
  write_checked();
}

void RecordingWriter::close(std::int64_t ticks, const std::string& hash) {
  bytes_ = end_follows;
  put(bytes_, ticks);
  put_text(bytes_, hash);
  write_checked();
  stream_.close();
  if (!stream_) throw std::runtime_error(file_.string() + ": cannot be written");
  std::filesystem::rename(file_.string() + ".part", file_);
}

RecordingReader::RecordingReader(std::filesystem::path file) : file_(std::move(file)), buffer_(buffer_size) {
  if (const std::string problem = files::not_regular(file_); !problem.empty()) {
    throw std::invalid_argument(file_.string() + ": " + problem);
  }
  stream_.rdbuf()->pubsetbuf(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  stream_.open(file_, std::ios::binary);
  std::string begin(magic.size(), '\0');
  if (!read(begin.data(), begin.size()) || (begin != magic && begin != magic_without_checks)) {
    throw std::invalid_argument(file_.string() +
                                ": is no judged game, or of another version; matchday judge DESIGN --keep "
                                "writes them");
  }
  checked_ = begin == magic;
  job_ = take_text();
  take_check();
}

bool RecordingReader::read(char* bytes, std::size_t size) {
  if (!stream_.read(bytes, static_cast<std::streamsize>(size))) return false;
  part_.append(bytes, size);
  return true;
}

void RecordingReader::take_check() {
  if (checked_) {
    check_ = XXH3_64bits_withSeed(part_.data(), part_.size(), check_);
    if (take<std::uint64_t>() != check_) damaged("the bytes before are not what was written");
  }
  part_.clear();
}

void RecordingReader::damaged(const std::string& what) {
  stream_.clear();
  const auto place = static_cast<std::int64_t>(stream_.tellg());
  throw std::invalid_argument(
      file_.string() + ": " + what + ", at byte " + std::to_string(place) + " after tick " +
      std::to_string(tick_.truth.tick) +
      ": is damaged or stops early; remove it and let matchday judge DESIGN --keep play "
      "the game again");
}

template <class Value>
Value RecordingReader::take() {
  std::array<char, sizeof(Value)> bytes{};
  if (!read(bytes.data(), bytes.size())) damaged("a number is missing");
  return std::bit_cast<Value>(bytes);
}

std::string RecordingReader::take_text() {
  const auto size = take<std::uint32_t>();
  if (size > longest_text) damaged("a text of " + std::to_string(size) + " bytes");
  std::string text(size, '\0');
  if (!read(text.data(), size)) damaged("a text is cut short");
  return text;
}

double RecordingReader::take_number(double largest) {
  const auto value = take<double>();
  if (!(std::abs(value) <= largest)) damaged("a number is " + std::to_string(value));  // also NaN
  return value;
}

template <class Vector>
void RecordingReader::take_all(Vector& vector, double largest) {
  for (double& value : vector) value = take_number(largest);
}

world::Vector2d RecordingReader::take_on_wire() {
  world::Vector2d metres;
  for (double& value : metres) {
    const auto millimetres = static_cast<double>(take<float>());
    if (!(std::abs(millimetres) <= 1000 * farthest)) damaged("a place is " + std::to_string(millimetres));
    value = millimetres / 1000.0;
  }
  return metres;
}

std::size_t RecordingReader::take_count(std::size_t most) {
  const auto count = take<std::uint16_t>();
  if (count > most)
    damaged("there are " + std::to_string(count) + " of something, not at most " + std::to_string(most));
  return count;
}

world::Time RecordingReader::take_time() {
  const world::Time time{world::Duration{take<std::int64_t>()}};
  const world::Time now = tick_.truth.time;
  if (time > now + ahead || time < now - behind) damaged("an instant is far from its tick");
  return time;
}

world::Team RecordingReader::take_team() {
  const auto team = take<std::uint8_t>();
  if (team > 1) damaged("there is no team " + std::to_string(team));
  return static_cast<world::Team>(team);
}

world::RobotId RecordingReader::take_robot() {
  const world::Team team = take_team();
  const auto number = take<std::uint8_t>();
  if (number > world::max_robot_number) damaged("there is no robot " + std::to_string(number));
  return {team, number};
}

void RecordingReader::take_truth(truth::Frame& truth) {
  const auto tick = take<std::int64_t>();
  if (begun_ ? tick != truth.tick + 1 : tick < 0 || tick > most_ticks)
    damaged("tick " + std::to_string(tick) + " follows");
  begun_ = true;
  truth.tick = tick;
  truth.time = world::tick_time(tick);
  if (take<std::int64_t>() != ns(truth.time)) damaged("the tick's time is another one's");
  take_all(truth.ball.position, farthest);
  take_all(truth.ball.velocity, fastest);
  take_all(truth.ball.spin, fastest_turn);
  truth.robots.resize(take_count(most_robots));
  for (std::size_t n = 0; n < truth.robots.size(); ++n) {
    truth::Robot& robot = truth.robots[n];
    robot.id = take_robot();
    if (n > 0 && !(truth.robots[n - 1].id < robot.id)) damaged("the robots are not in order");
    take_all(robot.position, farthest);
    robot.orientation = take_number(largest_angle);
    take_all(robot.velocity, fastest);
    robot.angular_velocity = take_number(fastest_turn);
    robot.ball_contact = take<std::uint8_t>() != 0;
  }
  truth.contacts.resize(take_count(most_contacts));
  for (truth::Contact& contact : truth.contacts) {
    contact.time = take_time();
    contact.robot = take_robot();
    take_all(contact.point, farthest);
    contact.impulse = take_number(fastest);
  }
  truth.kicks.resize(take_count(most_contacts));
  for (truth::Kick& kick : truth.kicks) {
    kick.time = take_time();
    kick.robot = take_robot();
    take_all(kick.position, farthest);
    take_all(kick.velocity, fastest);
  }
}

void RecordingReader::take_image(world::Detection& image) {
  image.camera = take<std::int32_t>();
  if (image.camera < 0 || image.camera > last_camera)
    damaged("there is no camera " + std::to_string(image.camera));
  image.frame_number = take<std::uint32_t>();
  image.t_capture = take_time();
  image.t_sent = take_time();
  image.balls.resize(take_count(most_objects));
  for (world::DetectedBall& ball : image.balls) ball.position = take_on_wire();
  image.robots.resize(take_count(most_objects));
  for (world::DetectedRobot& robot : image.robots) {
    robot.team = take_team();
    const auto number = take<std::uint8_t>();
    if (number > world::max_robot_number && number != no_number)
      damaged("there is no robot " + std::to_string(number));
    robot.number = number == no_number ? std::nullopt : std::optional(number);
    robot.position = take_on_wire();
    const auto orientation = static_cast<double>(take<float>());
    if (std::abs(orientation) > largest_angle) damaged("an angle is " + std::to_string(orientation));
    robot.orientation = std::isnan(orientation) ? std::nullopt : std::optional(orientation);
  }
}

const RecordedTick* RecordingReader::next() {
  const char tag = take<char>();
  if (tag == end_follows) {
    ticks_ = take<std::int64_t>();
    hash_ = take_text();
    take_check();
    if (ticks_ != tick_.truth.tick) damaged("the game ended at tick " + std::to_string(ticks_));
    if (stream_.peek() != std::ifstream::traits_type::eof()) damaged("something follows the end");
    return nullptr;
  }
  if (tag != tick_follows) damaged("neither a tick nor the end follows");
  take_truth(tick_.truth);
  tick_.images.resize(take_count(most_images));
  for (world::Detection& image : tick_.images) take_image(image);
  const std::string state = take_text();
  take_check();
  try {
    if (!state.empty()) tick_.state = state_in(state);
  } catch (const std::exception& error) {
    damaged(std::string("the referee's state: ") + error.what());
  }
  return &tick_;
}

}  // namespace judge
