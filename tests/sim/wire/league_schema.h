#pragma once

#include <google/protobuf/message.h>

#include <map>
#include <string>
#include <vector>

namespace league {

struct Field {
  int number = 0;
  std::string name;
  std::string type;   ///< scalar type, or the league's name of message or enum
  std::string label;  ///< required, optional or repeated
  std::string oneof;
  std::string default_value;
  bool packed = false;
  bool deprecated = false;
};

/// The schemas of one repository of the league.
struct Family {
  std::map<std::string, std::vector<Field>> messages;
  std::map<std::string, std::map<std::string, int>> enums;
};

/// Identifiers, numbers, types and labels of the league's schemas, by repository
/// (tests/sim/data/protocol-fields.json).
const std::map<std::string, Family>& families();

/// Our name of a message or enum in the league's terms: without our package.
std::string league_name(const std::string& full_name);

/// The fields that the league requires in a message (and in the messages inside it) but that are not set.
std::vector<std::string> missing_required(const google::protobuf::Message& message,
                                          const std::string& family);

}  // namespace league
