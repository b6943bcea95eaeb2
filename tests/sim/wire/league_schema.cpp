#include "tests/sim/wire/league_schema.h"

#include <google/protobuf/descriptor.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace league {

namespace {

std::map<std::string, Family> load(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be opened");
  std::map<std::string, Family> result;
  const nlohmann::json all = nlohmann::json::parse(file);
  for (const auto& [name, schema] : all.items()) {
    Family& family = result[name];
    for (const auto& [message, fields] : schema.at("messages").items()) {
      for (const nlohmann::json& field : fields) {
        family.messages[message].push_back({.number = field.at("num"),
                                            .name = field.at("name"),
                                            .type = field.at("type"),
                                            .label = field.at("label"),
                                            .oneof = field.value("oneof", ""),
                                            .default_value = field.value("default", ""),
                                            .packed = field.value("packed", false),
                                            .deprecated = field.value("dep", false)});
      }
    }
    for (const auto& [enumeration, values] : schema.at("enums").items()) {
      family.enums[enumeration] = values.get<std::map<std::string, int>>();
    }
  }
  return result;
}

std::vector<const google::protobuf::Message*> messages_in(const google::protobuf::Message& message,
                                                          const google::protobuf::FieldDescriptor& field) {
  std::vector<const google::protobuf::Message*> result;
  const google::protobuf::Reflection& reflection = *message.GetReflection();
  if (field.is_repeated()) {
    for (int i = 0; i < reflection.FieldSize(message, &field); ++i) {
      result.push_back(&reflection.GetRepeatedMessage(message, &field, i));
    }
  } else if (reflection.HasField(message, &field)) {
    result.push_back(&reflection.GetMessage(message, &field));
  }
  return result;
}

}  // namespace

const std::map<std::string, Family>& families() {
  static const std::map<std::string, Family> all = load(SOURCE_DIR "/tests/sim/data/protocol-fields.json");
  return all;
}

std::string league_name(const std::string& full_name) {
  const std::string ours = "matchday.";
  if (!full_name.starts_with(ours)) return full_name;
  return full_name.substr(full_name.find('.', ours.size()) + 1);
}

std::vector<std::string> missing_required(const google::protobuf::Message& message,
                                          const std::string& family) {
  std::vector<std::string> missing;
  const google::protobuf::Descriptor& descriptor = *message.GetDescriptor();
  const std::string name = league_name(descriptor.full_name());
  for (const Field& field : families().at(family).messages.at(name)) {
    const google::protobuf::FieldDescriptor* ours = descriptor.FindFieldByNumber(field.number);
    if (field.label == "required" && !message.GetReflection()->HasField(message, ours)) {
      missing.push_back(name + "." + field.name);
    }
    if (ours->cpp_type() != google::protobuf::FieldDescriptor::CPPTYPE_MESSAGE) continue;
    for (const google::protobuf::Message* part : messages_in(message, *ours)) {
      // A few small messages are not in this family's table: Vector2 of the game events.
      if (!families().at(family).messages.contains(league_name(part->GetDescriptor()->full_name()))) continue;
      for (std::string& deeper : missing_required(*part, family)) missing.push_back(std::move(deeper));
    }
  }
  return missing;
}

}  // namespace league
