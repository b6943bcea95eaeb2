#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "autoref/touch/likelihood.h"
#include "autoref/touch/trail.h"
#include "autoref/touch/views.h"
#include "sim/world/field.h"
#include "sim/world/tracked_frame.h"

namespace touch {

/// Who touched the ball last, as a probability for each robot: contact is weighed against free motion.
///
/// While the ball is near robots (a visit) every six sightings are judged by themselves; when it has left
/// them, what it did in between is judged once more by its course before and after.
class LastToucher {
 public:
  explicit LastToucher(const world::Geometry& geometry, LikelihoodParams params = {})
      : field_(geometry.field), params_(params), trail_(geometry) {}

  /// Appends what the next frame tells: a new touch, or an old one, with its old time,
  /// whose probability changed.
  /// @param second_opinion  the last touch as other algorithms see it; asked when the ball has left the field
  void update(const world::TrackedFrame& frame, std::span<const world::Detection> images,
              const std::optional<world::Touch>& second_opinion, std::vector<world::Touch>& out);
  void update(const world::TrackedFrame& frame, std::span<const world::Detection> images,
              std::vector<world::Touch>& out) {
    update(frame, images, {}, out);
  }

  void reset();

 private:
  using Beliefs = std::array<double, robot_slots>;

  /// The ball near robots.
  struct Visit {
    Beliefs before{};      // who touched it last when it came
    Beliefs within{};      // and since then
    double untouched = 1;  // nobody did
    int windows = 0;       // judged
    world::Time begin;
    double closest = 1;            // [m] least gap
    std::size_t nearest = 0;       // whose
    std::optional<Course> course;  // of the ball when it came
    int camera = 0;                // that saw it come
  };

  /// Whether the ball is so far outside that a touch there is not the last one before it left.
  bool is_out(const Vector2d& ball) const;
  void judge_hidden(const world::TrackedFrame& frame);
  /// A robot that a flying ball bounced off has touched it.
  void believe_strike(const world::TrackedBall& ball);
  void judge_window(const View& view, const world::TrackedBall& ball, double airborne);
  /// Whether a ball in flight was above or beside the robot that long ago [s].
  bool flies_past(const world::TrackedBall& ball, double ago, const Sighting::Robot& robot) const;
  void end_visit(const View& view);
  /// The ball has just left the field: its whole way is gone through again.
  void look_back(const std::optional<world::Touch>& second_opinion, std::vector<world::Touch>& out);
  void remember(std::size_t robot, world::Time when, const Vector2d& place);
  void tell(std::optional<std::size_t> fresh, std::vector<world::Touch>& out);
  double noise_of(const View& view) const { return view.tracked() ? params_.tracked_sigma : views_.noise(); }

  world::Field field_;
  LikelihoodParams params_;
  Views views_;
  Trail trail_;
  int outside_ = 0;  // quarters of sightings in a row of a ball wholly outside
  std::optional<Visit> visit_;
  std::optional<world::Time> flew_;    // when the ball was last known to be in the air
  std::optional<world::Time> struck_;  // when a robot struck the ball in the air
  Beliefs belief_{};
  Beliefs at_the_time_{};                          // before the ball's way was gone through again
  std::array<world::Touch, robot_slots> first_{};  // of each robot, its last contact: when it began
  std::array<world::Touch, robot_slots> last_{};   // when it was likely last
  std::array<world::Touch, robot_slots> sure_{};   // and when it was sure last
  std::optional<std::size_t> fresh_;               // who surely touched it in this window
  std::optional<std::size_t> told_;                // slot of `told_touch_`
  world::Touch told_touch_;
};

}  // namespace touch
