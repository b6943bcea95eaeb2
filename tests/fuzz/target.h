#pragma once

#include <string_view>

/// One function per decoder of bytes from outside, named as its line in targets.txt, its file fuzz_NAME.cpp
/// and its folder corpus/NAME.
///
/// Each gives the bytes to the decoder, and what comes out to those who take it in the programs,
/// as far as that is bounded. What a decoder does not understand it must say the way its header promises;
/// anything else (another exception, an assert, a report of a sanitizer, a sentence that does not name
/// the file) is a finding.
///
/// @return whether the decoder understood the bytes
namespace fuzz {

bool channel(std::string_view bytes);        ///< the stream from a team
bool config_json(std::string_view bytes);    ///< a game's configuration, in ledgers and recordings
bool design(std::string_view bytes);         ///< an experiment's TOML file
bool judged_game(std::string_view bytes);    ///< a game recorded by `matchday judge --keep`
bool judged_result(std::string_view bytes);  ///< what judging a game gave, games/*.jsonl
bool league_log(std::string_view bytes);     ///< a plain league log, refereed, watched and calibrated
bool league_log_gz(std::string_view bytes);  ///< a packed one, read to its end
bool realism(std::string_view bytes);        ///< a realism file of `ssl-sim`
bool record_json(std::string_view bytes);    ///< a game's result in the ledger
bool recording(std::string_view bytes);      ///< a game's replies: the file
bool recorded_game(std::string_view bytes);  ///< a game's replies: the messages in it, played
bool referee(std::string_view bytes);        ///< the referee's datagram
bool reported(std::string_view bytes);       ///< what an outside autoref reports
bool robot_control(std::string_view bytes);  ///< a datagram to `ssl-sim` for robots
bool simulator(std::string_view bytes);      ///< a datagram to `ssl-sim` for the simulator
bool snippet(std::string_view bytes);        ///< the expectation of a recorded scenario
bool vision(std::string_view bytes);         ///< a vision datagram

}  // namespace fuzz
