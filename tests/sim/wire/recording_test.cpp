#include "sim/wire/recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>
#include <iterator>

#include "sim/wire/delimited.h"

namespace wire {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr int ticks = 40;

class RecordingTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "recording-test-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  static proto::Recorded first(std::uint32_t version = recording_version) {
    proto::Recorded record;
    record.mutable_start()->set_version(version);
    record.mutable_start()->set_config("{}");
    record.mutable_start()->mutable_yellow()->set_name("ours");
    return record;
  }
  static proto::Recorded tick(int number) {
    proto::Recorded record;
    record.mutable_tick()->set_tick(number);
    record.mutable_tick()->mutable_yellow()->set_tick(static_cast<std::uint32_t>(number));
    if (number % 10 == 0) record.mutable_tick()->set_hash("0123456789abcdef");
    return record;
  }
  fs::path written(const std::string& name, bool closed = true) const {
    RecordingWriter writer(folder_ / name);
    writer.write(first());
    for (int i = 1; i <= ticks; ++i) writer.write(tick(i));
    if (closed) writer.close();
    return folder_ / name;
  }
  fs::path copy(const std::string& bytes, const std::string& name = "copy.replies") const {
    std::ofstream(folder_ / name, std::ios::binary | std::ios::trunc) << bytes;
    return folder_ / name;
  }
  static std::string bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  /// "whole", "cut", or what the reader says.
  static std::string read(const fs::path& file) {
    try {
      RecordingReader reader(file);
      int count = 0;
      while (const proto::Tick* tick = reader.next()) {
        EXPECT_EQ(tick->tick(), ++count);
      }
      EXPECT_EQ(reader.next(), nullptr);
      return reader.cut() ? "cut" : "whole";
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  }

  fs::path folder_;
};

TEST_F(RecordingTest, IsReadToItsEnd) {
  EXPECT_EQ(read(written("game.replies")), "whole");
  EXPECT_EQ(read(written("game.replies.gz")), "whole");
}

// The last seconds count as much as the first.
TEST_F(RecordingTest, EveryFlippedBitIsNoticed) {
  const std::string right = bytes_of(written("game.replies"));
  for (std::size_t bit = 0; bit < 8 * right.size(); ++bit) {
    std::string wrong = right;
    wrong[bit / 8] = static_cast<char>(wrong[bit / 8] ^ (1 << (bit % 8)));
    EXPECT_NE(read(copy(wrong)), "whole") << "bit " << bit << " of " << 8 * right.size();
  }
}

// gzip has bits of no meaning: date, system and kind of packing (bytes 4 to 9), and those that fill the last
// byte of the packed data, before the eight of checksum and length.
TEST_F(RecordingTest, EveryFlippedBitOfAPackedOneIsNoticed) {
  const std::string right = bytes_of(written("game.replies.gz"));
  for (std::size_t bit = 80; bit < 8 * right.size(); ++bit) {
    if (bit / 8 == right.size() - 9) continue;
    std::string wrong = right;
    wrong[bit / 8] = static_cast<char>(wrong[bit / 8] ^ (1 << (bit % 8)));
    EXPECT_NE(read(copy(wrong, "copy.replies.gz")), "whole") << "bit " << bit;
  }
}

TEST_F(RecordingTest, CutOffAnywhereItIsToldFromAWholeOne) {
  const std::string right = bytes_of(written("game.replies"));
  const std::size_t start = bytes_of(written("open.replies", false)).find("ours") + 4 + 9;
  for (std::size_t size = start; size < right.size(); ++size) {
    EXPECT_EQ(read(copy(right.substr(0, size))), "cut") << size << " of " << right.size();
  }
  EXPECT_EQ(read(written("open.replies", false)), "cut");
}

TEST_F(RecordingTest, NamesTheRecordThatIsDamaged) {
  std::string wrong = bytes_of(written("game.replies"));
  const std::size_t place = wrong.find("0123456789abcdef");  // of tick 10, the start is record 1
  wrong[place] = '1';
  EXPECT_THAT(read(copy(wrong)), HasSubstr("record 11 is not what was written: the file is damaged"));
}

TEST_F(RecordingTest, RecordsInAnotherOrderOrLeftOutAreNoticed) {
  proto::Recorded record;
  std::vector<std::string> frames;
  const std::string right = bytes_of(written("game.replies"));
  FrameReader reader;
  reader.append(std::as_bytes(std::span(right)));
  while (const auto payload = reader.next()) {
    std::string frame;
    append_frame_header(frame, payload->size());
    frame.append(reinterpret_cast<const char*>(payload->data()), payload->size());
    frames.push_back(frame);
  }
  const auto all = [&] {
    std::string bytes;
    for (const std::string& frame : frames) bytes += frame;
    return bytes;
  };
  EXPECT_EQ(read(copy(all())), "whole");
  EXPECT_THAT(read(copy(all() + frames[3])), HasSubstr("damaged"));
  frames.erase(frames.begin() + 5);
  EXPECT_THAT(read(copy(all())), HasSubstr("record 6 is not what was written"));
}

TEST_F(RecordingTest, OfVersion1IsStillRead) {
  std::string bytes;
  append_frame(bytes, first(1));
  for (int i = 1; i <= ticks; ++i) append_frame(bytes, tick(i));
  EXPECT_EQ(read(copy(bytes)), "whole");
  EXPECT_EQ(read(copy(bytes.substr(0, bytes.size() - 3))), "cut");
  std::string newer;
  append_frame(newer, first(3));
  EXPECT_THAT(read(copy(newer)), HasSubstr("damaged")) << "it must have a check";
}

}  // namespace
}  // namespace wire
