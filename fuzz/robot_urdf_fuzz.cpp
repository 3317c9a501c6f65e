#include <cstdlib>
#include <string>
#include <vector>

#include "accepted.hpp"
#include "symscene/io/robot.hpp"

/// Any bytes are a robot in URDF that is a valid tree with finite poses, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const std::string_view bytes = fuzz::as_bytes(data, size);
  std::vector<std::string> warnings;
  const auto model = fuzz::accepted([&] { return parse_urdf(bytes, "fuzz", {}, warnings); });
  if (!model) return 0;
  model->validate();
  const Eigen::VectorXd zero =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model->moving_joints()));
  if (link_poses(*model, zero).size() != model->links.size()) std::abort();
  return 0;
}
