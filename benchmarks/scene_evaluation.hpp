#pragma once

#include <map>
#include <string>
#include <vector>

#include "symscene/core/scene.hpp"
#include "symscene/evaluation/mask_measures.hpp"
#include "symscene/evaluation/symmetry_measures.hpp"

namespace symscene::bench {

/// What became of the objects of one kind.
struct KindScore {
  std::size_t objects = 0;
  std::size_t over_90 = 0;  ///< found with an overlap above 0.9
  std::size_t over_75 = 0;
  double overlap_sum = 0.0;        ///< of the best overlaps
  std::size_t symmetries = 0;      ///< strict ones
  std::size_t symmetries_met = 0;  ///< within 10° and 1 cm

  KindScore& operator+=(const KindScore& other);
};

/// How a result compares with the truth of its scene, or the sum over scenes.
struct SceneScore {
  Score over_90;  ///< masks at an overlap above 0.9
  Score over_75;
  Score axes;    ///< within 10° and 1 cm
  Score planes;  ///< within 10° and 1 cm
  double overlap_sum = 0.0;
  double seconds = 0.0;
  std::map<std::string, KindScore> kinds;

  double mean_overlap() const {
    return over_90.truth == 0 ? 1.0 : overlap_sum / static_cast<double>(over_90.truth);
  }
  SceneScore& operator+=(const SceneScore& other);
};

/// `seconds` of the score stays zero.
SceneScore evaluate(const Scene& scene, const SceneTruth& truth, const SegmentationResult& result);

}  // namespace symscene::bench
