#include <cstdlib>
#include <string>

#include "accepted.hpp"
#include "symscene/io/trajectory.hpp"

/// Any bytes are a trajectory that is written and read back with as many poses, or refused; the
/// same bytes are a matrix or a log, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const std::string_view bytes = fuzz::as_bytes(data, size);
  fuzz::accepted([&] { return parse_pose_matrix(bytes, "fuzz"); });
  fuzz::accepted([&] { return parse_trajectory_log(bytes, "fuzz"); });
  const auto trajectory = fuzz::accepted([&] { return parse_trajectory(bytes, "fuzz"); });
  if (!trajectory) return 0;
  const Trajectory again = parse_trajectory(format_trajectory(*trajectory), "again");
  if (again.size() != trajectory->size()) std::abort();
  return 0;
}
