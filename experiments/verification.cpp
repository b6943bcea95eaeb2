#include "experiments/verification.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "sim/console/printable.h"

namespace commands {
namespace {

using Json = nlohmann::ordered_json;

std::size_t count_of(const Verification& all, GameAgain::Result result) {
  return static_cast<std::size_t>(std::count_if(
      all.games.begin(), all.games.end(), [&](const GameAgain& game) { return game.result == result; }));
}

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : "; ") + part;
  return text;
}

/// "2 of 3 sampled games"
std::string share(std::size_t count, const Verification& all) {
  return std::to_string(count) + " of " + counted(all.games.size(), "sampled game");
}

void tell(const std::string& what, const std::string& finding, std::ostream& out) {
  constexpr std::size_t column = 14;
  out << what << std::string(what.size() < column ? column - what.size() : 1, ' ')
      << console::printable(finding) << std::endl;
}

void tell_all(const std::string& what, const std::vector<std::string>& sentences, std::ostream& out) {
  for (std::size_t i = 0; i < std::min(sentences.size(), most_told); ++i) tell(what, sentences[i], out);
  if (sentences.size() > most_told) {
    tell(what, "and " + std::to_string(sentences.size() - most_told) + " more", out);
  }
}

Json first_of(const std::vector<std::string>& sentences) {
  Json list = Json::array();
  for (std::size_t i = 0; i < std::min(sentences.size(), most_told); ++i) list.push_back(sentences[i]);
  return list;
}

const char* name(GameAgain::Result result) {
  switch (result) {
    case GameAgain::Result::Same:
      return "same";
    case GameAgain::Result::Different:
      return "different";
    case GameAgain::Result::Unverified:
      return "unverified";
  }
  return "";
}

/// What was said of the games that were played again.
std::string about_games(const Verification& all) {
  if (all.wanted == 0) return "no game was played again, as asked for";
  if (all.finished == 0) return "no game is finished, so none was played again";
  return share(count_of(all, GameAgain::Result::Same), all) + " played again with the same hash";
}

}  // namespace

std::size_t Verification::damages() const {
  std::size_t sum = files.problems.size() + manifest_problems.size();
  for (const Rows& one : rows) sum += one.damaged.size();
  return sum + count_of(*this, GameAgain::Result::Different);
}

std::vector<std::string> unverified(const Verification& all) {
  std::vector<std::string> clauses;
  std::int64_t unknown = 0;
  for (const Verification::Rows& one : all.rows) unknown += one.unknown;
  if (unknown > 0) {
    clauses.push_back(counted(static_cast<std::size_t>(unknown), "row") +
                      " of the ledger without a checksum, by an older matchday");
  }
  if (!all.manifest) clauses.emplace_back("there is no manifest, so nobody can say which programs played");
  if (!all.unknown_design.empty()) clauses.push_back(all.unknown_design);
  const std::size_t left = count_of(all, GameAgain::Result::Unverified);
  if (left == 0) return clauses;
  std::vector<std::string> reasons;
  for (const GameAgain& game : all.games) {
    if (game.result != GameAgain::Result::Unverified) continue;
    if (std::find(reasons.begin(), reasons.end(), game.reason) == reasons.end())
      reasons.push_back(game.reason);
  }
  constexpr std::size_t most = 3;  // of them in the sentence; each game has its own line
  if (reasons.size() > most) reasons.resize(most);
  clauses.push_back(share(all.games.size() - left, all) + " could be compared: " + joined(reasons));
  return clauses;
}

ExitCode exit_code(const Verification& all) {
  if (all.damages() > 0) return storage;
  return unverified(all).empty() ? done : faults;
}

std::string verdict(const Verification& all) {
  const std::vector<std::string> missing = unverified(all);
  if (all.damages() > 0) {
    std::string text = "NOT as written: " + counted(all.damages(), "finding") + ", see above";
    if (!missing.empty()) text += "; not verified: " + joined(missing);
    return text;
  }
  if (missing.empty()) return "rows, files and manifest are as written; " + about_games(all);
  return "what could be verified is as written; NOT VERIFIED: " + joined(missing);
}

void tell_rows(const Verification::Rows& rows, std::ostream& out) {
  std::string text = std::to_string(rows.whole) + " as written";
  if (rows.unknown > 0) {
    text += ", " + std::to_string(rows.unknown) + " not known: without a checksum, by an older matchday";
  }
  if (!rows.damaged.empty()) text += ", DAMAGED " + std::to_string(rows.damaged.size());
  const std::string what = rows.table == "files" ? "files' rows" : rows.table;  // the files come next
  tell(what, text, out);
  tell_all(what, rows.damaged, out);
}

void tell_files(const Verification& all, std::ostream& out) {
  std::string text = std::to_string(all.files.whole) + " as written, " + std::to_string(all.files.unknown) +
                     " not known (unfinished games, or an older matchday)";
  if (!all.files.problems.empty()) text += ", DAMAGED " + std::to_string(all.files.problems.size());
  tell("files", text, out);
  tell_all("files", all.files.problems, out);
}

void tell_manifest(const Verification& all, std::ostream& out) {
  if (!all.manifest) tell("manifest", "there is none; nobody can say which programs played", out);
  if (!all.matchday.empty()) tell("made by", "matchday " + all.matchday + ", commit " + all.commit, out);
  tell_all("manifest", all.manifest_problems, out);
  if (all.manifest && all.manifest_problems.empty() && all.unknown_design.empty()) {
    tell("manifest", "design, protocol and programs make experiment " + all.experiment, out);
  }
  for (const Verification::Program& one : all.programs) tell("program", one.path + ": " + one.state, out);
}

void tell_game(const GameAgain& game, std::ostream& out) {
  const std::string how = game.from_replies ? "from its recorded replies" : "from its seed";
  switch (game.result) {
    case GameAgain::Result::Same:
      return tell(game.game, "played again " + how + ": the same hash", out);
    case GameAgain::Result::Different:
      return tell(game.game, "played again " + how + ": NOT the same: " + game.reason, out);
    case GameAgain::Result::Unverified:
      return tell(game.game, "not verified: " + game.reason, out);
  }
}

void tell_verdict(const Verification& all, std::ostream& out) { tell("verdict", verdict(all), out); }

std::string to_json(const Verification& all) {
  Json json;
  json["folder"] = all.folder;
  for (const Verification::Rows& one : all.rows) {
    json["rows"][one.table] = {{"as_written", one.whole},
                               {"not_known", one.unknown},
                               {"damaged", one.damaged.size()},
                               {"findings", first_of(one.damaged)}};
  }
  json["files"] = {{"as_written", all.files.whole},
                   {"not_known", all.files.unknown},
                   {"damaged", all.files.problems.size()},
                   {"findings", first_of(all.files.problems)}};
  json["manifest"] = {{"there", all.manifest},
                      {"matchday", all.matchday},
                      {"commit", all.commit},
                      {"experiment", all.experiment},
                      {"damaged", all.manifest_problems.size()},
                      {"findings", first_of(all.manifest_problems)}};
  json["programs"] = Json::array();
  for (const Verification::Program& one : all.programs) {
    json["programs"].push_back({{"path", one.path}, {"state", one.state}});
  }
  json["games"] = {{"wanted", all.wanted},
                   {"finished", all.finished},
                   {"sampled", all.games.size()},
                   {"same", count_of(all, GameAgain::Result::Same)},
                   {"different", count_of(all, GameAgain::Result::Different)},
                   {"unverified", count_of(all, GameAgain::Result::Unverified)},
                   {"list", Json::array()}};
  for (const GameAgain& game : all.games) {
    json["games"]["list"].push_back({{"game", game.game},
                                     {"attempt", game.attempt},
                                     {"from", game.from_replies ? "replies" : "seed"},
                                     {"result", name(game.result)},
                                     {"reason", game.reason}});
  }
  json["damages"] = all.damages();
  json["unverified"] = unverified(all);
  json["verdict"] = verdict(all);
  json["exit_code"] = static_cast<int>(exit_code(all));
  // A path may hold bytes that are no UTF-8.
  return console::printable_json(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace commands
