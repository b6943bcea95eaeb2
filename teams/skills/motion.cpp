#include "teams/skills/motion.h"

#include <algorithm>
#include <cmath>

#include "sim/world/time.h"

namespace skills {

Limits driving_limits(const world::RobotSpecs& specs, double share) {
  // The worse of both axes: profiles are planned along one line, whatever the heading.
  return {std::min(specs.max_speed, specs.max_speed_sideways),
          std::min(specs.max_acceleration, specs.max_acceleration_sideways) * share,
          std::min(specs.max_brake, specs.max_brake_sideways) * share};
}

Limits turning_limits(const world::RobotSpecs& specs, double share) {
  return {specs.max_angular_speed, specs.max_angular_acceleration * share, specs.max_angular_brake * share};
}

Profile::Profile(double distance, double speed, const Limits& limits) : speed_(speed) {
  const double vm = limits.speed;
  const double a = limits.acceleration;
  const double b = limits.brake;
  const double stop = speed * std::abs(speed) / (2 * b);  // where braking at once would end
  const double sign = distance < stop ? -1.0 : 1.0;
  double d = sign * distance;
  double v = sign * speed;
  if (v < 0) {  // moving away from where the rest of the motion lies: brake to rest first
    phases_[0] = {-v / b, sign * b};
    d += v * v / (2 * b);
    v = 0;
  }
  if (v > vm) {
    phases_[1] = {(v - vm) / b, -sign * b};
    d -= (v * v - vm * vm) / (2 * b);
    v = vm;
  }
  const double peak_square = (2 * a * b * d + b * v * v) / (a + b);
  if (peak_square <= vm * vm) {
    const double peak = std::max(v, std::sqrt(std::max(peak_square, 0.0)));
    phases_[2] = {(peak - v) / a, sign * a};
    phases_[4] = {peak / b, -sign * b};
  } else {
    const double cruise = d - (vm * vm - v * v) / (2 * a) - vm * vm / (2 * b);
    phases_[2] = {(vm - v) / a, sign * a};
    phases_[3] = {std::max(cruise, 0.0) / vm, 0};
    phases_[4] = {vm / b, -sign * b};
  }
}

double Profile::duration() const {
  double sum = 0;
  for (const Phase& phase : phases_) sum += phase.duration;
  return sum;
}

double Profile::position(double time) const {
  double x = 0;
  double v = speed_;
  for (const Phase& phase : phases_) {
    const double dt = std::clamp(time, 0.0, phase.duration);
    x += v * dt + 0.5 * phase.acceleration * dt * dt;
    v += phase.acceleration * dt;
    time -= phase.duration;
    if (time <= 0) break;
  }
  return x;
}

double Profile::velocity(double time) const {
  double v = speed_;
  for (const Phase& phase : phases_) {
    const double dt = std::clamp(time, 0.0, phase.duration);
    v += phase.acceleration * dt;
    time -= phase.duration;
    if (time <= 0) return v;
  }
  return 0;
}

double time_to_rest(double distance, double speed, const Limits& limits) {
  const double vm = limits.speed;
  const double a = limits.acceleration;
  const double b = limits.brake;
  const double sign = 2 * b * distance < speed * std::abs(speed) ? -1.0 : 1.0;  // braking ends beyond it
  double d = sign * distance;
  double v = sign * speed;
  double time = 0;
  if (v < 0) {
    time = -v / b;
    d += v * v / (2 * b);
    v = 0;
  } else if (v > vm) {
    time = (v - vm) / b;
    d -= (v * v - vm * vm) / (2 * b);
    v = vm;
  }
  const double peak_square = (2 * a * b * d + b * v * v) / (a + b);
  if (peak_square <= vm * vm) {
    const double peak = std::max(v, std::sqrt(std::max(peak_square, 0.0)));
    return time + (peak - v) / a + peak / b;
  }
  const double cruise = d - (vm * vm - v * v) / (2 * a) - vm * vm / (2 * b);
  return time + (vm - v) / a + std::max(cruise, 0.0) / vm + vm / b;
}

namespace {

// How two axes share the limits: cosine and sine of an angle.
struct Split {
  double along = 1;
  double across = 0;
};
constexpr int cells = 64;  // of the cosine

// The points that halving the cosines from 0.02 to 0.9998 comes upon: where two cells meet after six
// halvings, and the middle of each cell.
struct Splits {
  std::array<Split, cells> border;  // border[k] is below cell k; the first is not used
  std::array<Split, cells> middle;

  Splits() { halve(0.02, 0.9998, 0, cells); }
  static const Splits& all() {
    static const Splits splits;
    return splits;
  }

 private:
  void halve(double low, double high, std::size_t from, std::size_t to) {
    const double along = 0.5 * (low + high);
    const Split split{along, std::sqrt(1 - along * along)};
    if (to - from == 1) {
      middle[from] = split;
      return;
    }
    const std::size_t half = (from + to) / 2;
    border[half] = split;
    halve(low, along, from, half);
    halve(along, high, half, to);
  }
};

// The cell in which `is_later` turns from true to false, looked for around a guess and then by halving.
template <class IsLater>
int cell_where(int guess, const IsLater& is_later) {
  const auto above = [&](int border) {
    return is_later(Splits::all().border[static_cast<std::size_t>(border)]);
  };
  int low = 0;
  int high = cells - 1;
  guess = std::clamp(guess, low, high);
  for (int step = 1; low < high && guess > low && guess <= high; step *= 4) {
    if (above(guess)) {
      low = guess;
      guess += step;
    } else {
      high = guess - 1;
      guess -= step;
    }
  }
  while (low < high) {
    const int border = (low + high + 1) / 2;
    if (above(border)) {
      low = border;
    } else {
      high = border - 1;
    }
  }
  return low;
}

}  // namespace

Drive::Drive(const Vector2d& to_target, const Vector2d& velocity, const Limits& limits, int* cell) {
  const double distance = to_target.norm();
  const double speed = velocity.norm();
  if (distance > 1e-6) {
    axis_ = to_target / distance;
  } else if (speed > 1e-6) {
    axis_ = velocity / speed;
  }
  const double v_along = velocity.dot(axis_);
  const double v_across = velocity.dot(Vector2d(-axis_.y(), axis_.x()));
  const auto share = [&limits](double part) {
    return Limits{limits.speed * part, limits.acceleration * part, limits.brake * part};
  };
  double along = 1;  // cosine of the angle that splits the limits
  double across = 0.02;
  if (std::abs(v_across) > 0.01) {
    // T_along falls and T_across rises with the cosine.
    // Across the line it brakes, comes back and brakes. With a share c of the limits this takes
    // across_time / c, and no more speed than the peak while the limit of the speed is above.
    const double a = limits.acceleration, b = limits.brake;
    const double peak = std::abs(v_across) * std::sqrt(a / (a + b));
    const double across_time = std::abs(v_across) / b + peak / a + peak / b;
    const auto along_is_later = [&](const Split& split) {
      const double time = peak <= limits.speed * split.across
                              ? across_time / split.across
                              : time_to_rest(0, v_across, share(split.across));
      return time_to_rest(distance, v_along, share(split.along)) > time;
    };
    int none = 0;
    int& found = cell != nullptr ? *cell : none;
    found = cell_where(found, along_is_later);
    const Split& split = Splits::all().middle[static_cast<std::size_t>(found)];
    along = split.along;
    across = split.across;
  }
  along_ = Profile(distance, v_along, share(along));
  across_ = Profile(0, v_across, share(across));
}

Vector2d Drive::position(double time) const {
  return axis_ * along_.position(time) + Vector2d(-axis_.y(), axis_.x()) * across_.position(time);
}

Vector2d Drive::velocity(double time) const {
  return axis_ * along_.velocity(time) + Vector2d(-axis_.y(), axis_.x()) * across_.velocity(time);
}

Vector2d cross_track_velocity(const Vector2d& to_target, const Vector2d& velocity, const Vector2d& along,
                              const Limits& limits) {
  const auto axis = [&](const Vector2d& unit, double share) -> Vector2d {
    const Limits part{limits.speed * share, limits.acceleration * share, limits.brake * share};
    return unit * Profile(to_target.dot(unit), velocity.dot(unit), part).velocity(world::tick_length);
  };
  return axis(along, along_track_share) + axis({-along.y(), along.x()}, 0.85);
}

double travel_time(const Vector2d& to_target, const Vector2d& velocity, const Limits& limits) {
  const double distance = to_target.norm();
  if (distance < 1e-6) return velocity.norm() / limits.brake;
  const double along = velocity.dot(to_target) / distance;
  const double across = std::sqrt(std::max(velocity.squaredNorm() - along * along, 0.0));
  return time_to_rest(distance, along, limits) + 0.5 * across / limits.brake;
}

double time_to_touch(const Vector2d& to_target, const Vector2d& velocity, const Limits& limits,
                     double reach) {
  const double d = to_target.norm() - reach;
  if (d <= 0) return 0;
  const double v = velocity.dot(to_target) / (d + reach);
  const double a = limits.acceleration;
  const double vm = limits.speed;
  double time = 0;
  double left = d;
  double from = v;
  if (from < 0) {
    time = -from / limits.brake;
    left += from * from / (2 * limits.brake);
    from = 0;
  }
  from = std::min(from, vm);
  const double speeding_up = (vm * vm - from * from) / (2 * a);
  if (left <= speeding_up) return time + (std::sqrt(from * from + 2 * a * left) - from) / a;
  return time + (vm - from) / a + (left - speeding_up) / vm;
}

}  // namespace skills
