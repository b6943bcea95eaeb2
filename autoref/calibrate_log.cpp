#include "autoref/calibrate_log.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <system_error>

#include "autoref/calibrate/calibration.h"
#include "autoref/log.h"

namespace autoref {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_cameras = 64;  // ours: the league has four

void require_writable(const fs::path& path) {
  const auto refuse = [&](const std::string& why) {
    throw std::runtime_error(path.string() + ": " + why + "; name a file for --out");
  };
  std::error_code error;
  if (fs::is_directory(path, error)) refuse("is a folder");
  if (fs::exists(path, error) && !fs::is_regular_file(path, error)) refuse("is not a file");
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) refuse("its folder does not exist");
}

// Beside the target first, so that nobody ever reads half a preset.
void write_whole(const fs::path& path, const std::string& text) {
  fs::path beside = path;
  beside += ".part" + std::to_string(getpid());
  std::ofstream file(beside, std::ios::binary);
  file << text;
  file.close();
  std::error_code error;
  if (file) fs::rename(beside, path, error);
  if (!file || error) {
    std::error_code ignored;
    fs::remove(beside, ignored);
    throw std::runtime_error(path.string() + ": cannot be written" + (error ? ": " + error.message() : ""));
  }
}

std::string title_of(const CalibrateOptions& options, const calibrate::Observations& seen) {
  double seconds = 0;
  std::size_t images = 0;
  for (const calibrate::CameraImages& camera : seen.cameras) {
    seconds = std::max(seconds, camera.seconds());
    images += camera.times.size();
  }
  return fmt::format("{}: {:.1f} s, {} cameras, {} images, {} robots", options.file.filename().string(),
                     seconds, seen.cameras.size(), images, seen.robots.size());
}

}  // namespace

int calibrate_log(const CalibrateOptions& options, std::ostream& out, std::ostream& errors) {
  if (!options.out.empty()) {
    require_writable(options.out);
    std::error_code error;
    if (fs::equivalent(options.out, options.file, error)) {
      throw std::runtime_error(options.out.string() + ": is the log itself; name another file for --out");
    }
  }
  const Survey survey = survey_log(options.file);
  calibrate::Observer observer(options.most_kept);
  Listener listener;
  listener.batch = [&](std::span<const world::Detection> batch) {
    for (const world::Detection& image : batch) observer.add(image);
  };
  std::optional<world::Geometry> geometry;
  listener.geometry = [&](const world::Geometry& told) {
    if (!geometry) geometry = told;
    for (const world::Camera& camera : told.cameras) {
      if (geometry->cameras.size() >= most_cameras) return;
      if (std::ranges::find(geometry->cameras, camera.id, &world::Camera::id) == geometry->cameras.end()) {
        geometry->cameras.push_back(camera);
      }
    }
  };
  const LogCount count = read_log(options.file, survey, listener);
  if (count.cameras.empty()) {
    throw std::runtime_error(
        count.defect.empty() ? options.file.string() + ": holds no images to calibrate from" : count.defect);
  }
  const bool all = !observer.full();
  const calibrate::Observations seen = observer.finish();
  const calibrate::Report report = calibrate::calibrated(seen, geometry);
  const std::string title = title_of(options, seen);
  if (options.json) {
    out << calibrate::to_json(report, title);
  } else {
    out << title << "\n\n" << calibrate::to_table(report);
  }
  if (!options.out.empty()) write_whole(options.out, calibrate::to_toml(report, title));
  out.flush();
  if (!all) {
    errors << "ssl-autoref: " << options.file.string() << ": only its beginning was measured, since "
           << options.most_kept
           << " images and objects in them are as many as are kept; cut the log to measure another part\n";
  }
  if (!count.defect.empty()) {
    errors << "ssl-autoref: " << count.defect << '\n';
    return 2;
  }
  if (!geometry) {
    errors << "ssl-autoref: " << options.file.string()
           << ": holds no geometry, so height and overlap of the cameras are left out\n";
    return 2;
  }
  return 0;
}

}  // namespace autoref
