#include <gmock/gmock.h>
#include <google/protobuf/struct.pb.h>
#include <google/protobuf/util/json_util.h>
#include <gtest/gtest.h>
#include <toml++/toml.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "autoref/calibrate_log.h"
#include "sim/wire/log_file.h"
#include "sim/wire/vision.h"
#include "tests/autoref/calibrate/scene.h"

namespace autoref {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class Calibrate : public ::testing::Test {
 protected:
  Calibrate() : folder_(fs::path(::testing::TempDir()) / ("calibrate_" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~Calibrate() override { fs::remove_all(folder_); }

  // Ten seconds of two cameras, as one type of record.
  fs::path log(const std::string& name, bool with_geometry = true, bool with_images = true) {
    wire::LogWriter log(folder_ / name);
    if (with_geometry) {  // each camera tells of itself alone, as in the log of 2022
      for (const world::Camera& camera : scene::geometry(2).cameras) {
        world::Geometry geometry = scene::geometry(2);
        geometry.cameras = {camera};
        wire::proto::SSL_WrapperPacket packet;
        wire::encode(geometry, *packet.mutable_geometry());
        log.write(1, wire::Vision2014, packet);
      }
    }
    if (with_images) {
      for (const world::Detection& image : scene::images(2, 10, {}, 1)) {
        wire::proto::SSL_WrapperPacket packet;
        wire::encode(image, wire::Epoch{}, *packet.mutable_detection());
        log.write(1, wire::Vision2014, packet);
      }
    }
    log.close();
    return folder_ / name;
  }

  // The same images as records of type 2, whose detections are the same.
  fs::path old_log() {
    wire::LogWriter log(folder_ / "old.log");
    for (const world::Detection& image : scene::images(2, 10, {}, 1)) {
      matchday::legacy2014::SSL_WrapperPacket packet;
      wire::encode(image, wire::Epoch{}, *packet.mutable_detection());
      log.write(1, wire::Vision2010, packet);
    }
    log.close();
    return folder_ / "old.log";
  }

  int run(const fs::path& file, const fs::path& out = {}, bool json = false) {
    out_.str("");
    errors_.str("");
    return calibrate_log({.file = file, .out = out, .json = json}, out_, errors_);
  }
  std::string sentence_of(const fs::path& file, const fs::path& out = {}) {
    try {
      run(file, out);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  }
  static std::string content(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  fs::path folder_;
  std::ostringstream out_, errors_;
};

TEST_F(Calibrate, PrintsATableAndWritesThePreset) {
  const fs::path preset = folder_ / "preset.toml";
  EXPECT_EQ(run(log("game.log"), preset), 0) << errors_.str();
  EXPECT_THAT(out_.str(), HasSubstr("game.log: 10.0 s, 2 cameras, 1200 images, 8 robots"));
  EXPECT_THAT(out_.str(), HasSubstr("ball noise, per axis"));
  const toml::table table = toml::parse_file(preset.string());
  EXPECT_EQ(table["realism"]["vision"]["cameras"].value<int>(), 2);
  EXPECT_NEAR(table["realism"]["vision"]["camera_height"].value<double>().value(), 4.2, 1e-9);
  EXPECT_NEAR(table["realism"]["vision"]["robot_sigma"].value<double>().value(), 0.0005, 0.00005);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 2);  // nothing else is left behind
}

TEST_F(Calibrate, ReadsPackedAndOldLogsAlike) {
  EXPECT_EQ(run(log("game.log")), 0);
  const std::string table = out_.str().substr(out_.str().find('\n'));
  EXPECT_EQ(run(log("game.log.gz")), 0);
  EXPECT_EQ(out_.str().substr(out_.str().find('\n')), table);
  EXPECT_EQ(run(old_log()), 2);  // without geometry
  EXPECT_THAT(out_.str(), HasSubstr("1200 images, 8 robots"));
}

// 1200 images of a ball and eight robots, of which each camera sees a part.
TEST_F(Calibrate, OfALongLogMeasuresTheBeginningAndSaysSo) {
  CalibrateOptions options;
  options.file = log("game.log");
  options.most_kept = 3000;
  EXPECT_EQ(calibrate_log(options, out_, errors_), 0);
  EXPECT_THAT(out_.str(), HasSubstr("2 cameras"));
  EXPECT_THAT(out_.str(), Not(HasSubstr("1200 images")));
  EXPECT_THAT(errors_.str(), HasSubstr("game.log: only its beginning was measured, since 3000 images"));
  EXPECT_EQ(std::ranges::count(errors_.str(), '\n'), 1);
}

TEST_F(Calibrate, PrintsJson) {
  EXPECT_EQ(run(log("game.log"), {}, true), 0);
  google::protobuf::Struct json;
  ASSERT_TRUE(google::protobuf::util::JsonStringToMessage(out_.str(), &json).ok()) << out_.str();
  EXPECT_GT(json.fields().at("findings").list_value().values_size(), 20);
}

TEST_F(Calibrate, WithoutGeometryLeavesTheCamerasPlacesOut) {
  const fs::path preset = folder_ / "preset.toml";
  EXPECT_EQ(run(log("game.log", false), preset), 2);
  EXPECT_THAT(errors_.str(), HasSubstr("holds no geometry"));
  EXPECT_EQ(std::ranges::count(errors_.str(), '\n'), 1);
  const toml::table table = toml::parse_file(preset.string());
  EXPECT_FALSE(table["realism"]["vision"].as_table()->contains("camera_height"));
  EXPECT_TRUE(table["realism"]["vision"].as_table()->contains("robot_sigma"));
}

TEST_F(Calibrate, OfACutLogTellsWhatThereIs) {
  const fs::path file = log("game.log");
  fs::resize_file(file, fs::file_size(file) - 5);
  EXPECT_EQ(run(file), 2);
  EXPECT_THAT(out_.str(), HasSubstr("1199 images"));
  EXPECT_THAT(errors_.str(), HasSubstr(file.string()));
  EXPECT_THAT(errors_.str(), HasSubstr("record "));
  EXPECT_EQ(std::ranges::count(errors_.str(), '\n'), 1);
}

TEST_F(Calibrate, RefusesWhatHoldsNoImages) {
  EXPECT_NE(sentence_of("/nowhere/game.log"), "");
  EXPECT_THAT(sentence_of(log("empty.log", false, false)), HasSubstr("no images"));
  EXPECT_THAT(sentence_of(log("geometry.log", true, false)), HasSubstr("no images"));
  const fs::path diary = folder_ / "diary.log";
  std::ofstream(diary) << "this is a diary";
  EXPECT_NE(sentence_of(diary), "");
  std::ofstream(diary, std::ios::trunc).close();
  EXPECT_NE(sentence_of(diary), "");
}

TEST_F(Calibrate, WritesThePresetWholeOrNotAtAll) {
  const fs::path file = log("game.log");
  const std::string before = content(file);
  EXPECT_THAT(sentence_of(file, folder_), HasSubstr("is a folder"));
  EXPECT_THAT(sentence_of(file, folder_ / "nowhere" / "p.toml"), HasSubstr("folder does not exist"));
  EXPECT_THAT(sentence_of(file, "/dev/null"), HasSubstr("not a file"));
  EXPECT_THAT(sentence_of(file, file), HasSubstr("is the log itself"));
  EXPECT_EQ(content(file), before);
  // A log that holds nothing leaves an older preset as it was.
  const fs::path preset = folder_ / "preset.toml";
  std::ofstream(preset) << "old";
  EXPECT_NE(sentence_of(log("empty.log", false, false), preset), "");
  EXPECT_EQ(content(preset), "old");
}

fs::path real_log() {
  if (const char* path = std::getenv("MATCHDAY_REAL_LOG")) return path;
  return fs::path(SOURCE_DIR) / "../shared/data/robocup2022_kiks_vs_erforce_5s.log";
}

// Five seconds of a real game: two cameras at 73 Hz, 6.2 and 6.1 m high, that disagree by 30 mm.
TEST_F(Calibrate, MeasuresARealGame) {
  if (!fs::exists(real_log())) GTEST_SKIP() << "no " << real_log();
  const fs::path preset = folder_ / "preset.toml";
  EXPECT_EQ(run(real_log(), preset), 0) << errors_.str();
  std::cout << out_.str();
  const toml::table table = toml::parse_file(preset.string());
  const auto number = [&](const char* key) {
    return table["realism"]["vision"][key].value<double>().value();
  };
  EXPECT_EQ(number("cameras"), 2);
  EXPECT_NEAR(number("camera_height"), 6.14, 0.01);
  // Published for cameras of the league: tenths of a millimetre to 1.5 mm; 2 to 10 mrad;
  // biases of centimetres.
  EXPECT_GT(number("robot_sigma"), 0.0003);
  EXPECT_LT(number("robot_sigma"), 0.0015);
  EXPECT_GT(number("orientation_sigma"), 0.002);
  EXPECT_LT(number("orientation_sigma"), 0.01);
  EXPECT_GT(number("bias_sigma"), 0.005);
  EXPECT_LT(number("bias_sigma"), 0.03);
}

}  // namespace
}  // namespace autoref
