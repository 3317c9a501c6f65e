#include "symscene/occupancy/outward_vote.hpp"

namespace symscene {

OutwardVote outward_vote(const DistanceField& field, const std::optional<Plane>& table,
                         const OutwardVoteOptions& options) {
  options.validate();
  const Eigen::Vector3f up =
      table ? Eigen::Vector3f(table->normal.cast<float>()) : Eigen::Vector3f::UnitZ();
  return [&field, up, step = static_cast<float>(options.step), up_weight = options.up_weight](
             const Eigen::Vector3f& p, const Eigen::Vector3f& n) {
    const float freer = field.at(p + step * n) - field.at(p - step * n);
    return double{freer} + up_weight * double{n.dot(up)};
  };
}

}  // namespace symscene
