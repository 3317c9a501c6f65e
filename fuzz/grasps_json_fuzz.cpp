#include <cstdlib>
#include <string>

#include "accepted.hpp"
#include "symscene/io/grasps.hpp"

/// Any bytes are grasps that stay the same in number and order when they are written and read
/// again, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const std::string_view bytes = fuzz::as_bytes(data, size);
  const auto file = fuzz::accepted([&] { return parse_grasps_json(bytes, "fuzz"); });
  if (!file) return 0;
  const GraspFile again = parse_grasps_json(format_grasps_json(file->plan, file->gripper), "again");
  if (again.plan.grasps.size() != file->plan.grasps.size() ||
      again.plan.rejected.size() != file->plan.rejected.size() ||
      again.plan.objects.size() != file->plan.objects.size())
    std::abort();
  for (std::size_t i = 0; i < again.plan.grasps.size(); ++i) {
    const Grasp &a = file->plan.grasps[i], &b = again.plan.grasps[i];
    if (a.object != b.object || a.quality != b.quality || a.opening != b.opening) std::abort();
  }
  return 0;
}
