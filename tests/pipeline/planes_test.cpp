// What proposes reflection planes: smooth segments, edge curves, or both.
#include <gtest/gtest.h>

#include "proposals/object_proposals.hpp"
#include "symscene/io/result.hpp"
#include "symscene/pipeline/pipeline.hpp"
#include "symscene/simulation/simulation.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

const Scene& table_with_boxes() {
  static const SimulatedScene scene = [] {
    SimulationOptions options;
    options.tabletop.objects = 4;
    options.tabletop.seed = 44;
    return simulate_tabletop(options);
  }();
  return scene.scene;
}

PipelineOptions options_of(bool surfaces, bool curves) {
  PipelineOptions options;
  options.planes_of_surfaces = surfaces;
  options.planes_of_curves = curves;
  return options;
}

std::size_t planes_of(bool surfaces, bool curves) {
  return propose_objects(table_with_boxes(), options_of(surfaces, curves)).planes.size();
}

TEST(DetectPlanes, OfBothAreThoseOfSurfacesAndThoseOfCurvesThatRepeatNone) {
  const std::size_t surfaces = planes_of(true, false), curves = planes_of(false, true);
  const std::size_t both = planes_of(true, true);
  EXPECT_GT(surfaces, 0U);
  EXPECT_GT(curves, 0U);
  EXPECT_GE(both, std::max(surfaces, curves));
  EXPECT_LE(both, surfaces + curves);
  EXPECT_EQ(planes_of(false, false), 0U);
}

TEST(DetectPlanes, OfBothBeginWithThoseOfSurfaces) {
  const std::vector<ReflectionalCandidate> surfaces =
      propose_objects(table_with_boxes(), options_of(true, false)).planes;
  const std::vector<ReflectionalCandidate> both =
      propose_objects(table_with_boxes(), options_of(true, true)).planes;
  ASSERT_GE(both.size(), surfaces.size());
  for (std::size_t k = 0; k < surfaces.size(); ++k)
    EXPECT_EQ(both[k].plane.normal, surfaces[k].plane.normal);
}

TEST(SearchedObject, HasThePlanesWhoseSupportItHolds) {
  SceneProposals proposals;
  proposals.objects.resize(1);
  proposals.objects[0].merged.points = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  proposals.planes.push_back({{}, {}, {1, 2, 3, 4, 20}});   // four of five points
  proposals.planes.push_back({{}, {}, {1, 2, 3, 20, 21}});  // three of five
  const ObjectSymmetryOptions options;
  EXPECT_EQ(searched_object(proposals, 0, options).planes.size(), 1U);
}

TEST(DetectPlanes, OfCurvesMakeObjectsThatAreTheSameForAnyNumberOfThreads) {
  PipelineOptions options = options_of(false, true);
  options.rotational_stream = false;
  options.selection.by_score = false;
  std::vector<std::string> texts;
  for (const std::size_t threads : {1U, 8U}) {
    testing::with_threads(threads, [&] {
      const SegmentationResult result = segment_scene(table_with_boxes(), options);
      EXPECT_FALSE(result.objects.empty());
      texts.push_back(format_objects_json(result, false));
    });
  }
  EXPECT_EQ(texts[0], texts[1]);
}

}  // namespace
}  // namespace symscene
