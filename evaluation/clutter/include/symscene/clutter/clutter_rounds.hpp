#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "symscene/clutter/clutter_methods.hpp"

namespace symscene {

struct ClutterRoundOptions {
  ClutterKind kind = ClutterKind::packed;
  int objects = 5;
  int views = 1;
  int max_failures = 2;  ///< in a row, which end a round
  /// Proposals drawn at random that are tried and undone before each attempt: outcomes of grasps of
  /// any quality.
  int rehearsals = 0;
  /// The best grasp of each object is tried and undone before each attempt: outcomes also of
  /// objects that others hide, which an attempt with the best grasp of all seldom aims at.
  bool rehearse_best = false;
  std::uint64_t seed = 0;
  GraspMethod method = GraspMethod::symscene;
  ClutterMethodOptions planning;
  ClutterNoiseOptions noise;
  GraspExecutionOptions execution;
  GraspWorldOptions physics;

  /// Throws InputError if a value is out of its range.
  void validate() const;
};

/// A grasp that was tried.
struct ClutterAttempt {
  int round = 0;
  int number = 1;  ///< in its round
  Grasp grasp;
  GraspOutcome outcome;
  std::string aimed;            ///< name of the object nearest to the point between the fingertips
  double aimed_distance = 0.0;  ///< of that point from its surface [m]
  double occlusion = 0.0;       ///< of that object, before the grasp
  double penetration = 0.0;     ///< of the open hand at the grasp, into table or other objects [m]
  bool touched_other = false;   ///< the approach was stopped by another object
  bool removed_other = false;   ///< another object was removed
  std::size_t seen = 0;         ///< objects that the method sees
  std::size_t present = 0;      ///< objects that there are
  double seconds = 0.0;         ///< from depth images to grasps
  double grasping_seconds = 0.0;
};

/// An object at the start of a round.
struct PlacedItem {
  std::size_t item = 0;
  double occlusion = 0.0;
  bool removed = false;
};

/// The best grasp of an object before an attempt, tried and undone.
struct ObjectTrial {
  double occlusion = 0.0;
  std::optional<bool> succeeded = {};  ///< none without a grasp
};

/// Why a round ended.
enum class RoundEnd { cleared, no_grasp, failures, diverged };

const char* to_string(RoundEnd end);

struct ClutterRound {
  int placed = 0;
  int removed = 0;
  int left = 0;  ///< objects at the end; others fell off the table
  RoundEnd end = RoundEnd::cleared;
  std::vector<PlacedItem> placed_objects;
  std::vector<ObjectTrial> trials;        ///< with rehearse_best, of each object at each attempt
  std::vector<std::string> left_objects;  ///< their names
  std::vector<std::string> reasons;  ///< why objects have no grasp, where no grasp ended the round
  std::size_t outside = 0;  ///< grasps outside the grasp volume, where no grasp ended the round
  std::vector<ClutterAttempt> attempts;
  std::vector<ClutterAttempt> rehearsals;  ///< numbered as the attempt that follows
};

/// Called before an attempt with the world, its views and the proposals, and after it with the
/// outcome.
struct ClutterObserver {
  std::function<void(const ClutterWorld&, std::span<const ClutterView>, const GraspProposals&)>
      before;
  std::function<void(const ClutterAttempt&)> after;
};

/// One round: a new world, and grasps until no object is left, no grasp is proposed or grasps fail
/// twice in a row. The same options give the same round, whichever rounds were run before.
ClutterRound run_clutter_round(std::span<const ClutterObject> objects,
                               const ClutterRoundOptions& options, int round,
                               const ClutterObserver& observer = {});

}  // namespace symscene
