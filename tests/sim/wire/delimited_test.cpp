#include "sim/wire/delimited.h"

#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <google/protobuf/util/delimited_message_util.h>
#include <gtest/gtest.h>

#include "sim/proto/match.pb.h"

namespace {

std::span<const std::byte> bytes(std::string_view text) { return std::as_bytes(std::span(text)); }

std::string text(std::span<const std::byte> payload) {
  return {reinterpret_cast<const char*>(payload.data()), payload.size()};
}

std::string frame(std::string_view payload) {
  std::string out;
  wire::append_frame_header(out, payload.size());
  return out.append(payload);
}

std::vector<std::string> all_frames(wire::FrameReader& reader) {
  std::vector<std::string> result;
  while (const auto payload = reader.next()) result.push_back(text(*payload));
  return result;
}

}  // namespace

TEST(FrameReader, SplitAnywhereGivesTheSameFrames) {
  // Lengths around the step from one to two bytes of header, and an empty one.
  std::vector<std::string> payloads;
  std::string stream;
  for (const std::size_t size : {0U, 1U, 127U, 128U, 300U}) {
    payloads.push_back(std::string(size, static_cast<char>('a' + size % 26)));
    stream += frame(payloads.back());
  }
  for (std::size_t split = 0; split <= stream.size(); ++split) {
    wire::FrameReader reader;
    reader.append(bytes(stream).first(split));
    std::vector<std::string> received = all_frames(reader);
    reader.append(bytes(stream).subspan(split));
    for (std::string& payload : all_frames(reader)) received.push_back(std::move(payload));
    ASSERT_EQ(received, payloads) << "split at " << split;
    ASSERT_EQ(reader.pending(), 0U);
  }
}

TEST(FrameReader, TakesOneByteAtATime) {
  const std::string stream = frame(std::string(200, 'x')) + frame("y");
  wire::FrameReader reader;
  std::vector<std::string> received;
  for (const std::byte byte : bytes(stream)) {
    reader.append({&byte, 1});
    for (std::string& payload : all_frames(reader)) received.push_back(std::move(payload));
  }
  EXPECT_EQ(received, (std::vector<std::string>{std::string(200, 'x'), "y"}));
}

TEST(FrameReader, TellsHowMuchOfAFrameIsStillOpen) {
  wire::FrameReader reader;
  reader.append(bytes(frame("whole") + frame("half").substr(0, 3)));
  EXPECT_EQ(all_frames(reader).size(), 1U);
  EXPECT_EQ(reader.pending(), 3U);
}

TEST(FrameReader, OneMebibyteIsAllowedAndAByteMoreIsNot) {
  wire::FrameReader reader;
  reader.append(bytes(frame(std::string(wire::max_frame_size, 'x'))));
  const auto payload = reader.next();
  ASSERT_TRUE(payload.has_value());
  EXPECT_EQ(payload->size(), 1'048'576U);

  std::string header;
  wire::append_frame_header(header, wire::max_frame_size + 1);
  reader.append(bytes(header));
  EXPECT_THROW(reader.next(), wire::FrameError) << "before its payload has arrived";
  EXPECT_THROW(reader.next(), wire::FrameError) << "and ever after";
}

// Whoever appends must ask for frames in between: then a stream of any length takes the memory of one frame.
TEST(FrameReader, KeepsNoMoreThanAFrameAndAPiece) {
  wire::FrameReader reader;
  const std::string piece = frame(std::string(1000, 'x'));
  std::size_t appended = 0;
  EXPECT_THROW(
      {
        while (appended < 4 * wire::max_frame_size) {
          reader.append(bytes(piece));
          appended += piece.size();
        }
      },
      wire::FrameError);
  EXPECT_LE(reader.pending(), wire::max_frame_size + 2 * piece.size());
  all_frames(reader);
  reader.append(bytes(piece));
  EXPECT_EQ(all_frames(reader).size(), 1U);
}

TEST(FrameReader, AcceptsNoMoreThanItWasTold) {
  wire::FrameReader reader(100);
  std::string header;
  wire::append_frame_header(header, 101);
  reader.append(bytes(frame(std::string(100, 'x')) + header));
  EXPECT_EQ(reader.next()->size(), 100U);
  try {
    reader.next();
    ADD_FAILURE() << "before its payload has arrived";
  } catch (const wire::FrameError& error) {
    EXPECT_STREQ(error.what(), "frame of 101 bytes is longer than the 100 allowed");
  }
}

TEST(FrameReader, RefusesALengthThatIsNoVarint) {
  wire::FrameReader reader;
  reader.append(bytes("\xff\xff\xff\xff"));
  EXPECT_FALSE(reader.next().has_value()) << "the fifth byte may still end it";
  reader.append(bytes("\xff"));
  EXPECT_THROW(reader.next(), wire::FrameError);
}

TEST(FrameReader, AcceptsALengthWrittenLongerThanNeeded) {
  wire::FrameReader reader;
  reader.append(bytes(std::string_view("\x81\x80\x00x", 4)));
  const auto payload = reader.next();
  ASSERT_TRUE(payload.has_value());
  EXPECT_EQ(text(*payload), "x");
}

TEST(AppendFrame, IsReadByProtobufsOwnReader) {
  matchday::match::TeamMessage message;
  message.mutable_reply()->set_tick(42);
  message.mutable_reply()->set_note(std::string(1000, 'n'));
  std::string stream;
  wire::append_frame(stream, message);
  wire::append_frame(stream, message);

  google::protobuf::io::ArrayInputStream input(stream.data(), static_cast<int>(stream.size()));
  for (int i = 0; i < 2; ++i) {
    matchday::match::TeamMessage received;
    ASSERT_TRUE(google::protobuf::util::ParseDelimitedFromZeroCopyStream(&received, &input, nullptr));
    EXPECT_EQ(received.SerializeAsString(), message.SerializeAsString());
  }
}

TEST(AppendFrame, RefusesAMessageThatNoReaderWouldTake) {
  matchday::match::TeamMessage message;
  message.mutable_reply()->set_note(std::string(wire::max_frame_size, 'n'));
  std::string stream;
  EXPECT_THROW(wire::append_frame(stream, message), wire::FrameError);
  EXPECT_TRUE(stream.empty());
}
