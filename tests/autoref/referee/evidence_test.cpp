#include "autoref/referee/evidence.h"

#include <gmock/gmock.h>
#include <google/protobuf/struct.pb.h>
#include <google/protobuf/util/json_util.h>
#include <gtest/gtest.h>

namespace referee {
namespace {

using world::Team;

world::TrackedFrame frame_at(double seconds, double x) {
  world::TrackedFrame frame;
  frame.time = world::Time{world::from_seconds(seconds)};
  frame.ball.emplace();
  frame.ball->position = {x, 0, 0};
  frame.robots.push_back({.id = {Team::Blue, 3}, .position = {0.5, 0}});
  frame.robots.push_back({.id = {Team::Yellow, 1}, .position = {-4, 2}});
  return frame;
}

TEST(Evidence, TellsTheLastSecondsThresholdsAndAlternatives) {
  Evidence evidence;
  for (int i = 0; i < 600; ++i) {
    world::TrackedFrame frame = frame_at(i / 60.0, 0.001 * i);
    if (i == 550) {
      frame.touches.push_back({{Team::Blue, 3}, frame.time, {0.5, 0}, 0.8, world::RobotId{Team::Yellow, 2}});
    }
    evidence.remember(frame);
  }
  Call call;
  call.time = world::Time{world::from_seconds(599 / 60.0)};
  call.row = "T11.7";
  call.sentence = "a \"sentence\"";
  call.event = world::GameEvent{call.time, world::BallLeftFieldTouchLine{}};
  automaton::Occurrence taken = automaton::occurrence_of(*call.event);
  automaton::Occurrence other = automaton::occurrence_of({call.time, world::NoProgressInGame{}});
  const std::vector<automaton::Occurrence> occurrences{taken, other};
  const std::string line = evidence.record(call, world::rule_set("ssl-2015"), {}, occurrences);

  EXPECT_EQ(line.find('\n'), std::string::npos);
  google::protobuf::Struct json;
  ASSERT_TRUE(google::protobuf::util::JsonStringToMessage(line, &json).ok()) << line;
  const auto& fields = json.fields();
  EXPECT_EQ(fields.at("sentence").string_value(), "a \"sentence\"");
  EXPECT_EQ(fields.at("thresholds").struct_value().fields().at("exit_frames").number_value(), 3);
  ASSERT_EQ(fields.at("alternatives").list_value().values_size(), 1);
  ASSERT_EQ(fields.at("touches").list_value().values_size(), 1);
  const auto& touch = fields.at("touches").list_value().values(0).struct_value().fields();
  EXPECT_EQ(touch.at("robot").string_value(), "blue 3");
  EXPECT_EQ(touch.at("rival").string_value(), "yellow 2");
  // Ten times a second over 3 s, both ends.
  const auto& ball = fields.at("ball").list_value();
  EXPECT_EQ(ball.values_size(), 31);
  EXPECT_NEAR(ball.values(30).list_value().values(1).number_value(), 0.599, 1e-9);
  EXPECT_NEAR(ball.values(0).list_value().values(0).number_value(), 599 / 60.0 - 3, 0.002);
  // Only who was near the ball.
  EXPECT_TRUE(fields.at("robots").struct_value().fields().contains("blue 3"));
  EXPECT_FALSE(fields.at("robots").struct_value().fields().contains("yellow 1"));
}

}  // namespace
}  // namespace referee
