#include "sweep_arguments.hpp"

#include "symscene/core/error.hpp"
#include "thinned_sequence.hpp"

namespace symscene::app {
namespace {

bool has_pose(const DepthSequence& sequence) {
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    if (sequence.pose(i)) return true;
  }
  return false;
}

}  // namespace

void SweepArguments::add_to(Arguments& arguments) {
  arguments.sequence_options(source);
  arguments.every(every, "use every N-th frame (default 1)");
  arguments.choice("--poses", poses, {"exact", "start"},
                   "use the sequence's poses as they are, or as initial poses of tracking");
  table.add_to(arguments, "the table plane a,b,c,d with ax + by + cz + d = 0");
  sensor.add_to(arguments);
}

std::unique_ptr<DepthSequence> SweepArguments::open(Session& session) const {
  auto sequence = every_nth(open_sequence(path, source), step());
  session.warn(sequence->warnings());
  if (uses_poses() && !has_pose(*sequence))
    throw InputError(path.string(), "poses, which --poses needs", "none");
  return sequence;
}

ReportedSensor SweepArguments::choose_sensor(const DepthSequence& sequence,
                                             const MeasurementOptions& measurement,
                                             const SensorEstimationOptions& options,
                                             Session& session) const {
  const bool tracked = sequence.size() > 1;
  return sensor.choose(sequence, tracked,
                       {sequence.depth_scale(), measurement.min_depth, measurement.max_depth},
                       options, session);
}

std::optional<Eigen::Isometry3d> SweepArguments::given_pose(const DepthSequence& sequence,
                                                            std::size_t i) const {
  return uses_poses() ? sequence.pose(i) : std::nullopt;
}

}  // namespace symscene::app
