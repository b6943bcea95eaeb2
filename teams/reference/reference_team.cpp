#include "teams/reference/reference_team.h"

#include <algorithm>
#include <cstdio>

#include "teams/reference/defense.h"
#include "teams/reference/goalie.h"
#include "teams/reference/restart.h"

namespace reference {
namespace {

using kit::Phase;

bool is_dead(Phase phase) { return phase == Phase::Stop || phase == Phase::Timeout || phase == Phase::Halt; }

bool is_kickoff(Phase phase) { return phase == Phase::PrepareKickoff || phase == Phase::Kickoff; }

bool is_penalty(Phase phase) { return phase == Phase::PreparePenalty || phase == Phase::Penalty; }

// Places are chosen for this long, then only walked to [s].
constexpr double choose_places_for = 1.5;

}  // namespace

void ReferenceTeam::play(const kit::View& real, world::TeamCommands& out) {
  const kit::View& view = with_ball_in_place(real);
  const kit::Game& game = view.game;
  const bool ball_jumped = (view.ball.position - phase_ball_).norm() > 0.3 && game.phase != Phase::Running;
  if (game.phase != phase_ || ball_jumped) {
    if (game.phase != phase_ || is_dead(game.phase)) places_.fill({});
    phase_ = game.phase;
    phase_began_ = view.time;
    phase_ball_ = view.ball.position;
    if (game.phase != Phase::Running) winner_.forget();
  }

  const Situation& situation = observer_.observe(view);
  Possession possession = situation.possession;
  if (game.phase != Phase::Running) possession = game.ours ? Possession::Ours : Possession::Theirs;
  if (is_dead(game.phase)) possession = Possession::Contested;
  const int field_players = std::max(0, static_cast<int>(view.own.size()) - 1);
  const Formation shape = formation(field_players, possession, view.ball.position.x(), parameters_);
  std::optional<int> receiver;
  if (game.phase == Phase::Running) receiver = winner_.receiver(view);
  roles_ = assign_roles(view, situation, roles_, shape, receiver);
  defenders_ = 0;
  for (const kit::Robot& robot : view.own) {
    defenders_ += roles_.of(robot.number) == Role::Defender;
  }

  supports_tactic_.think(view, situation, roles_, parameters_);
  for (const kit::Robot& robot : view.own) {
    skills::Order& order = orders_[robot.number];
    order = order_for(view, situation, robot);
    out.push_back(steering_.command(real, robot, order));
  }
  std::optional<Kick> kicked;
  if (roles_.winner >= 0 && orders_[static_cast<std::size_t>(roles_.winner)].kick_speed > 0) {
    kicked = winner_.choice();
  }
  telemetry_.update(view, situation, roles_, supports_tactic_.partition(), kicked);
  if (notes_) write_note(view, situation);
}

// While the ball is dead it is going to be placed: everything is planned for where it will lie.
const kit::View& ReferenceTeam::with_ball_in_place(const kit::View& view) {
  if (!is_dead(view.game.phase) || !view.game.designated_position) return view;
  dead_ball_view_ = view;
  dead_ball_view_.ball.position = *view.game.designated_position;
  dead_ball_view_.ball.velocity = Vector2d::Zero();
  dead_ball_view_.ball.height = 0;
  return dead_ball_view_;
}

skills::Order ReferenceTeam::order_for(const kit::View& view, const Situation& situation,
                                       const kit::Robot& robot) {
  const kit::Game& game = view.game;
  skills::Order order;
  switch (roles_.of(robot.number)) {
    case Role::Goalie:
      order = is_penalty(game.phase) && !game.ours ? face_penalty(view, robot)
                                                   : play_goalie(view, situation, robot);
      break;
    case Role::Winner:
      order = winner_order(view, situation, robot);
      break;
    case Role::Support:
      order = game.forbidden == robot.number && game.phase == Phase::Running
                  ? leave_ball(view, robot)
                  : supports_tactic_.play(view, robot);
      break;
    case Role::Defender:
      order = game.forbidden == robot.number && game.phase == Phase::Running
                  ? leave_ball(view, robot)
                  : play_defender(view, situation, robot, roles_.index[robot.number], defenders_);
      break;
    case Role::None:
      break;
  }

  const bool kicker = roles_.winner == robot.number && game.ours;
  const bool goalie = roles_.goalie == robot.number;
  if (game.phase == Phase::Running) return order;
  if (is_dead(game.phase)) {
    // The ball on the centre mark: most likely a kickoff, so be at home already.
    if (view.ball.position.norm() < 0.1 && !goalie) stay_in_own_half(robot, order);
    keep_away(view, robot, parameters_, true, order);
    hold_place(view, robot, order);
    return order;
  }
  if (is_kickoff(game.phase) && !(kicker && game.phase == Phase::Kickoff)) stay_in_own_half(robot, order);
  if (is_penalty(game.phase) && !kicker && !goalie) stay_behind_penalty_line(view, robot, order);
  if (kicker) {
    // The penalty mark lies on the edge of their area; the kicker may go there (Law 9 speaks of team-mates).
    order.their_area = is_penalty(game.phase) ? -0.3 : 0.25;
    return order;
  }
  if (game.ours) {
    order.ball_distance = std::max(order.ball_distance, 0.3);
    order.their_area = 0.25;
    order.kick_speed = 0;
  } else if (!(goalie && is_penalty(game.phase))) {
    keep_away(view, robot, parameters_, false, order);
  }
  if (game.phase == Phase::PrepareKickoff || game.phase == Phase::PreparePenalty)
    hold_place(view, robot, order);
  return order;
}

skills::Order ReferenceTeam::winner_order(const kit::View& view, const Situation& situation,
                                          const kit::Robot& robot) {
  const kit::Game& game = view.game;
  if (is_dead(game.phase) || (game.phase != Phase::Running && !game.ours)) {
    return block_the_ball(view, robot, parameters_);
  }
  KickRules rules;
  rules.targets = supports_tactic_.targets();
  switch (game.phase) {
    case Phase::PrepareKickoff:
    case Phase::PreparePenalty:
      return wait_behind_ball(view, robot);
    case Phase::Kickoff:
      rules.must_kick = true;
      rules.must_go_forward = true;
      return winner_.play(view, situation, robot, rules, parameters_);
    case Phase::Penalty:
      return take_penalty(view, robot, parameters_);
    case Phase::DirectFree:
    case Phase::IndirectFree: {
      if (game.age < parameters_.kick_delay) return wait_behind_ball(view, robot);
      rules.must_kick = true;
      rules.shot_allowed = game.phase == Phase::DirectFree;
      return winner_.play(view, situation, robot, rules, parameters_);
    }
    default:
      break;
  }
  // The ball is in the goalie's hands: wait outside for what comes out.
  const double in_area =
      world::distance_to_defense_area(view.field(), world::Side::Negative, view.ball.position);
  if (in_area < 0 && view.ball.velocity.norm() < 1.5) {
    skills::Order order;
    order.why = "wait for goalie";
    order.target =
        world::moved_out_of_defense_area(view.field(), world::Side::Negative, view.ball.position, 0.5);
    order.heading = world::angle_of(view.ball.position - robot.position);
    return order;
  }
  rules.shot_allowed = !game.indirect;
  return winner_.play(view, situation, robot, rules, parameters_);
}

// The first 1.5 s choose a place, then it is kept: a formation that goes on moving would keep the referee
// waiting.
void ReferenceTeam::hold_place(const kit::View& view, const kit::Robot& robot, skills::Order& order) {
  std::optional<Vector2d>& place = places_[robot.number];
  const bool still_choosing = view.time - phase_began_ < choose_places_for;
  if (!place || (still_choosing && (order.target - *place).norm() > 0.3)) place = order.target;
  order.target = *place;
}

void ReferenceTeam::write_note(const kit::View& view, const Situation& situation) {
  std::array<char, 128> line;
  std::snprintf(line.data(), line.size(), "%s%s %s", kit::name(view.game.phase),
                view.game.ours ? " (ours)" : "", name(situation.possession));
  note_ = line.data();
  for (const kit::Robot& robot : view.own) {
    const skills::Order& order = orders_[robot.number];
    std::snprintf(line.data(), line.size(), "; %d %s: %s", robot.number, name(roles_.of(robot.number)),
                  order.why);
    note_ += line.data();
  }
  if (winner_.choice()) {
    std::snprintf(line.data(), line.size(), "; %s %.2f", name(winner_.choice()->kind),
                  winner_.choice()->value);
    note_ += line.data();
  }
}

}  // namespace reference
