// Our own descriptions against the facts about the league's: nothing else, nothing more, nothing missing.
//
// Where we differ on purpose:
//  - A field that the league requires is optional in ours. Numbers and types are the same, and so are the
//    bytes; our reader accepts messages with gaps and unknown enum values, and our writers are tested for
//    setting them (`missing_required`).
//  - Packages. They never appear on the wire.
#include <gmock/gmock.h>
#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>

#include <set>
#include <sstream>

#include "sim/proto/autoref.pb.h"
#include "sim/proto/legacy2014.pb.h"
#include "sim/proto/match.pb.h"
#include "sim/proto/simulation_custom.pb.h"
#include "sim/proto/tracker.pb.h"
#include "tests/sim/wire/league_schema.h"

namespace {

using google::protobuf::Descriptor;
using google::protobuf::EnumDescriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::FileDescriptor;
using testing::IsEmpty;

const std::string vision = "ssl-vision HEAD";
const std::string game_controller = "ssl-game-controller HEAD";
const std::string tracker = "ssl-vision HEAD (tracker)";
const std::string simulation = "ssl-simulation-protocol HEAD";

/// One of our files and the family of the league it describes a part of.
struct Pair {
  const FileDescriptor* ours;
  std::string family;
};

std::vector<Pair> pairs() {
  return {{matchday::vision::SSL_WrapperPacket::descriptor()->file(), vision},
          {matchday::legacy2014::SSL_WrapperPacket::descriptor()->file(), vision},
          {matchday::referee::GameEvent::descriptor()->file(), game_controller},
          {matchday::referee::Referee::descriptor()->file(), game_controller},
          {matchday::referee::AutoRefToController::descriptor()->file(), game_controller},
          {matchday::tracker::TrackerWrapperPacket::descriptor()->file(), tracker},
          {matchday::simulation::RobotControl::descriptor()->file(), simulation}};
}

void collect(const Descriptor& message, std::vector<const Descriptor*>& messages,
             std::vector<const EnumDescriptor*>& enums) {
  messages.push_back(&message);
  for (int i = 0; i < message.enum_type_count(); ++i) enums.push_back(message.enum_type(i));
  for (int i = 0; i < message.nested_type_count(); ++i) collect(*message.nested_type(i), messages, enums);
}

struct Described {
  std::vector<const Descriptor*> messages;
  std::vector<const EnumDescriptor*> enums;
};

Described described(const FileDescriptor& file) {
  Described result;
  for (int i = 0; i < file.enum_type_count(); ++i) result.enums.push_back(file.enum_type(i));
  for (int i = 0; i < file.message_type_count(); ++i) {
    collect(*file.message_type(i), result.messages, result.enums);
  }
  return result;
}

/// The legacy messages carry the package of the league in the table of facts.
std::string without_legacy_package(const std::string& name) {
  for (const std::string package : {"RoboCup2014Legacy.Geometry.", "RoboCup2014Legacy.Wrapper."}) {
    if (name.starts_with(package)) return name.substr(package.size());
  }
  return name;
}

const std::vector<league::Field>* find_message(const Pair& pair, const Descriptor& message) {
  const auto& messages = league::families().at(pair.family).messages;
  const std::string name = league::league_name(message.full_name());
  for (const std::string package : {"RoboCup2014Legacy.Geometry.", "RoboCup2014Legacy.Wrapper."}) {
    if (message.file()->package() != "matchday.legacy2014") break;
    if (const auto found = messages.find(package + name); found != messages.end()) return &found->second;
  }
  const auto found = messages.find(name);
  return found == messages.end() ? nullptr : &found->second;
}

/// Vector2, Vector3 and Team of the game events stand in another file of the league, which the table leaves
/// out; the same messages are in the tables of the tracker and of the simulation protocol.
Pair home(const Pair& pair, const std::string& name) {
  if (pair.family != game_controller) return pair;
  if (name == "Vector2" || name == "Vector3") return {pair.ours, tracker};
  if (name == "Team") return {pair.ours, simulation};
  return pair;
}

std::string type_of(const FieldDescriptor& field) {
  if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
    return league::league_name(field.message_type()->full_name());
  }
  if (field.cpp_type() == FieldDescriptor::CPPTYPE_ENUM)
    return league::league_name(field.enum_type()->full_name());
  return field.type_name();
}

std::string default_of(const FieldDescriptor& field) {
  if (!field.has_default_value()) return "";
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_FLOAT: {
      std::ostringstream text;
      text << field.default_value_float();
      return text.str();
    }
    case FieldDescriptor::CPPTYPE_BOOL:
      return field.default_value_bool() ? "true" : "false";
    case FieldDescriptor::CPPTYPE_ENUM:
      return field.default_value_enum()->name();
    default:
      return "a default of a type that this test does not know";
  }
}

void expect_equal(const FieldDescriptor& ours, const league::Field& theirs) {
  SCOPED_TRACE(ours.full_name());
  EXPECT_EQ(ours.name(), theirs.name);
  EXPECT_EQ(ours.number(), theirs.number);
  EXPECT_EQ(type_of(ours), without_legacy_package(theirs.type));
  EXPECT_EQ(ours.is_repeated(), theirs.label == "repeated");
  EXPECT_FALSE(ours.is_required()) << "our reader must accept gaps";
  EXPECT_EQ(ours.is_packed(), theirs.packed);
  EXPECT_EQ(ours.options().deprecated(), theirs.deprecated);
  EXPECT_EQ(ours.containing_oneof() ? ours.containing_oneof()->name() : "", theirs.oneof);
  EXPECT_EQ(default_of(ours), theirs.default_value);
}

}  // namespace

TEST(ProtoSchema, EveryFieldIsTheLeagues) {
  int messages = 0;
  int fields = 0;
  for (const Pair& pair : pairs()) {
    for (const Descriptor* ours : described(*pair.ours).messages) {
      SCOPED_TRACE(ours->full_name());
      const std::vector<league::Field>* theirs = find_message(home(pair, ours->name()), *ours);
      ASSERT_NE(theirs, nullptr) << "not a message of " << pair.family;
      EXPECT_EQ(static_cast<std::size_t>(ours->field_count()), theirs->size());
      for (const league::Field& field : *theirs) {
        const FieldDescriptor* own = ours->FindFieldByNumber(field.number);
        ASSERT_NE(own, nullptr) << "field " << field.number << " " << field.name << " is missing";
        expect_equal(*own, field);
        ++fields;
      }
      ++messages;
    }
  }
  // Counted in the tables by hand: 13 vision, 3 legacy, 46 referee and events, 8 tracker, 22 simulation, and
  // the two vectors of the events.
  EXPECT_EQ(messages, 99);
  EXPECT_GT(fields, 400);
}

TEST(ProtoSchema, EveryEnumIsTheLeagues) {
  int enums = 0;
  for (const Pair& pair : pairs()) {
    for (const EnumDescriptor* ours : described(*pair.ours).enums) {
      SCOPED_TRACE(ours->full_name());
      const std::string name = league::league_name(ours->full_name());
      const auto& known = league::families().at(home(pair, name).family).enums;
      ASSERT_TRUE(known.contains(name)) << "not an enum of " << pair.family;
      std::map<std::string, int> values;
      for (int i = 0; i < ours->value_count(); ++i) values[ours->value(i)->name()] = ours->value(i)->number();
      EXPECT_EQ(values, known.at(name));
      ++enums;
    }
  }
  // 2 vision, Team and GameEvent.Type, 4 referee, 2 tracker, 1 simulation
  EXPECT_EQ(enums, 13);
}

TEST(ProtoSchema, NothingOfTheLeagueIsMissing) {
  // What only clients of the game controller use (reference "protocol", 2.9 and 2.10).
  // We have no such client.
  const std::set<std::string> left_out = {"ControllerReply",
                                          "Signature",
                                          "AutoRefRegistration",
                                          "AutoRefToController",
                                          "ControllerToAutoRef",
                                          "TeamRegistration",
                                          "TeamToController",
                                          "ControllerToTeam",
                                          "AdvantageChoice",
                                          "RemoteControlRegistration",
                                          "RemoteControlToController",
                                          "ControllerToRemoteControl",
                                          "RemoteControlTeamState",
                                          "RemoteControlRequestType",
                                          "CiInput",
                                          "CiOutput",
                                          "AutoRefCiInput",
                                          "AutoRefCiOutput",
                                          "Input",
                                          "ContinueAction",
                                          "Change",
                                          "Command",
                                          "Config",
                                          "AutoRefConfig"};
  std::map<std::string, std::set<std::string>> ours;
  for (const Pair& pair : pairs()) {
    const Described file = described(*pair.ours);
    for (const Descriptor* message : file.messages) {
      ours[pair.family].insert(league::league_name(message->full_name()));
    }
    for (const EnumDescriptor* enumeration : file.enums) {
      ours[pair.family].insert(league::league_name(enumeration->full_name()));
    }
  }
  int compared = 0;
  for (const auto& [family, names] : ours) {
    std::vector<std::string> theirs;
    for (const auto& [name, fields] : league::families().at(family).messages) theirs.push_back(name);
    for (const auto& [name, values] : league::families().at(family).enums) theirs.push_back(name);
    for (const std::string& name : theirs) {
      if (left_out.contains(name.substr(0, name.find('.')))) continue;
      EXPECT_TRUE(names.contains(without_legacy_package(name))) << name << " of " << family;
      ++compared;
    }
  }
  EXPECT_EQ(compared,
            94 - 2 + 11 - 1);  // all of the two tests above but Vector2, Vector3 and Team of the events
}

TEST(ProtoSchema, ThePayloadsOfErForceAreTheirs) {
  const auto& theirs = league::families().at("robotics-erlangen/framework HEAD").messages;
  const std::map<const Descriptor*, std::string> both = {
      {matchday::simulation::RealismConfigErForce::descriptor(), "RealismConfigErForce"},
      {matchday::simulation::RobotSpecErForce::descriptor(), "sslsim.RobotSpecErForce"}};
  for (const auto& [ours, name] : both) {
    EXPECT_EQ(static_cast<std::size_t>(ours->field_count()), theirs.at(name).size());
    for (const league::Field& field : theirs.at(name)) {
      const FieldDescriptor* own = ours->FindFieldByNumber(field.number);
      ASSERT_NE(own, nullptr) << field.name;
      expect_equal(*own, field);
    }
  }
}

TEST(ProtoSchema, FeedbackIsTheLastFieldOfATick) {
  const Descriptor& tick = *matchday::match::MatchTick::descriptor();
  for (int i = 0; i < tick.field_count(); ++i) {
    EXPECT_LE(tick.field(i)->number(), matchday::match::MatchTick::kFeedbackFieldNumber);
  }
}
