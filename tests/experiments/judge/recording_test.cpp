// A recorded game with one value that no game can have: refused with file and place.
#include "experiments/judge/recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <limits>

#include "tests/experiments/runner/support.h"

namespace judge {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using world::Team;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

struct Tick {
  truth::Frame truth;
  std::vector<world::Detection> images;
};

/// Two ticks with something of everything.
std::vector<Tick> good() {
  std::vector<Tick> ticks;
  for (int n = 1; n <= 2; ++n) {
    Tick tick;
    tick.truth.tick = n;
    tick.truth.time = world::tick_time(n);
    tick.truth.robots = {{.id = {Team::Yellow, 1}}, {.id = {Team::Blue, 0}}};
    tick.truth.contacts = {{tick.truth.time, {Team::Yellow, 1}, {0, 0, 0}, 0.1}};
    tick.truth.kicks = {{tick.truth.time, {Team::Yellow, 1}, {0, 0, 0}, {1, 0, 0}}};
    world::Detection image;
    image.t_capture = image.t_sent = tick.truth.time;
    image.balls.push_back({});
    image.robots.push_back({.team = Team::Yellow, .number = 1, .orientation = 1.0});
    image.robots.push_back({.team = Team::Blue, .number = {}, .orientation = {}});
    tick.images = {image};
    ticks.push_back(tick);
  }
  return ticks;
}

class Recording : public testing::Test {
 protected:
  /// Why what was written cannot be read; empty: it can.
  std::string complaint(const std::vector<Tick>& ticks, std::int64_t end = 2, const std::string& after = "") {
    const std::filesystem::path file = path();
    RecordingWriter writer(file, "job");
    for (const Tick& tick : ticks) writer.add(tick.truth, tick.images, {});
    writer.close(end, "hash");
    std::ofstream(file, std::ios::app | std::ios::binary) << after;
    return read();
  }
  std::filesystem::path path() const { return folder_.path() / "it.judged"; }
  /// Why the file cannot be read; empty: it can.
  std::string read() const {
    try {
      RecordingReader reader(path());
      while (reader.next() != nullptr) {
      }
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }
  /// The same of good ticks, the second of which is changed.
  std::string complaint(const std::function<void(Tick&)>& change) {
    std::vector<Tick> ticks = good();
    change(ticks[1]);
    return complaint(ticks);
  }

 private:
  runner::TemporaryFolder folder_;
};

TEST_F(Recording, IsReadWhenItIsWhole) { EXPECT_EQ(complaint(good()), ""); }

TEST_F(Recording, RefusesValuesThatNoGameHas) {
  const std::vector<std::pair<std::string, std::function<void(Tick&)>>> changes = {
      {"tick 3 follows", [](Tick& t) { t.truth.tick = 3; }},
      {"tick -1 follows", [](Tick& t) { t.truth.tick = -1; }},
      {"the tick's time", [](Tick& t) { t.truth.time += std::chrono::nanoseconds{1}; }},
      {"a number is nan", [](Tick& t) { t.truth.ball.position.x() = not_a_number; }},
      {"a number is inf", [](Tick& t) { t.truth.ball.spin.z() = std::numeric_limits<double>::infinity(); }},
      {"a number is", [](Tick& t) { t.truth.robots[0].position.y() = -1000; }},
      {"a number is nan", [](Tick& t) { t.truth.robots[0].orientation = not_a_number; }},
      {"no robot 16", [](Tick& t) { t.truth.robots[0].id.number = 16; }},
      {"no robot 255", [](Tick& t) { t.truth.contacts[0].robot.number = 255; }},
      {"no robot 17", [](Tick& t) { t.truth.kicks[0].robot.number = 17; }},
      {"no team 2", [](Tick& t) { t.truth.kicks[0].robot.team = static_cast<Team>(2); }},
      {"not in order", [](Tick& t) { t.truth.robots[1] = t.truth.robots[0]; }},
      {"there are 33", [](Tick& t) { t.truth.robots.resize(33); }},
      {"there are 65535", [](Tick& t) { t.truth.contacts.resize(65'535); }},
      {"an instant", [](Tick& t) { t.truth.contacts[0].time = world::Time::min(); }},
      {"an instant", [](Tick& t) { t.images[0].t_capture = world::Time::max(); }},
      {"no camera -1", [](Tick& t) { t.images[0].camera = -1; }},
      {"no camera 256", [](Tick& t) { t.images[0].camera = 256; }},
      {"there are 257", [](Tick& t) { t.images.resize(257); }},
      {"there are 2000", [](Tick& t) { t.images[0].balls.resize(2000); }},
      {"a place is nan", [](Tick& t) { t.images[0].balls[0].position.x() = not_a_number; }},
      {"a place is", [](Tick& t) { t.images[0].robots[0].position.x() = 1e9; }},
      {"no robot 16", [](Tick& t) { t.images[0].robots[0].number = 16; }},
      {"an angle is", [](Tick& t) { t.images[0].robots[0].orientation = 1e30; }},
  };
  for (const auto& [what, change] : changes) {
    EXPECT_THAT(complaint(change), AllOf(HasSubstr("it.judged: "), HasSubstr(what), HasSubstr("at byte ")))
        << what;
  }
}

TEST_F(Recording, NoticesEveryFlippedBit) {
  ASSERT_EQ(complaint(good()), "");
  const std::filesystem::path file = path();
  std::ifstream stream(file, std::ios::binary);
  const std::string right((std::istreambuf_iterator<char>(stream)), {});
  for (std::size_t bit = 0; bit < 8 * right.size(); ++bit) {
    std::string wrong = right;
    wrong[bit / 8] = static_cast<char>(wrong[bit / 8] ^ (1 << (bit % 8)));
    std::ofstream(file, std::ios::trunc | std::ios::binary) << wrong;
    EXPECT_THAT(read(), HasSubstr("it.judged: ")) << "bit " << bit % 8 << " of byte " << bit / 8;
  }
}

TEST_F(Recording, EndsWhereItSays) {
  EXPECT_THAT(complaint(good(), 5), HasSubstr("ended at tick 5"));
  EXPECT_THAT(complaint(good(), 2, "x"), HasSubstr("something follows the end"));
}

}  // namespace
}  // namespace judge
