#include "autoref/log.h"

#include <cmath>
#include <stdexcept>

#include "autoref/tracker/frame_grouper.h"
#include "sim/proto/legacy2014.pb.h"
#include "sim/proto/vision.pb.h"
#include "sim/wire/log_file.h"
#include "sim/wire/log_messages.h"
#include "sim/wire/referee.h"
#include "sim/wire/vision.h"

namespace autoref {
namespace {

constexpr std::int64_t records_to_survey = 5000;  // ours: geometry is sent every few seconds at the latest

constexpr std::size_t most_types = 32;  // ours: the league has seven

// The two vision messages in one: the detection is the same, the geometry differs.
class VisionRecord {
 public:
  bool read(const wire::LogRecord& record) {
    old_ = record.type == wire::Vision2010;
    return old_ ? packet_2010_.ParsePartialFromString(record.payload)
                : packet_2014_.ParsePartialFromString(record.payload);
  }
  const matchday::vision::SSL_DetectionFrame* detection() const {
    if (old_) return packet_2010_.has_detection() ? &packet_2010_.detection() : nullptr;
    return packet_2014_.has_detection() ? &packet_2014_.detection() : nullptr;
  }
  std::optional<world::Geometry> geometry() const {
    if (old_) return packet_2010_.has_geometry() ? wire::decode(packet_2010_.geometry()) : std::nullopt;
    return packet_2014_.has_geometry() ? wire::decode(packet_2014_.geometry()) : std::nullopt;
  }

 private:
  bool old_ = false;
  matchday::legacy2014::SSL_WrapperPacket packet_2010_;
  matchday::vision::SSL_WrapperPacket packet_2014_;
};

bool is_vision(const wire::LogRecord& record) {
  return record.type == wire::Vision2010 || record.type == wire::Vision2014;
}

// Everything that is known while a log is played.
class Reading {
 public:
  Reading(const Survey& survey, const Listener& listener) : survey_(survey), listener_(listener) {}

  void take(const wire::LogRecord& record);
  void finish() { emit(grouper_.flush()); }
  LogCount& count() { return count_; }

 private:
  void take_vision(const wire::LogRecord& record);
  void take_referee(const wire::LogRecord& record);
  void emit(std::span<const world::Detection> batch) {
    if (!batch.empty() && listener_.batch) listener_.batch(batch);
  }

  const Survey& survey_;
  const Listener& listener_;
  LogCount count_;
  tracker::FrameGrouper grouper_;
  std::optional<std::int64_t> batch_time_;  // of the record that began the batch
  VisionRecord vision_;
  matchday::referee::Referee referee_;
  world::Detection detection_;
};

void Reading::take(const wire::LogRecord& record) {
  if (count_.records.size() < most_types || count_.records.contains(record.type)) {
    ++count_.records[record.type];
  } else {
    ++count_.records_of_other_types;
  }
  const bool wanted = survey_.has_vision_2014 ? record.type == wire::Vision2014 : is_vision(record);
  if (wanted) take_vision(record);
  if (record.type == wire::Refbox2013) take_referee(record);
}

void Reading::take_vision(const wire::LogRecord& record) {
  if (!vision_.read(record)) throw std::runtime_error("the vision message in it cannot be read");
  if (listener_.geometry) {
    if (const auto geometry = vision_.geometry()) listener_.geometry(*geometry);
  }
  if (!vision_.detection() || !wire::usable(*vision_.detection())) return;
  wire::decode(*vision_.detection(), survey_.epoch, detection_);

  CameraCount& camera = count_.cameras[detection_.camera];
  if (camera.images++ == 0) camera.first = detection_.t_capture;
  camera.last = detection_.t_capture;

  if (survey_.ours() && batch_time_ && *batch_time_ != record.time_ns) emit(grouper_.flush());
  batch_time_ = record.time_ns;
  emit(grouper_.add(detection_));
}

void Reading::take_referee(const wire::LogRecord& record) {
  if (!wire::read(record, referee_)) throw std::runtime_error("the referee message in it cannot be read");
  const auto message = wire::decode(referee_, survey_.epoch);
  if (!message) {
    ++count_.referee_messages_unknown;
  } else if (listener_.message) {
    listener_.message(*message);
  }
}

}  // namespace

Survey survey_log(const std::filesystem::path& path) {
  wire::LogReader reader(path);
  wire::LogRecord record;
  Survey survey;
  std::optional<double> first_capture;
  VisionRecord vision;
  try {
    while (reader.next(record)) {
      if (is_vision(record) && vision.read(record)) {
        survey.has_vision = true;
        survey.has_vision_2014 |= record.type == wire::Vision2014;
        if (!survey.geometry) survey.geometry = vision.geometry();
        if (!first_capture && vision.detection() && wire::usable(*vision.detection())) {
          first_capture = vision.detection()->t_capture();
        }
      }
      matchday::referee::Referee referee;
      if (!survey.first_referee && wire::read(record, referee)) survey.first_referee = referee;
      const bool complete =
          survey.geometry && survey.first_referee && survey.has_vision_2014 && first_capture;
      if (complete || reader.records() >= records_to_survey) break;
    }
  } catch (const std::runtime_error&) {
    // What comes before the damage can still be read; read_log will find it again and say so.
  }
  if (!survey.ours() && first_capture) {
    survey.epoch.nanoseconds = static_cast<std::int64_t>(std::floor(*first_capture)) * 1'000'000'000;
  }
  return survey;
}

LogCount read_log(const std::filesystem::path& path, const Survey& survey, const Listener& listener) {
  wire::LogReader reader(path);
  wire::LogRecord record;
  Reading reading(survey, listener);
  const auto here = [&] { return path.string() + ": record " + std::to_string(reader.records()) + ": "; };
  try {
    while (reader.next(record)) {
      try {
        reading.take(record);
      } catch (const std::runtime_error& error) {
        reading.count().defect = here() + error.what();
        break;
      }
    }
  } catch (const std::runtime_error& error) {
    reading.count().defect = error.what();
  }
  reading.finish();
  if (reading.count().defect.empty() && reader.truncated()) reading.count().defect = reader.truncation();
  return reading.count();
}

}  // namespace autoref
