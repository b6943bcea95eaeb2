#include "sim/wire/log_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <unistd.h>
#include <zlib.h>

#include <csignal>
#include <fstream>
#include <iterator>

#include "sim/wire/log_messages.h"
#include "sim/wire/output_error.h"
#include "tests/fakes/odd_files.h"

namespace {

using namespace std::string_literals;
using testing::HasSubstr;
using testing::StartsWith;
namespace fs = std::filesystem;

/// A directory of its own for each test.
class LogFile : public testing::Test {
 protected:
  LogFile() {
    std::string name = (fs::temp_directory_path() / "log_file_test.XXXXXX").string();
    if (::mkdtemp(name.data()) != nullptr) directory_ = name;
  }
  ~LogFile() override { fs::remove_all(directory_); }

  fs::path path(const std::string& name) const { return directory_ / name; }

  fs::path store(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

  static std::string bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  /// Three records of 10, 0 and 300 bytes.
  static void write_example(const fs::path& file) {
    wire::LogWriter writer(file);
    writer.write(1'700'000'000'000'000'000, wire::Vision2014, "0123456789");
    writer.write(-5, 99, "");
    std::string noise;  // does not compress, so that damage can be anywhere
    for (unsigned i = 0, value = 1; i < 300; ++i)
      noise += static_cast<char>((value = value * 1664525 + 1013904223) >> 24);
    writer.write(0, wire::Refbox2013, noise);
    writer.close();
  }

  fs::path directory_;
};

std::vector<wire::LogRecord> read_all(wire::LogReader& reader) {
  std::vector<wire::LogRecord> records;
  wire::LogRecord record;
  while (reader.next(record)) records.push_back(record);
  EXPECT_EQ(reader.records(), static_cast<std::int64_t>(records.size()));
  return records;
}

/// What reading the whole file complains about.
std::string complaint(const fs::path& file) {
  try {
    wire::LogReader reader(file);
    read_all(reader);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

const std::string file_header = "SSL_LOG_FILE\0\0\0\1"s;

std::string record_header(const std::string& length) { return std::string(12, '\0') + length; }

}  // namespace

TEST_F(LogFile, ReadsTheExampleOfTheDescription) {
  // One empty blank record at t = 1 s, byte for byte from the reference "protocol", 4.1.
  const std::string example =
      "\x53\x53\x4c\x5f\x4c\x4f\x47\x5f\x46\x49\x4c\x45"
      "\x00\x00\x00\x01"
      "\x00\x00\x00\x00\x3b\x9a\xca\x00"
      "\x00\x00\x00\x00"
      "\x00\x00\x00\x00"s;
  wire::LogReader reader(store("example.log", example));
  const std::vector<wire::LogRecord> records = read_all(reader);
  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(records[0].time_ns, 1'000'000'000);
  EXPECT_EQ(records[0].type, 0);
  EXPECT_EQ(records[0].payload, "");
  EXPECT_FALSE(reader.truncated());

  wire::LogWriter writer(path("written.log"));
  writer.write(1'000'000'000, 0, "");
  writer.close();
  EXPECT_EQ(bytes_of(path("written.log")), example);
}

TEST_F(LogFile, ComesBackPlainAndPacked) {
  for (const std::string name : {"a.log", "a.log.gz"}) {
    write_example(path(name));
    wire::LogReader reader(path(name));
    const std::vector<wire::LogRecord> records = read_all(reader);
    ASSERT_EQ(records.size(), 3U);
    EXPECT_EQ(records[0].time_ns, 1'700'000'000'000'000'000);
    EXPECT_EQ(records[0].type, wire::Vision2014);
    EXPECT_EQ(records[0].payload, "0123456789");
    EXPECT_EQ(records[1].time_ns, -5);
    EXPECT_EQ(records[1].type, 99);
    EXPECT_EQ(records[2].payload.size(), 300U);
    EXPECT_FALSE(reader.truncated());
    EXPECT_EQ(reader.truncation(), "");
  }
}

TEST_F(LogFile, PackedFilesAreLevelOneAndTheSameEveryTime) {
  write_example(path("a.log.gz"));
  write_example(path("b.log.gz"));
  const std::string bytes = bytes_of(path("a.log.gz"));
  EXPECT_EQ(bytes, bytes_of(path("b.log.gz")));
  EXPECT_THAT(bytes, StartsWith("\x1f\x8b\x08"));
  EXPECT_EQ(bytes[8], 4) << "RFC 1952: XFL = 4, fastest algorithm";
}

TEST_F(LogFile, MessagesComeBack) {
  matchday::vision::SSL_WrapperPacket packet;
  packet.mutable_detection()->set_frame_number(5);
  {
    wire::LogWriter writer(path("a.log"));
    writer.write(1, wire::Vision2014, packet);
    writer.write(2, wire::Vision2010, packet);
    writer.write(3, wire::Vision2014, "\x0a\xff");
  }  // closes quietly
  wire::LogReader reader(path("a.log"));
  const std::vector<wire::LogRecord> records = read_all(reader);
  ASSERT_EQ(records.size(), 3U);
  matchday::vision::SSL_WrapperPacket received;
  EXPECT_TRUE(wire::read(records[0], received));
  EXPECT_EQ(received.detection().frame_number(), 5U);
  EXPECT_FALSE(wire::read(records[1], received)) << "another type";
  EXPECT_FALSE(wire::read(records[2], received)) << "not a message";
  matchday::referee::Referee referee;
  EXPECT_FALSE(wire::read(records[0], referee));
}

TEST_F(LogFile, CutAnywhereItGivesTheWholeRecordsAndSaysSo) {
  write_example(path("whole.log"));
  const std::string bytes = bytes_of(path("whole.log"));
  const std::vector<std::size_t> ends = {16, 42, 58, 374};  // of the file's header and of each record
  ASSERT_EQ(bytes.size(), ends.back());
  for (std::size_t size = 16; size <= bytes.size(); ++size) {
    wire::LogReader reader(store("cut.log", bytes.substr(0, size)));
    const std::vector<wire::LogRecord> records = read_all(reader);
    std::size_t whole = 0;
    while (whole + 1 < ends.size() && ends[whole + 1] <= size) ++whole;
    ASSERT_EQ(records.size(), whole) << size;
    ASSERT_EQ(reader.truncated(), ends[whole] != size) << size;
  }
  wire::LogReader reader(store("cut.log", bytes.substr(0, 80)));
  read_all(reader);
  EXPECT_EQ(
      reader.truncation(),
      path("cut.log").string() + ": record 3 at byte 58: cut short, 6 of its 300 bytes of payload are there");
}

TEST_F(LogFile, CutInTheFirstSixteenBytesItIsNoLogFile) {
  for (std::size_t size = 0; size < 16; ++size) {
    EXPECT_THAT(complaint(store("cut.log", file_header.substr(0, size))), HasSubstr("cut.log: is too short"))
        << size;
  }
}

TEST_F(LogFile, APackedFileCutAnywhereIsNeverTakenForWhole) {
  write_example(path("whole.log.gz"));
  const std::string bytes = bytes_of(path("whole.log.gz"));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    store("cut.log.gz", bytes.substr(0, size));
    try {
      wire::LogReader reader(path("cut.log.gz"));
      EXPECT_LE(read_all(reader).size(), 3U);
      EXPECT_TRUE(reader.truncated()) << size;
      EXPECT_THAT(reader.truncation(), HasSubstr("cut.log.gz: record ")) << size;
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), StartsWith(path("cut.log.gz").string() + ": ")) << size;
    }
  }
}

TEST_F(LogFile, APackedFileWithOneWrongBitIsNeverTakenForWhole) {
  write_example(path("whole.log.gz"));
  const std::string bytes = bytes_of(path("whole.log.gz"));
  int thrown = 0;
  for (std::size_t i = 10; i < bytes.size(); ++i) {  // the first ten bytes hold no data
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    store("bad.log.gz", damaged);
    try {
      wire::LogReader reader(path("bad.log.gz"));
      read_all(reader);
      EXPECT_TRUE(reader.truncated()) << "byte " << i;
    } catch (const std::runtime_error&) {
      ++thrown;
    }
  }
  EXPECT_GT(thrown, 0);
}

TEST_F(LogFile, AWrongChecksumNamesThePlace) {
  write_example(path("bad.log.gz"));
  std::string bytes = bytes_of(path("bad.log.gz"));
  bytes[bytes.size() - 8] = static_cast<char>(bytes[bytes.size() - 8] ^ 1);
  store("bad.log.gz", bytes);
  const std::string text = complaint(path("bad.log.gz"));
  EXPECT_THAT(text, HasSubstr("bad.log.gz: "));
  EXPECT_THAT(text, HasSubstr("gzip data damaged"));
}

// A datagram has at most 65,507 bytes: what says that it has more is refused before memory is taken for it.
TEST_F(LogFile, RefusesLengthsThatNoDatagramHas) {
  const std::string good = record_header("\0\0\0\3"s) + "abc";
  EXPECT_EQ(complaint(store("a.log", file_header + good + record_header("\xff\xff\xff\xfe"s))),
            path("a.log").string() +
                ": record 2 at byte 35: its payload length is -2, not 0 to 65507 bytes; the file is damaged");
  EXPECT_THAT(complaint(store("a.log", file_header + record_header("\0\0\xff\xe4"s))),
              HasSubstr("record 1 at byte 16: its payload length is 65508"));
  EXPECT_THAT(complaint(store("a.log", file_header + record_header("\x04\0\0\0"s))), HasSubstr("67108864"));
  EXPECT_EQ(complaint(store("a.log", file_header + record_header("\0\0\xff\xe3"s))), "") << "cut short";
  wire::LogWriter writer(path("a.log"));
  writer.write(0, wire::Vision2014, std::string(65'507, 'x'));
  EXPECT_THROW(writer.write(0, wire::Vision2014, std::string(65'508, 'x')), std::length_error);
}

TEST_F(LogFile, PassesOverAnIndexWithoutKeepingIt) {
  // 64 MiB of zeros pack into 64 KiB: what made a small log take gigabytes.
  const std::string index_header = std::string(8, '\0') + "\0\0\0\6"s + "\x04\0\0\0"s;
  const std::string last = record_header("\0\0\0\3"s) + "abc";
  gzFile file = gzopen(path("a.log.gz").c_str(), "wb1");
  ASSERT_NE(file, nullptr);
  const auto put = [&](const std::string& bytes) {
    ASSERT_EQ(gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size())),
              static_cast<int>(bytes.size()));
  };
  put(file_header + index_header);
  const std::string mebibyte(1 << 20, '\0');
  for (int i = 0; i < 64; ++i) put(mebibyte);
  put(last);
  gzclose(file);
  wire::LogReader reader(path("a.log.gz"));
  wire::LogRecord record;
  ASSERT_TRUE(reader.next(record));
  EXPECT_EQ(record.type, wire::Index2021);
  EXPECT_EQ(record.payload, "");
  EXPECT_LT(record.payload.capacity(), 100'000U);
  ASSERT_TRUE(reader.next(record));
  EXPECT_EQ(record.payload, "abc");
  EXPECT_FALSE(reader.next(record));

  EXPECT_THAT(complaint(store("a.log", file_header + std::string(8, '\0') + "\0\0\0\6"s + "\x04\0\0\1"s)),
              HasSubstr("its payload length is 67108865, not 0 to 67108864 bytes"));
  wire::LogReader cut(store("cut.log", file_header + index_header + "xyz"));
  EXPECT_FALSE(cut.next(record));
  EXPECT_THAT(cut.truncation(), HasSubstr("3 of its 67108864 bytes of payload are there"));
}

TEST_F(LogFile, RefusesOtherFilesWithAHint) {
  EXPECT_THAT(complaint(store("a.log", "this is some text file")),
              HasSubstr("a.log: is not an SSL log file"));
  EXPECT_THAT(complaint(store("a.log", "SSL_LOG_FILE\0\0\0\2"s)), HasSubstr("is a log file of version 2"));
  EXPECT_THAT(complaint(store("a.log", "\0\0\0\x18\0S\0S\0L\0_\0L\0O\0G"s)), HasSubstr("version 0"));
  write_example(path("packed.log.gz"));
  EXPECT_THAT(complaint(store("a.log", bytes_of(path("packed.log.gz")))), HasSubstr("name must end in .gz"));
  EXPECT_THAT(complaint(store("a.log.gz", file_header)), HasSubstr("is not gzip data"));
}

TEST_F(LogFile, NamesAFileThatCannotBeOpened) {
  EXPECT_EQ(complaint(path("none.log")),
            path("none.log").string() + ": cannot be read: No such file or directory");
  EXPECT_EQ(complaint(path("none.log.gz")),
            path("none.log.gz").string() + ": cannot be read: No such file or directory");
  EXPECT_THAT(complaint(directory_), HasSubstr("is a folder, a regular file is needed"));
}

TEST_F(LogFile, ThatIsNoFileIsRefusedAtOnce) {
  ::alarm(20);  // [s] a file that blocks ends the test
  for (const std::string name : {"odd.log", "odd.log.gz"}) {
    for (const fakes::OddFile& odd : fakes::odd_files()) {
      odd.make(path(name));
      EXPECT_EQ(complaint(path(name)), path(name).string() + ": " + odd.sentence);
    }
    fakes::make_pipe(path(name));
    EXPECT_THROW(wire::LogWriter{path(name)}, wire::OutputError) << "nobody reads it";
  }
  ::alarm(0);
}

TEST_F(LogFile, IsWrittenIntoAPipeThatSomebodyReads) {
  fakes::make_pipe(path("pipe.log"));
  const int reader = ::open(path("pipe.log").c_str(), O_RDONLY | O_NONBLOCK);
  write_example(path("pipe.log"));
  std::string bytes(1000, '\0');
  EXPECT_EQ(::read(reader, bytes.data(), bytes.size()), 16 + 3 * 16 + 10 + 300);
  ::close(reader);
  EXPECT_TRUE(fs::is_fifo(path("pipe.log")));
}

// A disk that is full, as a limit of this process.
TEST_F(LogFile, ThatCannotBeWrittenIsRemoved) {
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  std::string noise;  // does not compress
  for (unsigned i = 0, value = 1; i < 50'000; ++i)
    noise += static_cast<char>((value = value * 1664525 + 1013904223) >> 24);
  for (const std::string name : {"full.log", "full.log.gz"}) {
    const rlimit little{1000, before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &little);
    std::string said;
    try {
      wire::LogWriter writer(path(name));
      for (int i = 0; i < 10; ++i) writer.write(0, wire::Vision2014, noise);
      writer.close();
    } catch (const wire::OutputError& error) {
      said = error.what();
    }
    ::setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_EQ(said, path(name).string() + ": cannot be written: File too large");
    EXPECT_FALSE(fs::exists(path(name)));
  }
  std::signal(SIGXFSZ, handler);
}

TEST_F(LogFile, WritingFailsAloud) {
  EXPECT_THROW(wire::LogWriter(path("none/a.log")), std::runtime_error);
  EXPECT_THROW(wire::LogWriter(path("none/a.log.gz")), std::runtime_error);
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full on this system";
  for (const std::string name : {"full.log", "full.log.gz"}) {
    fs::create_symlink("/dev/full", path(name));
    EXPECT_THROW(
        {
          wire::LogWriter writer(path(name));
          writer.write(0, wire::Vision2014, std::string(10'000, 'x'));
          writer.close();
        },
        std::runtime_error)
        << name;
  }
}
