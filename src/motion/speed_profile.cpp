#include "speed_profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "step_bounds.hpp"

namespace symscene {
namespace {

/// A whole line, or a step of an arc.
struct Step {
  std::size_t segment = 0;
  double begin = 0.0;
  double end = 0.0;

  double length() const { return end - begin; }
};

/// The bounds of ds/dt and d²s/dt² on a line.
struct LineLimits {
  double speed = std::numeric_limits<double>::infinity();
  double acceleration = std::numeric_limits<double>::infinity();

  LineLimits(const PathSegment& line, const MotionLimits& limits) {
    for (Eigen::Index i = 0; i < line.tangent.size(); ++i) {
      const double slope = std::abs(line.tangent[i]);
      if (slope == 0.0) continue;
      speed = std::min(speed, limits.velocity[i] / slope);
      acceleration = std::min(acceleration, limits.acceleration[i] / slope);
    }
  }
};

/// The fastest motion between two stops.
class Section {
 public:
  Section(const JointPath& path, std::size_t begin, std::size_t end, const MotionLimits& limits,
          double arc_step)
      : path_(path), limits_(limits) {
    for (std::size_t i = begin; i < end; ++i) add_steps(i, arc_step);
  }

  /// Appends the phases, which start at `time`. Returns when they end.
  double append_phases(double time, std::vector<MotionPhase>& phases) {
    find_controllable_speeds();
    double x = 0.0;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const bool is_line = path_.segments()[steps_[i].segment].is_line();
      x = is_line ? run_line(i, x, time, phases) : run_arc(i, x, time, phases);
    }
    return time;
  }

 private:
  void add_steps(std::size_t segment, double arc_step) {
    constexpr double fewest = 8.0;
    const PathSegment& piece = path_.segments()[segment];
    const double count =
        piece.is_line() ? 1.0 : std::max(fewest, std::ceil(piece.length / piece.radius / arc_step));
    for (double i = 0.0; i < count; i += 1.0) {
      steps_.push_back({segment, piece.length * (i / count), piece.length * ((i + 1.0) / count)});
    }
  }

  /// most_[i]: the greatest x at the start of step i from which the section can be finished.
  void find_controllable_speeds() {
    most_.assign(steps_.size() + 1, 0.0);
    for (std::size_t i = steps_.size(); i-- > 0;) {
      const PathSegment& segment = path_.segments()[steps_[i].segment];
      if (segment.is_line()) {
        const LineLimits line(segment, limits_);
        const double fastest = line.speed * line.speed;
        most_[i + 1] = std::min(most_[i + 1], fastest);
        most_[i] = std::min(fastest, most_[i + 1] + 2.0 * line.acceleration * steps_[i].length());
      } else {
        bound_step(i);
        most_[i] = bounds_.greatest_start();
      }
    }
  }

  void bound_step(std::size_t i) {
    bounds_.set_arc(path_.segments()[steps_[i].segment], steps_[i].begin, steps_[i].end, limits_);
    bounds_.bound_end(most_[i + 1]);
  }

  /// Accelerates, keeps the speed, brakes. Returns x at the end.
  double run_line(std::size_t i, double x, double& time, std::vector<MotionPhase>& phases) const {
    const Step& step = steps_[i];
    const LineLimits line(path_.segments()[step.segment], limits_);
    const double gain = 2.0 * line.acceleration * step.length();
    const double end = std::min(most_[i + 1], x + gain);
    const double peak =
        std::max(std::min(line.speed * line.speed, 0.5 * (x + end + gain)), std::max(x, end));
    const double up = std::clamp((peak - x) / gain, 0.0, 1.0) * step.length();
    const double down =
        std::min(std::clamp((peak - end) / gain, 0.0, 1.0) * step.length(), step.length() - up);
    MotionPhase phase{step.segment, time, 0.0, 0.0, std::sqrt(x), line.acceleration};
    run_phase(phase, up, std::sqrt(peak), phases);
    phase.acceleration = 0.0;
    run_phase(phase, step.length() - up - down, std::sqrt(peak), phases);
    phase.acceleration = -line.acceleration;
    run_phase(phase, down, std::sqrt(end), phases);
    time = phase.time;
    return end;
  }

  double run_arc(std::size_t i, double x, double& time, std::vector<MotionPhase>& phases) {
    bound_step(i);
    const Step& step = steps_[i];
    const double u = bounds_.greatest_acceleration(x);
    const double end = std::clamp(x + 2.0 * u * step.length(), 0.0, most_[i + 1]);
    MotionPhase phase{step.segment, time, 0.0, step.begin, std::sqrt(x), u};
    run_phase(phase, step.length(), std::sqrt(end), phases);
    time = phase.time;
    return end;
  }

  /// Appends a phase over a distance, then makes it the start of the next one.
  static void run_phase(MotionPhase& phase, double distance, double end_speed,
                        std::vector<MotionPhase>& phases) {
    if (distance <= 0.0) return;
    phase.duration = 2.0 * distance / (phase.speed + end_speed);
    if (phase.time + phase.duration > phase.time) phases.push_back(phase);
    phase.time += phase.duration;
    phase.s += distance;
    phase.speed = end_speed;
  }

  const JointPath& path_;
  const MotionLimits& limits_;
  std::vector<Step> steps_;
  std::vector<double> most_;
  StepBounds bounds_;
};

}  // namespace

std::vector<MotionPhase> speed_profile(const JointPath& path, const MotionLimits& limits,
                                       double arc_step) {
  std::vector<MotionPhase> phases;
  double time = 0.0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < path.segments().size(); ++i) {
    if (!path.stops_after(i)) continue;
    time = Section(path, begin, i + 1, limits, arc_step).append_phases(time, phases);
    begin = i + 1;
  }
  return phases;
}

}  // namespace symscene
