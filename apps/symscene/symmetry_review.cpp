#include "symmetry_review.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "io/atomic_file.hpp"
#include "symscene/symmetry/group_review.hpp"

namespace symscene::app {
namespace {

using Kind = ReviewedSymmetry::Kind;

const double same_angle = radians(1.0);
static_assert(ReviewChoice::continuous == GroupAxis::continuous);
constexpr double same_distance = 0.01;  ///< by the diagonal

const char* const rejected_choice = "rejected";
const char* const open_choice = "open";

/// The sphere, then axes and planes in the order of the group.
std::vector<ReviewedSymmetry> listed(const SymmetryGroup& group) {
  std::vector<ReviewedSymmetry> symmetries;
  if (group.sphere)
    symmetries.push_back(
        {Kind::sphere, 0, group.center, Eigen::Vector3d::UnitZ(), group.sphere_residual});
  for (const GroupAxis& found : group.axes)
    symmetries.push_back(
        {Kind::axis, found.order, found.axis.point, found.axis.direction, found.residual});
  for (const GroupPlane& found : group.planes)
    symmetries.push_back({Kind::plane, 0, found.plane.point, found.plane.normal, found.residual});
  return symmetries;
}

bool is_same(const ReviewedSymmetry& symmetry, const Eigen::Vector3d& point,
             const Eigen::Vector3d& direction, double max_distance) {
  if (symmetry.kind == Kind::sphere) return true;
  if (line_angle(symmetry.direction, direction) > same_angle) return false;
  const Eigen::Vector3d apart = point - symmetry.point;
  const double along = symmetry.direction.dot(apart);
  const double distance =
      symmetry.kind == Kind::plane ? std::abs(along) : (apart - along * symmetry.direction).norm();
  return distance <= max_distance;
}

std::string describe(const GroupAxis& found) {
  const Eigen::Vector3d& d = found.axis.direction;
  const std::string order =
      found.order == GroupAxis::continuous ? "continuous" : fmt::format("{}-fold", found.order);
  return fmt::format("the {} axis along ({:.2f}, {:.2f}, {:.2f})", order, d.x(), d.y(), d.z());
}

std::string describe(const GroupPlane& found) {
  const Eigen::Vector3d& n = found.plane.normal;
  return fmt::format("the plane with normal ({:.2f}, {:.2f}, {:.2f})", n.x(), n.y(), n.z());
}

template <class Symmetry>
void append_implied(const std::string& name, const std::vector<Symmetry>& all,
                    const std::vector<std::size_t>& implied, std::vector<std::string>& sentences) {
  for (const std::size_t k : implied)
    sentences.push_back(fmt::format(
        "{}: {} is left out too: with the remaining symmetries it would generate a rejected one",
        name, describe(all[k])));
}

}  // namespace

ReviewedModel reviewed_model(const ModelSymmetries& symmetries, TriangleMesh mesh) {
  return {symmetries.name,     std::move(mesh),           symmetries.millimetres,
          symmetries.diameter, symmetries.group.diagonal, listed(symmetries.group)};
}

ReviewChoices::ReviewChoices(const std::filesystem::path& file)
    : models_(parse_review_choices(read_file(file), file.string())) {}

std::vector<std::string> ReviewChoices::apply(ModelSymmetries& model) const {
  const auto found = models_.find(model.name);
  if (found == models_.end())
    return {model.name + " was not reviewed; all its symmetries are kept"};
  const std::vector<ReviewedSymmetry> symmetries = listed(model.group);
  RejectedSymmetries out;
  int undecided = 0;
  for (const ReviewedSymmetry& symmetry : symmetries) {
    const auto choice =
        std::find_if(found->second.begin(), found->second.end(), [&](const ReviewChoice& each) {
          return each.kind == to_string(symmetry.kind) &&
                 each.order.value_or(symmetry.order) == symmetry.order &&
                 is_same(symmetry, each.point, each.direction,
                         same_distance * model.group.diagonal);
        });
    const bool is_known = choice != found->second.end() && choice->choice != open_choice;
    const bool is_rejected = is_known && choice->choice == rejected_choice;
    if (!is_known) ++undecided;
    if (symmetry.kind == Kind::sphere) out.sphere = is_rejected;
    if (symmetry.kind == Kind::axis) out.axes.push_back(is_rejected);
    if (symmetry.kind == Kind::plane) out.planes.push_back(is_rejected);
  }
  std::vector<std::string> sentences;
  if (undecided > 0)
    sentences.push_back(fmt::format("{}: {} of {} symmetries were not reviewed and are kept",
                                    model.name, undecided, symmetries.size()));
  RemainingGroup remaining = without(model.group, out);
  append_implied(model.name, model.group.axes, remaining.implied_axes, sentences);
  append_implied(model.name, model.group.planes, remaining.implied_planes, sentences);
  model.group = std::move(remaining.group);
  return sentences;
}

}  // namespace symscene::app
