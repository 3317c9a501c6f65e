#include "symscene/clutter/grasp_execution.hpp"

#include <algorithm>
#include <cmath>

namespace symscene {
namespace {

/// A hand in the middle of a grasp.
class Execution {
 public:
  Execution(GraspWorld& world, const Eigen::Isometry3d& T_table_tool,
            const GraspExecutionOptions& options)
      : world_(world), grasp_(T_table_tool), options_(options) {}

  GraspOutcome run() {
    if (!start()) return outcome_;
    approach();
    close();
    retreat();
    return outcome_;
  }

 private:
  Eigen::Vector3d direction() const { return grasp_.linear().col(2); }

  /// Returns whether the hand is free where it starts.
  bool start() {
    hand_ = grasp_.translation() - options_.approach * direction();
    Eigen::Isometry3d T_table_start = grasp_;
    T_table_start.translation() = hand_;
    world_.put_hand(T_table_start);
    outcome_.width = outcome_.closed_width = world_.opening();
    outcome_.short_by = options_.approach;
    return !note_contact();
  }

  /// Whether the hand touches anything; if so it is noted.
  bool note_contact() {
    const HandContacts contacts = world_.hand_contacts();
    if (!contacts.any()) return false;
    outcome_.contact = contacts.table ? ApproachContact::table : ApproachContact::body;
    if (!contacts.bodies.empty()) outcome_.body = contacts.bodies.front();
    return true;
  }

  /// Moves the hand straight in steps, while `go_on`.
  template <class GoOn>
  void move(const Eigen::Vector3d& target, const GoOn& go_on) {
    const Eigen::Vector3d way = target - hand_;
    const int steps = std::max(1, static_cast<int>(std::lround(way.norm() / options_.step)));
    const Eigen::Vector3d step = way / steps;
    for (int k = 0; k < steps && go_on(); ++k) {
      hand_ += step;
      world_.pull_hand_to(hand_);
      world_.advance(step.norm() / options_.speed);
    }
  }

  void approach() {
    move(grasp_.translation(), [&] { return !note_contact(); });
    if (outcome_.contact == ApproachContact::none) note_contact();
    outcome_.short_by = (grasp_.translation() - hand_).norm();
  }

  void close() {
    world_.close_fingers(true);
    world_.advance(options_.closing_time);
    outcome_.closed_width = world_.opening();
    holds_ = !world_.hand_contacts().held.empty() && outcome_.closed_width > options_.min_width;
  }

  void retreat() {
    const bool is_steep = -direction().z() >= std::cos(options_.steep_angle);
    const Eigen::Vector3d way = is_steep ? Eigen::Vector3d(-direction()) : Eigen::Vector3d::UnitZ();
    move(hand_ + options_.retreat * way, [] { return true; });
    outcome_.width = world_.opening();
    const HandContacts contacts = world_.hand_contacts();
    if (!contacts.bodies.empty() && outcome_.width > options_.min_width) {
      outcome_.end = GraspEnd::success;
      outcome_.body = contacts.held.empty() ? contacts.bodies.front() : contacts.held.front();
    } else {
      outcome_.end = holds_ ? GraspEnd::slipped : GraspEnd::nothing_between_fingers;
    }
  }

  GraspWorld& world_;
  const Eigen::Isometry3d grasp_;
  const GraspExecutionOptions& options_;
  Eigen::Vector3d hand_ = Eigen::Vector3d::Zero();  ///< target of the hand's origin
  bool holds_ = false;                              ///< after closing
  GraspOutcome outcome_;
};

}  // namespace

const char* to_string(GraspEnd end) {
  switch (end) {
    case GraspEnd::success:
      return "success";
    case GraspEnd::contact_at_start:
      return "contact at the start";
    case GraspEnd::nothing_between_fingers:
      return "nothing between the fingers";
    case GraspEnd::slipped:
      return "slipped";
    case GraspEnd::diverged:
      break;
  }
  return "the physics diverged";
}

const char* to_string(ApproachContact contact) {
  switch (contact) {
    case ApproachContact::none:
      return "none";
    case ApproachContact::table:
      return "table";
    case ApproachContact::body:
      break;
  }
  return "body";
}

GraspOutcome execute_grasp(GraspWorld& world, const Eigen::Isometry3d& T_table_tool,
                           const GraspExecutionOptions& options) {
  options.validate();
  return Execution(world, T_table_tool, options).run();
}

}  // namespace symscene
