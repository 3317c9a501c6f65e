#pragma once

#include <map>

#include "symscene/evaluation/scene_evaluation.hpp"

namespace symscene {

/// Outcomes of a group of objects: of all, or of those of one kind.
struct OutcomeCounts {
  std::size_t objects = 0;
  std::array<std::size_t, all_outcomes.size()>
      counts{};  ///< number of objects, in the order of all_outcomes
  std::array<std::map<std::string, std::size_t>, all_outcomes.size()>
      reasons;                     ///< objects by reason, per outcome
  std::size_t over_75 = 0;         ///< objects that a returned mask overlaps with IoU > 0.75
  double overlap_sum = 0.0;        ///< of the best overlap of each object [IoU]
  std::size_t symmetries = 0;      ///< strict symmetries of the ground truth
  std::size_t symmetries_met = 0;  ///< of these, found within 10° and 1 cm

  std::size_t count(Outcome outcome) const { return counts[static_cast<std::size_t>(outcome)]; }
  /// Mean best overlap; 1 without objects. [IoU]
  double mean_overlap() const {
    return objects == 0 ? 1.0 : overlap_sum / static_cast<double>(objects);
  }
  void add(const ObjectOutcome& outcome);
  OutcomeCounts& operator+=(const OutcomeCounts& other);
};

/// Run time of scenes with similar numbers of objects: a column of table 4.3.
struct RuntimeClass {
  std::string name;
  std::size_t scenes = 0;
  double rotational = 0.0;    ///< mean of detection, segmentation and removal [s]
  double reflectional = 0.0;  ///< mean of detection and segmentation [s]
  double other = 0.0;         ///< mean of all other stages [s]
  double total() const { return rotational + reflectional + other; }
};

/// The evaluation of a dataset: its scenes and their sums.
struct Evaluation {
  std::vector<SceneEvaluation> scenes;                ///< in the order of add()
  std::vector<Sweep> segmentation;                    ///< summed over scenes
  std::vector<Sweep> detection;                       ///< summed over scenes
  std::map<std::string, std::vector<Sweep>> subsets;  ///< segmentation by subset
  OutcomeCounts outcomes;
  OutcomeCounts small_objects;  ///< those with fewer points at 5 mm than small_object_points
  std::map<std::string, OutcomeCounts> kinds;

  /// Adds a scene. Throws InputError if its methods or settings differ from those of the scenes
  /// before.
  void add(SceneEvaluation scene);
};

/// Scenes with up to 4, with 5 to 10 and with more objects.
std::vector<RuntimeClass> runtimes(const Evaluation& evaluation);

}  // namespace symscene
