#include "teams/reference/telemetry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace reference {
namespace {

double share(double part, double whole) { return whole > 0 ? part / whole : 0; }

}  // namespace

double Telemetry::Counts::completion() const { return share(completed, passes); }

double Telemetry::Counts::possession_share() const {
  return share(static_cast<double>(ticks_ours), static_cast<double>(ticks_ours + ticks_theirs));
}

double Telemetry::Counts::zone_entropy() const {
  const auto all = static_cast<double>(std::accumulate(in_zone.begin(), in_zone.end(), std::int64_t{0}));
  double entropy = 0;
  for (const std::int64_t ticks : in_zone) {
    const double p = share(static_cast<double>(ticks), all);
    if (p > 0) entropy -= p * std::log2(p);
  }
  return entropy;
}

void Telemetry::follow_pass(const kit::View& view) {
  const auto has_ball = [&view](const kit::Robot& robot) {
    return kit::holds_ball(robot, view.ball, view.field().ball_radius);
  };
  if (view.game.phase != kit::Phase::Running || view.time - flight_->at > 4) {
    flight_.reset();
    return;
  }
  if (view.time - flight_->at < 0.08) return;  // the ball is still leaving the kicker
  for (const kit::Robot& robot : view.own) {
    if (!has_ball(robot)) continue;
    if (robot.number != flight_->kicker && flight_->kind == Kick::Kind::Pass) {
      counts_.completed += 1;
      received_at_ = view.time;
    }
    flight_.reset();
    return;
  }
  if (std::any_of(view.opponents.begin(), view.opponents.end(), has_ball)) {
    counts_.intercepted += flight_->kind == Kick::Kind::Pass;
    flight_.reset();
  }
}

void Telemetry::update(const kit::View& view, const Situation& situation, const Roles& roles,
                       const Partition& partition, const std::optional<Kick>& kicked) {
  if (view.game.own_score > score_) {
    counts_.goals += 1;
    counts_.goals_after_pass += view.time - received_at_ < 4 + view.game.age;
  }
  score_ = view.game.own_score;
  if (flight_) follow_pass(view);

  // The kick itself: armed a moment ago, and now the ball is fast.
  const double speed = view.ball.velocity.norm();
  if (armed_ && view.time - armed_at_ < 0.15 && speed > speed_before_ + 0.8) {
    if (flight_ && flight_->kind == Kick::Kind::Pass && flight_->kicker != armed_robot_) {
      counts_.completed += 1;  // taken and played on at the first touch
      received_at_ = view.time;
      counts_.redirects += armed_->kind == Kick::Kind::Shot;
    }
    counts_.passes += armed_->kind == Kick::Kind::Pass;
    counts_.shots += armed_->kind == Kick::Kind::Shot;
    counts_.clearances += armed_->kind == Kick::Kind::Clear;
    flight_ = Flight{armed_->kind, armed_robot_, view.time};
    armed_.reset();
  }
  if (kicked) {
    armed_ = kicked;
    armed_at_ = view.time;
    armed_robot_ = roles.winner;
  }
  speed_before_ = speed;

  if (view.game.phase != kit::Phase::Running) return;
  counts_.ticks_ours += situation.possession == Possession::Ours;
  counts_.ticks_theirs += situation.possession == Possession::Theirs;
  for (const kit::Robot& robot : view.own) {
    if (roles.of(robot.number) != Role::Support) continue;
    counts_.in_zone[static_cast<std::size_t>(index_of(partition.zone_of(robot.position)))] += 1;
  }
}

std::string Telemetry::summary() const {
  const Counts& c = counts_;
  std::array<char, 256> line;
  std::snprintf(line.data(), line.size(),
                "passes %d, completed %d (%.0f %%), intercepted %d, shots %d, at the first touch %d, "
                "clearances %d, goals %d, after a pass %d, possession %.2f, zone entropy %.2f bit",
                c.passes, c.completed, 100 * c.completion(), c.intercepted, c.shots, c.redirects,
                c.clearances, c.goals, c.goals_after_pass, c.possession_share(), c.zone_entropy());
  return line.data();
}

}  // namespace reference
