#include <cstdlib>
#include <string>

#include "accepted.hpp"
#include "io/pose_formats.hpp"
#include "symscene/io/trajectory.hpp"

/// Any bytes are a trajectory that keeps its number of poses when written and read, or refused; the
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
