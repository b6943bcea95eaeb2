#pragma once

#include <google/protobuf/any.pb.h>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace wire {

/// The message inside, when its name is that of `Message` without our package, behind one of the packages
/// `packages` ("" for none); nothing for another message or unreadable bytes.
///
/// The name is what follows the last slash of the type url, as the receiver compiled it: programs of the
/// league differ in the package (reference "protocol", 2.7).
template <class Message>
std::optional<Message> unpacked(const google::protobuf::Any& any,
                                std::initializer_list<std::string_view> packages) {
  const std::string_view url = any.type_url();
  const std::string_view name = url.substr(url.rfind('/') + 1);  // npos + 1 is 0
  for (const std::string_view package : packages) {
    if (name != std::string(package) + Message::descriptor()->name()) continue;
    Message message;
    if (!message.ParseFromString(any.value())) return std::nullopt;
    return message;
  }
  return std::nullopt;
}

/// Text from outside for a message to people: printable ASCII, at most 80 characters.
inline std::string printable(std::string_view text) {
  std::string result;
  for (const char c : text.substr(0, 80)) result += c >= ' ' && c <= '~' ? c : '?';
  return result;
}

}  // namespace wire
