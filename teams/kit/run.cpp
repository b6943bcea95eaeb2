#include "teams/kit/run.h"

#include <cstdlib>
#include <exception>
#include <iostream>

#include "teams/kit/channel.h"
#include "teams/kit/tick_times.h"

namespace kit {

int run(int argc, char** argv, Info info, const MakeTeam& make_team) {
  Session::Options options{info.name, info.version, {}, false};
  int keeper = -1;
  info.flags.add("keeper", keeper, -1, 15, "number of the goalkeeper; -1 leaves the choice to the team");
  info.flags.add("notes", options.notes, "add what each robot is doing to every reply, for whoever looks on");
  bool timing = false;
  info.flags.add("timing", timing, "say at the end how much processor time the ticks took");
  if (const auto code = info.flags.parse(argc, argv, info.name, info.description)) return *code;
  if (keeper >= 0) options.keeper = keeper;

  const char* path = std::getenv("MATCHDAY_SOCKET");
  if (path == nullptr || *path == '\0') {
    std::cerr
        << info.name
        << ": MATCHDAY_SOCKET is not set; a host starts this program, for example: matchday play --blue "
        << info.name << "\n";
    return 2;
  }
  try {
    Channel channel(Channel::connect(path));
    Session session(options, make_team);
    TickTimes times;
    while (!session.over()) {
      const auto payload = channel.read();
      if (!payload) {
        std::cerr << info.name << ": the host closed the channel without a goodbye\n";
        return 1;
      }
      const bool timed = timing && session.greeted();
      const double begin = timed ? thread_seconds() : 0;
      const std::string_view answer = session.answer(*payload);
      if (timed && !session.over()) times.add(thread_seconds() - begin);
      channel.write(answer);
    }
    if (timing) std::cout << times.line() << "\n";
    if (const std::string summary = session.summary(); !summary.empty()) std::cout << summary << "\n";
    return 0;
  } catch (const std::exception& error) {
    std::cerr << info.name << ": " << error.what() << "\n";
    return 1;
  }
}

}  // namespace kit
