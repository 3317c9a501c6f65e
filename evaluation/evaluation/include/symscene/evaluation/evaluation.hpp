#pragma once

#include <map>

#include "symscene/evaluation/scene_evaluation.hpp"

namespace symscene {

/// The fates of some objects: all of them, or those of a kind.
struct OutcomeCounts {
  std::size_t objects = 0;
  std::array<std::size_t, all_fates.size()> fates{};  ///< in the order of all_fates
  std::array<std::map<std::string, std::size_t>, all_fates.size()> reasons;  ///< of each fate
  std::size_t over_75 = 0;  ///< objects that a returned mask overlaps by more than 0.75
  double overlap_sum = 0.0;
  std::size_t symmetries = 0;      ///< that have to be found
  std::size_t symmetries_met = 0;  ///< within 10° and 1 cm

  std::size_t count(Fate fate) const { return fates[static_cast<std::size_t>(fate)]; }
  /// The mean best overlap; one where there is no object. [IoU]
  double mean_overlap() const {
    return objects == 0 ? 1.0 : overlap_sum / static_cast<double>(objects);
  }
  void add(const ObjectOutcome& outcome);
  OutcomeCounts& operator+=(const OutcomeCounts& other);
};

/// Scenes with as many objects as one another, roughly: a column of table 4.3.
struct RuntimeClass {
  std::string name;
  std::size_t scenes = 0;
  double rotational = 0.0;    ///< mean seconds of detection, segmentation and removal
  double reflectional = 0.0;  ///< mean seconds of detection and segmentation
  double other = 0.0;         ///< mean seconds of what is before, between and after
  double total() const { return rotational + reflectional + other; }
};

/// A dataset's scenes and their sums.
struct Evaluation {
  std::vector<SceneEvaluation> scenes;  ///< with their sweeps of segmentation
  std::vector<Sweep> segmentation;
  std::vector<Sweep> detection;
  std::map<std::string, std::vector<Sweep>> subsets;  ///< segmentation by subset, if any is named
  OutcomeCounts outcomes;
  std::map<std::string, OutcomeCounts> kinds;

  /// Adds a scene. Throws InputError if it was swept over other settings than those before.
  void add(SceneEvaluation scene);
};

/// Scenes with up to 4, with 5 to 10 and with more objects.
std::vector<RuntimeClass> runtimes(const Evaluation& evaluation);

}  // namespace symscene
