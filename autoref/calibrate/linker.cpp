#include "autoref/calibrate/linker.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace calibrate {
namespace {

using world::Vector2d;

// A contradicted track is the object nevertheless when it is long and seldom contradicted: two cameras see a
// ball in flight at two places.
constexpr std::size_t brief = 60;  // [images]

double worth(const Track& track) {
  Vector2d low = track.sightings.front().position;
  Vector2d high = low;
  for (const Sighting& s : track.sightings) {
    low = low.cwiseMin(s.position);
    high = high.cwiseMax(s.position);
  }
  return static_cast<double>(track.sightings.size()) * (1 + (high - low).norm());
}

// The accepted sightings by time, to ask where the object was.
class Whereabouts {
 public:
  void add(const Track& track) {
    for (const Sighting& s : track.sightings) bins_[bin(s.time)].push_back(s);
  }
  // +1: somebody saw it there, -1: somebody saw it elsewhere, 0: nobody saw it.
  int agrees(const Sighting& s) const {
    int vote = 0;
    double nearest = 0.02;  // [s]
    for (std::int64_t b = bin(s.time) - 1; b <= bin(s.time) + 1; ++b) {
      const auto found = bins_.find(b);
      if (found == bins_.end()) continue;
      for (const Sighting& other : found->second) {
        const double apart = std::abs(other.time - s.time);
        if (apart >= nearest) continue;
        nearest = apart;
        vote = (other.position - s.position).norm() < 0.15 + 10 * apart ? 1 : -1;
      }
    }
    return vote;
  }

 private:
  static std::int64_t bin(double time) { return static_cast<std::int64_t>(std::floor(time / 0.02)); }
  std::map<std::int64_t, std::vector<Sighting>> bins_;
};

}  // namespace

Vector2d velocity_before(const Track& track, std::size_t i) {
  constexpr double for_speed = 0.1;  // [s]
  const Sighting& last = track.sightings[i];
  std::size_t first = i;
  while (first > 0 && last.time - track.sightings[first - 1].time < for_speed) --first;
  if (first == i) return Vector2d::Zero();
  const Sighting& before = track.sightings[first];
  return (last.position - before.position) / (last.time - before.time);
}

void Linker::add(const std::vector<Sighting>& sightings) {
  if (sightings.empty()) return;
  const double now = sightings.front().time;
  std::erase_if(active_, [&](Track& track) {
    if (now - track.end() <= gate_.patience) return false;
    ended_.push_back(std::move(track));
    return true;
  });

  struct Pair {
    double distance;
    std::size_t track, sighting;
  };
  std::vector<Pair> pairs;
  for (std::size_t t = 0; t < active_.size(); ++t) {
    const double unseen = now - active_[t].end();
    const std::size_t last = active_[t].sightings.size() - 1;
    const Vector2d expected = active_[t].sightings[last].position +
                              velocity_before(active_[t], last) * std::min(unseen, gate_.inertia);
    const double gate = gate_.slack + std::min(gate_.speed * unseen, gate_.reach) + gate_.drift * unseen;
    for (std::size_t s = 0; s < sightings.size(); ++s) {
      const double distance = (sightings[s].position - expected).norm();
      if (distance < gate) pairs.push_back({distance, t, s});
    }
  }
  std::ranges::sort(pairs, [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
  std::vector<bool> track_taken(active_.size());
  std::vector<bool> sighting_taken(sightings.size());
  for (const Pair& pair : pairs) {
    if (track_taken[pair.track] || sighting_taken[pair.sighting]) continue;
    track_taken[pair.track] = sighting_taken[pair.sighting] = true;
    active_[pair.track].sightings.push_back(sightings[pair.sighting]);
  }
  for (std::size_t s = 0; s < sightings.size(); ++s) {
    if (!sighting_taken[s]) active_.push_back({camera_, {sightings[s]}});
  }
}

std::vector<Track> Linker::finish() {
  for (Track& track : active_) ended_.push_back(std::move(track));
  active_.clear();
  std::vector<Track> all = std::move(ended_);
  ended_.clear();
  return all;
}

Identity identify(std::vector<Track> tracks, std::size_t shortest) {
  std::ranges::stable_sort(tracks, [](const Track& a, const Track& b) { return worth(a) > worth(b); });
  Identity identity;
  Whereabouts known;
  for (Track& track : tracks) {
    std::size_t there = 0;
    std::size_t elsewhere = 0;
    for (const Sighting& s : track.sightings) {
      const int vote = known.agrees(s);
      there += vote > 0;
      elsewhere += vote < 0;
    }
    const std::size_t all = track.sightings.size();
    const bool contradicted = elsewhere > there;
    if (contradicted && 3 * elsewhere >= all) {
      identity.impostors.push_back(std::move(track));
    } else if (there == 0 && (all < shortest || (contradicted && all < brief))) {
      identity.unclear.push_back(std::move(track));
    } else {
      known.add(track);
      identity.object.push_back(std::move(track));
    }
  }
  return identity;
}

}  // namespace calibrate
