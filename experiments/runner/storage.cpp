#include "experiments/runner/storage.h"

namespace runner {

std::optional<std::string> Storage::look_first() {
  if (disk_.look(DiskWatch::Clock::now(), true) != DiskWatch::News::Full) return std::nullopt;
  return disk_.sentence() + "; make room and start again";
}

std::optional<std::string> Storage::look(DiskWatch::Clock::time_point now, bool idle,
                                         const std::function<void(const std::string&)>& say) {
  switch (disk_.look(now, idle)) {
    case DiskWatch::News::None:
      break;
    case DiskWatch::News::Full:
      say(disk_.sentence() + ": no game is started until there is more");
      break;
    case DiskWatch::News::Room:
      say("there is room on the disk again: going on");
      break;
    case DiskWatch::News::GiveUp:
      return disk_.sentence() + "; make room and start again, nothing is lost";
  }
  switch (writer_.look(now, idle)) {
    case LedgerWriter::News::None:
      break;
    case LedgerWriter::News::Blocked:
      say(writer_.sentence() + ": no game is started until it can be written");
      break;
    case LedgerWriter::News::Free:
      say("the ledger can be written again: going on");
      break;
    case LedgerWriter::News::GiveUp:
      return writer_.sentence() + "; free it and start again, games that are not in it are played again";
  }
  return std::nullopt;
}

std::optional<std::string> Storage::lost() {
  writer_.look(DiskWatch::Clock::now(), false);
  if (writer_.waiting() == 0) return std::nullopt;
  return writer_.sentence() + ": " + std::to_string(writer_.waiting()) +
         (writer_.waiting() == 1 ? " result was" : " results were") + " not written and will be made again";
}

}  // namespace runner
