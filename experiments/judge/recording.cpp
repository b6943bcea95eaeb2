#include "experiments/judge/recording.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "experiments/judge/state_text.h"

namespace judge {
namespace {

constexpr std::string_view magic = "matchday judged game 1\n";
constexpr char tick_follows = 'T';
constexpr char end_follows = 'E';
constexpr std::size_t buffer_size = 1 << 20;
constexpr std::uint8_t no_number = 255;
constexpr std::uint32_t longest_text = 1 << 20;  // more is damage

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
  stream_ << bytes_;
}

void RecordingWriter::close(std::int64_t ticks, const std::string& hash) {
  bytes_ = end_follows;
  put(bytes_, ticks);
  put_text(bytes_, hash);
  stream_ << bytes_;
  stream_.close();
  if (!stream_) throw std::runtime_error(file_.string() + ": cannot be written");
  std::filesystem::rename(file_.string() + ".part", file_);
}

RecordingReader::RecordingReader(std::filesystem::path file) : file_(std::move(file)), buffer_(buffer_size) {
  stream_.rdbuf()->pubsetbuf(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  stream_.open(file_, std::ios::binary);
  std::string begin(magic.size(), '\0');
  if (!stream_.read(begin.data(), static_cast<std::streamsize>(begin.size())) || begin != magic) {
    throw std::invalid_argument(file_.string() +
                                ": is no judged game; matchday judge DESIGN --keep writes them");
  }
  job_ = take_text();
}

void RecordingReader::damaged() const {
  throw std::invalid_argument(file_.string() + ": is damaged or stops early; remove it and let " +
                              "matchday judge DESIGN --keep play the game again");
}

template <class Value>
Value RecordingReader::take() {
  std::array<char, sizeof(Value)> bytes{};
  if (!stream_.read(bytes.data(), bytes.size())) damaged();
  return std::bit_cast<Value>(bytes);
}

std::string RecordingReader::take_text() {
  const auto size = take<std::uint32_t>();
  if (size > longest_text) damaged();
  std::string text(size, '\0');
  if (!stream_.read(text.data(), size)) damaged();
  return text;
}

world::RobotId RecordingReader::take_robot() {
  const auto team = take<std::uint8_t>();
  if (team > 1) damaged();
  return {static_cast<world::Team>(team), take<std::uint8_t>()};
}

const RecordedTick* RecordingReader::next() {
  const auto take_time = [this] { return world::Time{world::Duration{take<std::int64_t>()}}; };
  const auto fill = [this](auto& vector) {
    for (double& value : vector) value = take<double>();
  };
  const auto take_on_wire = [this] {
    world::Vector2d metres;
    for (double& value : metres) value = static_cast<double>(take<float>()) / 1000.0;
    return metres;
  };
  const char tag = take<char>();
  if (tag == end_follows) {
    ticks_ = take<std::int64_t>();
    hash_ = take_text();
    return nullptr;
  }
  if (tag != tick_follows) damaged();

  truth::Frame& truth = tick_.truth;
  truth.tick = take<std::int64_t>();
  truth.time = take_time();
  fill(truth.ball.position);
  fill(truth.ball.velocity);
  fill(truth.ball.spin);
  truth.robots.resize(take<std::uint16_t>());
  for (truth::Robot& robot : truth.robots) {
    robot.id = take_robot();
    fill(robot.position);
    robot.orientation = take<double>();
    fill(robot.velocity);
    robot.angular_velocity = take<double>();
    robot.ball_contact = take<std::uint8_t>() != 0;
  }
  truth.contacts.resize(take<std::uint16_t>());
  for (truth::Contact& contact : truth.contacts) {
    contact.time = take_time();
    contact.robot = take_robot();
    fill(contact.point);
    contact.impulse = take<double>();
  }
  truth.kicks.resize(take<std::uint16_t>());
  for (truth::Kick& kick : truth.kicks) {
    kick.time = take_time();
    kick.robot = take_robot();
    fill(kick.position);
    fill(kick.velocity);
  }
  tick_.images.resize(take<std::uint16_t>());
  for (world::Detection& image : tick_.images) {
    image.camera = take<std::int32_t>();
    image.frame_number = take<std::uint32_t>();
    image.t_capture = take_time();
    image.t_sent = take_time();
    image.balls.resize(take<std::uint16_t>());
    for (world::DetectedBall& ball : image.balls) ball.position = take_on_wire();
    image.robots.resize(take<std::uint16_t>());
    for (world::DetectedRobot& robot : image.robots) {
      const auto team = take<std::uint8_t>();
      if (team > 1) damaged();
      robot.team = static_cast<world::Team>(team);
      const auto number = take<std::uint8_t>();
      robot.number = number == no_number ? std::nullopt : std::optional(number);
      robot.position = take_on_wire();
      const auto orientation = static_cast<double>(take<float>());
      robot.orientation = std::isnan(orientation) ? std::nullopt : std::optional(orientation);
    }
  }
  const std::string state = take_text();
  try {
    if (!state.empty()) tick_.state = state_in(state);
  } catch (const std::exception&) {
    damaged();
  }
  return &tick_;
}

}  // namespace judge
