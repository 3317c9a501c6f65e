#include <algorithm>

#include "symscene/robots/robot_model.hpp"

namespace symscene {
namespace {

using LinkPair = std::pair<std::size_t, std::size_t>;

/// Whether a moving joint connects the two bodies.
bool connected(const RobotModel& model, const std::vector<std::size_t>& bodies, std::size_t body_a,
               std::size_t body_b) {
  return std::any_of(model.joints.begin(), model.joints.end(), [&](const Joint& joint) {
    const LinkPair ends(bodies[joint.parent], bodies[joint.child]);
    return ends == LinkPair(body_a, body_b) || ends == LinkPair(body_b, body_a);
  });
}

bool ignores(const RobotModel& model, const std::vector<std::size_t>& bodies,
             const LinkPair& pair) {
  const auto [a, b] = pair;
  if (model.links[a].capsules.empty() || model.links[b].capsules.empty()) return true;
  if (bodies[a] == bodies[b] || connected(model, bodies, bodies[a], bodies[b])) return true;
  return std::find(model.ignored_pairs.begin(), model.ignored_pairs.end(), pair) !=
         model.ignored_pairs.end();
}

}  // namespace

std::vector<std::size_t> rigid_bodies(const RobotModel& model) {
  std::vector<std::size_t> bodies(model.links.size());
  for (const Joint& joint : model.joints)
    bodies[joint.child] = joint.position ? joint.child : bodies[joint.parent];
  return bodies;
}

bool ignores_collision(const RobotModel& model, std::size_t link_a, std::size_t link_b) {
  return ignores(model, rigid_bodies(model), std::minmax(link_a, link_b));
}

std::vector<LinkPair> self_collision_pairs(const RobotModel& model) {
  const std::vector<std::size_t> bodies = rigid_bodies(model);
  std::vector<LinkPair> pairs;
  for (std::size_t a = 0; a < model.links.size(); ++a) {
    for (std::size_t b = a + 1; b < model.links.size(); ++b) {
      if (!ignores(model, bodies, {a, b})) pairs.emplace_back(a, b);
    }
  }
  return pairs;
}

}  // namespace symscene
