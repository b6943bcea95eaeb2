#include "experiments/runner/program_watch.h"

#include <unistd.h>

#include <array>
#include <cstring>
#include <deque>
#include <stdexcept>

namespace runner {
namespace {

namespace fs = std::filesystem;

constexpr int most_links = 40;  // that the system follows (path_resolution(7))

bool alike(const struct stat& one, const struct stat& other) {
  const auto same = [](const timespec& a, const timespec& b) {
    return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec;
  };
  return one.st_dev == other.st_dev && one.st_ino == other.st_ino && one.st_size == other.st_size &&
         same(one.st_mtim, other.st_mtim) && same(one.st_ctim, other.st_ctim);
}

}  // namespace

std::string sentence(const ProgramChange& change) {
  return "program " + change.file.string() + " was changed while the experiment ran" +
         (change.restored
              ? ", though it is now as before: games that another program may have played are thrown away"
              : ": games with the new one belong to another experiment; restore it and start again, or give "
                "another --out");
}

ProgramWatch::ProgramWatch(std::span<const ProgramFile> files)
    : events_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
  for (const ProgramFile& file : files) {
    if (file.names.empty()) entries_.push_back({file.path, file.hash});
    for (const fs::path& name : file.names) entries_.push_back({name, file.hash});
  }
  for (std::size_t i = 0; i < entries_.size(); ++i) watch(i);  // looked at once by the first changed()
}

ProgramWatch::~ProgramWatch() {
  if (events_ >= 0) ::close(events_);
}

/// Goes the way that the system goes from the root to the file.
void ProgramWatch::watch(std::size_t entry) {
  if (events_ < 0) return;
  std::erase_if(watches_, [entry](const auto& one) { return one.second == entry; });
  const auto parts = [](const fs::path& path) {
    const fs::path relative = path.relative_path();
    return std::deque<fs::path>(relative.begin(), relative.end());
  };
  fs::path place = "/";
  std::error_code error;
  std::deque<fs::path> left = parts(fs::absolute(entries_[entry].name, error));
  for (int links = 0; !left.empty();) {
    const fs::path part = left.front();
    left.pop_front();
    if (part.empty() || part == ".") continue;
    if (part == "..") {
      place = place.parent_path();
      continue;
    }
    add(place, part.string(), entry);
    const fs::path target = fs::read_symlink(place / part, error);
    if (error) {
      place /= part;
      continue;
    }
    if (++links > most_links) return;
    if (target.is_absolute()) place = "/";
    const std::deque<fs::path> more = parts(target);
    left.insert(left.begin(), more.begin(), more.end());
  }
  add(place, "", entry);
}

/// One whose folder may not be read is not watched.
void ProgramWatch::add(const fs::path& path, const std::string& name, std::size_t entry) {
  constexpr std::uint32_t names =
      IN_CREATE | IN_DELETE | IN_MOVED_FROM | IN_MOVED_TO | IN_MODIFY | IN_ONLYDIR;
  const int watch = ::inotify_add_watch(events_, path.c_str(), name.empty() ? IN_MODIFY : names);
  if (watch >= 0) watches_.emplace(std::pair(watch, name), entry);
}

void ProgramWatch::listen() {
  alignas(inotify_event) std::array<char, 65536> buffer;
  while (events_ >= 0) {
    const ssize_t count = ::read(events_, buffer.data(), buffer.size());
    if (count <= 0) return;
    for (std::size_t at = 0; at < static_cast<std::size_t>(count);) {
      inotify_event event{};
      std::memcpy(&event, buffer.data() + at, sizeof event);
      const char* name = buffer.data() + at + sizeof event;
      note(event, event.len > 0 ? std::string(name, ::strnlen(name, event.len)) : std::string());
      at += sizeof event + event.len;
    }
  }
}

void ProgramWatch::note(const inotify_event& event, const std::string& name) {
  if ((event.mask & IN_Q_OVERFLOW) != 0) {
    for (Entry& entry : entries_) entry.unsure = true;
  }
  const auto [first, last] = watches_.equal_range(std::pair(event.wd, name));
  for (auto one = first; one != last; ++one) {
    Entry& entry = entries_[one->second];
    if ((event.mask & IN_MOVED_TO) != 0) {
      ++entry.replaced;
    } else if ((event.mask & (IN_CREATE | IN_DELETE | IN_MOVED_FROM | IN_MODIFY)) != 0) {
      entry.touched = true;
    }
  }
}

std::optional<ProgramChange> ProgramWatch::changed() {
  listen();
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    Entry& entry = entries_[i];
    struct stat now {};
    if (::stat(entry.name.c_str(), &now) != 0) return ProgramChange{entry.name};
    const bool news = entry.touched || entry.replaced > 0;
    if (!news && alike(now, entry.seen)) {
      entry.unsure = false;
      continue;
    }
    if (news) watch(i);  // before it is read: other names may lead to it now
    try {
      if (program_file(entry.name).hash != entry.hash) return ProgramChange{entry.name};
    } catch (const std::invalid_argument&) {
      return ProgramChange{entry.name};
    }
    if (entry.touched || entry.unsure || entry.replaced > 1) return ProgramChange{entry.name, true};
    entry.replaced = 0;
    entry.seen = now;
  }
  return std::nullopt;
}

}  // namespace runner
