// Plays games in this process and prints what the football was like: the tool for tuning the teams.
//
//   team_watch games=8 half=600 seed=1 realism=measured yellow="reference defenders=2 speed=0.5" blue=chaser
//   team_watch games=1 seed=3 trace=10:20
//
// Beside the score it says how long each kind of restart took from the referee's signal to the kick, and how
// much of the time in play the ball rested with nobody touching it. goals=on tells of every goal the kick
// before it and where the other side's robots near the goal were then.
//
// A side is a team (reference, longball, rough, chaser, none), then its parameters as name=value, and
// robots=N or speed=FACTOR.

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

#include "experiments/host/tally.h"
#include "experiments/statistics/observer.h"
#include "teams/chaser/chaser.h"
#include "teams/longball/longball.h"
#include "teams/reference/reference_team.h"
#include "teams/rough/rough_team.h"
#include "tests/teams/support/arena.h"

namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

std::pair<std::string, std::string> split(const std::string& text) {
  const std::size_t at = text.find('=');
  if (at == std::string::npos) throw std::invalid_argument(text + " is not name=value");
  return {text.substr(0, at), text.substr(at + 1)};
}

void set_all(const kit::Flags& flags, const Settings& settings) {
  for (const auto& [name, value] : settings) {
    if (const auto problem = flags.set(name, value)) throw std::invalid_argument(name + " " + *problem);
  }
}

support::Side side(const std::string& text, bool notes) {
  std::istringstream words(text);
  std::string team, word;
  words >> team;
  support::Side s;
  if (team == "none") return s;
  Settings settings;
  while (words >> word) {
    const auto [name, value] = split(word);
    if (name == "robots") {
      s.robots.resize(static_cast<std::size_t>(std::stoi(value)));
    } else if (name == "speed") {
      s.speed_factor = std::stod(value);
    } else {
      settings.emplace_back(name, value);
    }
  }
  kit::Flags flags;
  if (team == "chaser") {
    s.make = [](const kit::Setup&) { return std::make_unique<chaser::Chaser>(); };
    return s;
  }
  reference::Parameters parameters;
  rough::Rudeness rudeness;
  longball::Style style;
  reference::declare(flags, parameters);
  if (team == "reference") {
    set_all(flags, settings);
    s.make = [parameters, notes](const kit::Setup& setup) {
      return std::make_unique<reference::ReferenceTeam>(setup, parameters, notes);
    };
  } else if (team == "rough") {
    rough::declare(flags, rudeness);
    set_all(flags, settings);
    s.make = [parameters, rudeness, notes](const kit::Setup& setup) {
      return rough::make_team(setup, parameters, rudeness, notes);
    };
  } else if (team == "longball") {
    longball::declare(flags, style);
    set_all(flags, settings);
    s.make = [parameters, style, notes](const kit::Setup& setup) {
      return longball::make_team(setup, parameters, style, notes);
    };
  } else {
    throw std::invalid_argument(team + " is no team known here");
  }
  return s;
}

// How long restarts take, by the referee's word for them; and waste in play.
struct Restarts {
  struct Kind {
    int taken = 0;
    int late = 0;  // never kicked
    double sum = 0, longest = 0;
  };
  std::map<std::string, Kind> kinds;
  double ready_for = 0;  // [s] stoppage until the signal, all together
  double still = 0;      // [s] in play, ball at rest with nobody at it

  void update(const world::GameState& state, const truth::Frame& truth) {
    const double now = world::seconds(truth.time);
    if (state.location == world::Location::Setup && before_ != world::Location::Setup) since_ = now;
    if (state.location == world::Location::GameOff) ready_for += world::tick_length;
    if (before_ == world::Location::Setup && state.location != world::Location::Setup) {
      Kind& kind = kinds[word_];
      if (state.location == world::Location::GameOn) {
        kind.taken += 1;
        kind.sum += now - since_;
        kind.longest = std::max(kind.longest, now - since_);
      } else {
        kind.late += 1;
      }
    }
    if (state.location == world::Location::GameOn && truth.ball.velocity.norm() < 0.05 &&
        std::none_of(truth.robots.begin(), truth.robots.end(),
                     [](const truth::Robot& robot) { return robot.ball_contact; })) {
      still += world::tick_length;
    }
    if (state.location == world::Location::Setup) word_ = world::name(state.restart);
    before_ = state.location;
  }
  void print(int games) const {
    std::printf(
        "a game: %.0f s waiting for the signal, %.1f s the ball at rest in play; from signal to kick [s]:",
        ready_for / games, still / games);
    for (const auto& [word, kind] : kinds) {
      std::printf("  %s %d, mean %.1f, longest %.1f, never %d;", word.c_str(), kind.taken,
                  kind.taken > 0 ? kind.sum / kind.taken : 0, kind.longest, kind.late);
    }
    std::printf("\n");
  }

 private:
  world::Location before_ = world::Location::Init;
  std::string word_;
  double since_ = 0;
};

// The last kick and who stood where, for the story of a goal.
struct Story {
  truth::Kick kick;
  std::vector<truth::Robot> robots;
  double time = -9;

  void tell(double now) const {
    const double side = kick.velocity.x() < 0 ? -1 : 1;  // seen towards +x
    const auto x = [side](const auto& v) { return side * v.x(); };
    const auto y = [side](const auto& v) { return side * v.y(); };
    std::printf("  GOAL at %.2f: %s %d kicked %.2f s before from (%.2f %.2f) with (%.2f %.2f %.2f);", now,
                world::name(kick.robot.team), kick.robot.number, now - time, x(kick.position),
                y(kick.position), x(kick.velocity), y(kick.velocity), kick.velocity.z());
    for (const truth::Robot& robot : robots) {
      if (robot.id.team == kick.robot.team) continue;
      std::printf(" %d(%.2f %.2f)", robot.id.number, x(robot.position), y(robot.position));
    }
    std::printf("\n");
  }
};

}  // namespace

int main(int argc, char** argv) try {
  std::map<std::string, std::string> given{{"games", "1"},          {"half", "600"},       {"seed", "1"},
                                           {"yellow", "reference"}, {"blue", "reference"}, {"trace", ""},
                                           {"realism", "measured"}, {"calls", "off"},      {"goals", "off"}};
  for (int i = 1; i < argc; ++i) {
    const auto [name, value] = split(argv[i]);
    if (given.count(name) == 0) throw std::invalid_argument(name + " has no meaning here");
    given[name] = value;
  }
  const int games = std::stoi(given["games"]);
  const double half = std::stod(given["half"]);
  const int first_seed = std::stoi(given["seed"]);
  double trace_from = -1, trace_to = -1;
  std::sscanf(given["trace"].c_str(), "%lf:%lf", &trace_from, &trace_to);
  const bool notes = trace_from >= 0;

  std::map<std::string, std::array<int, 2>> events;
  std::map<std::string, int> rows;
  int all_calls = 0;
  Restarts restarts;
  record::MatchStatistics all;
  int yellow_goals = 0, blue_goals = 0, wins = 0, losses = 0;
  for (int game = 0; game < games; ++game) {
    support::Arena arena(side(given["yellow"], notes), side(given["blue"], notes),
                         static_cast<std::uint64_t>(first_seed + game), given["realism"].c_str());
    arena.start_referee(world::from_seconds(half));
    statistics::Observer observer(arena.engine().model().geometry);
    Story story;
    std::int64_t in_play = 0;
    std::array<int, 2> kicks{};
    double longest = 0, since = 0;
    while (arena.tick() && world::seconds(arena.engine().time()) < 2400) {
      const double now = world::seconds(arena.engine().time());
      const bool on = arena.referee()->state().location == world::Location::GameOn;
      in_play += on;
      if (!on) since = now;
      longest = std::max(longest, now - since);
      for (const truth::Kick& kick : arena.engine().truth().kicks) {
        kicks[static_cast<std::size_t>(kick.robot.team)] += 1;
        story = {kick, arena.engine().truth().robots, now};
      }
      observer.update(arena.engine().truth(), arena.referee()->state());
      restarts.update(arena.referee()->state(), arena.engine().truth());
      const bool tracing = now >= trace_from && now <= trace_to;
      for (const referee::Call& call : arena.calls()) {
        rows[call.row] += 1;
        if (call.offender && call.event) {
          events[host::name(*call.event)][static_cast<std::size_t>(call.offender->team)] += 1;
        }
        all_calls += call.stops_play || call.offender;
        if (given["goals"] == "on" && call.row == "T11.1") story.tell(now);
        if (tracing || given["calls"] == "on") std::printf("%s\n", referee::format_call(call).c_str());
      }
      if (tracing) {
        const truth::Ball& ball = arena.engine().truth().ball;
        for (const truth::Kick& kick : arena.engine().truth().kicks) {
          std::printf("  KICK %s %d  v %.2f %.2f %.2f\n", world::name(kick.robot.team), kick.robot.number,
                      kick.velocity.x(), kick.velocity.y(), kick.velocity.z());
        }
        if (arena.engine().tick() % 12 == 0) {
          std::printf("%.2f ball %.2f %.2f v %.2f %.2f\n", now, ball.position.x(), ball.position.y(),
                      ball.velocity.x(), ball.velocity.y());
          for (const world::Team team : world::both_teams) {
            if (arena.team(team) == nullptr) continue;
            const std::string_view note = arena.team(team)->note();
            std::printf("   %s: %.*s\n     ", world::name(team), static_cast<int>(note.size()), note.data());
            for (const truth::Robot& robot : arena.engine().truth().robots) {
              if (robot.id.team != team) continue;
              std::printf(" %d(%.2f %.2f %.0f%s)", robot.id.number, robot.position.x(), robot.position.y(),
                          robot.orientation * 57.3, robot.ball_contact ? " B" : "");
            }
            std::printf("\n");
          }
        }
      }
    }
    observer.finish();
    const record::MatchStatistics counted = observer.result();
    all.time += counted.time;
    all.in_play += counted.in_play;
    for (const world::Team team : world::both_teams) {
      all.teams[team].shots += counted.teams[team].shots;
      all.teams[team].shots_on_target += counted.teams[team].shots_on_target;
      all.teams[team].saves += counted.teams[team].saves;
      all.teams[team].passes += counted.teams[team].passes;
      all.teams[team].passes_completed += counted.teams[team].passes_completed;
    }
    const world::GameState& state = arena.referee()->state();
    const double length = world::seconds(arena.engine().time());
    const auto ticks = static_cast<double>(arena.engine().tick());
    std::printf(
        "seed %d: %d:%d (yellow:blue) in %.0f s, in play %.0f %%, longest %.0f s, kicks %d %d, %.1f "
        "us/tick/team\n",
        first_seed + game, state.score.yellow, state.score.blue, length,
        100 * static_cast<double>(in_play) / ticks, longest, kicks[0], kicks[1],
        arena.thinking_seconds() / ticks / 2 * 1e6);
    std::fflush(stdout);
    yellow_goals += state.score.yellow;
    blue_goals += state.score.blue;
    wins += state.score.yellow > state.score.blue;
    losses += state.score.yellow < state.score.blue;
  }
  std::printf("goals %d:%d, yellow wins %d, draws %d, losses %d\ncalls per game:", yellow_goals, blue_goals,
              wins, games - wins - losses, losses);
  for (const auto& [row, count] : rows)
    std::printf("  %s %.1f", row.c_str(), static_cast<double>(count) / games);
  std::printf("\nin play %.1f %%", 100 * all.in_play / all.time);
  for (const world::Team team : world::both_teams) {
    const record::TeamStatistics& t = all.teams[team];
    std::printf("; %s %d shots, %d on target, %d saves, %d of %d passes", world::name(team), t.shots,
                t.shots_on_target, t.saves, t.passes_completed, t.passes);
  }
  std::printf("\n");
  restarts.print(games);
  int offences = 0;
  for (const auto& [name, count] : events) offences += count[0] + count[1];
  std::printf("%d calls that stop play or name an offender, %d offences", all_calls, offences);
  for (const auto& [name, count] : events)
    std::printf("\n  %-34s yellow %d  blue %d", name.c_str(), count[0], count[1]);
  std::printf("\n");
} catch (const std::exception& error) {
  std::cerr << "team_watch: " << error.what() << "\n";
  return 2;
}
