#include "sim/wire/match.h"

#include "sim/wire/delimited.h"

namespace wire {

namespace {

constexpr char length_delimited_tag(int field_number) { return static_cast<char>(field_number << 3 | 2); }

std::size_t varint_size(std::size_t value) {
  std::size_t size = 1;
  for (; value >= 0x80; value >>= 7) ++size;
  return size;
}

}  // namespace

void append_tick_frame(std::string& out, std::string_view shared,
                       const proto::RobotControlResponse& feedback) {
  const std::size_t feedback_size = feedback.ByteSizeLong();
  const std::size_t tick_size = shared.size() + 1 + varint_size(feedback_size) + feedback_size;
  const std::size_t message_size = 1 + varint_size(tick_size) + tick_size;
  if (message_size > max_frame_size) {
    throw FrameError("tick of " + std::to_string(message_size) + " bytes is longer than the " +
                     std::to_string(max_frame_size) + " allowed");
  }
  append_frame_header(out, message_size);
  out.push_back(length_delimited_tag(proto::HostMessage::kTickFieldNumber));
  append_frame_header(out, tick_size);
  out.append(shared);
  out.push_back(length_delimited_tag(proto::MatchTick::kFeedbackFieldNumber));
  append_frame_header(out, feedback_size);
  feedback.AppendPartialToString(&out);
}

}  // namespace wire
