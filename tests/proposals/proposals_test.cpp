#include "symscene/pipeline/pipeline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/model_features.hpp"
#include "proposals/object_score.hpp"
#include "surfaces.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

const Plane table{Eigen::Vector3d::UnitZ(), 0.0};

/// The visible part of an object on the table: all but its bottom.
PointCloud standing(const PointCloud& cloud) {
  PointIndices seen;
  for (Index i = 0; i < cloud.size(); ++i) {
    if (cloud.position(i).z() > 0.004F) seen.push_back(i);
  }
  return select(cloud, seen);
}

/// A scene whose one proposal is all of it.
SceneProposals proposal_of(const PointCloud& cloud, double score) {
  SceneProposals proposals;
  proposals.cloud = cloud;
  proposals.table = table;
  proposals.field =
      unknown_distance_field(bounding_box(cloud.positions).padded(0.05F), 0.005F, table);
  ObjectProposal proposal;
  proposal.merged.points = testing::all_of(cloud);
  proposal.score = score;
  proposals.objects.push_back(proposal);
  return proposals;
}

/// The same of a box about the z axis, around which all space was seen and in which none was.
SceneProposals proposal_of_box(const Eigen::Vector3d& size, double score) {
  SceneProposals proposals = proposal_of(standing(testing::box(size)), score);
  OccupancyGrid grid =
      rasterize(OccupancyMap{}, bounding_box(proposals.cloud.positions).padded(0.1F));
  const Eigen::Vector3f center(0.0F, 0.0F, 0.5F * static_cast<float>(size.z()));
  const Eigen::Array3f half = 0.5F * size.cast<float>().array();
  std::size_t k = 0;
  for (int z = 0; z < grid.frame.size.z(); ++z) {
    for (int y = 0; y < grid.frame.size.y(); ++y) {
      for (int x = 0; x < grid.frame.size.x(); ++x, ++k) {
        const Eigen::Vector3f voxel =
            (Eigen::Vector3i(x, y, z).cast<float>().array() + 0.5F).matrix();
        const Eigen::Vector3f p = grid.frame.origin + grid.frame.resolution * voxel;
        grid.states[k] =
            ((p - center).array().abs() < half).all() ? VoxelState::never_seen : VoxelState::free;
      }
    }
  }
  proposals.field = distance_field(grid, table);
  return proposals;
}

/// A box of 10 cm and a vase of 12 cm beside it.
Scene box_and_vase() {
  PointCloud beside = testing::vase();
  beside.positions *= 0.6F;
  beside = standing(beside);
  beside.positions.col(0).array() += 0.18F;
  Scene scene;
  scene.cloud = testing::joined(standing(testing::box({0.06, 0.08, 0.1})), beside);
  scene.table = table;
  return scene;
}

TEST(Choice, FindsThePlanesOfABoxAtRightAngles) {
  const SceneProposals proposals = proposal_of_box({0.1, 0.16, 0.23}, 0.9);
  const SegmentationResult result = choose_objects(proposals);
  ASSERT_EQ(result.objects.size(), 1U);
  const SceneObject& box = result.objects[0];
  EXPECT_EQ(box.score, 0.9);
  EXPECT_EQ(box.points, proposals.objects[0].merged.points);
  EXPECT_TRUE(box.rotational.empty());
  EXPECT_GE(box.reflectional.size(), 2U);
  EXPECT_LE(box.reflectional.size(), 3U);
  double last = 0.0;
  for (std::size_t i = 0; i < box.reflectional.size(); ++i) {
    const Eigen::Vector3d& normal = box.reflectional[i].plane.normal;
    EXPECT_LT(std::min({line_angle(normal, Eigen::Vector3d::UnitX()),
                        line_angle(normal, Eigen::Vector3d::UnitY()),
                        line_angle(normal, Eigen::Vector3d::UnitZ())}),
              radians(2.0));
    EXPECT_GE(box.reflectional[i].residual, last);
    last = box.reflectional[i].residual;
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT(line_angle(normal, box.reflectional[j].plane.normal), radians(82.0));
  }
}

TEST(Choice, LeavesParallelPlanesAndThoseThatTheSurfaceContradictsOut) {
  SceneProposals proposals = proposal_of_box({0.1, 0.16, 0.23}, 0.9);
  const Eigen::Vector3d middle(0.0, 0.0, 0.1);
  const Eigen::Vector3d diagonal = Eigen::Vector3d(1.0, 1.0, 0.0).normalized();
  proposals.objects[0].merged.planes = {{{middle, Eigen::Vector3d::UnitX()}, 0.0},
                                        {{{0.002, 0.0, 0.1}, Eigen::Vector3d::UnitX()}, 0.0},
                                        {{{0.03, 0.0, 0.1}, Eigen::Vector3d::UnitX()}, 0.0},
                                        {{middle, diagonal}, 0.0}};
  const SegmentationResult result = choose_objects(proposals);
  ASSERT_EQ(result.objects.size(), 1U);
  int along_x = 0;
  for (const ObjectPlane& found : result.objects[0].reflectional) {
    EXPECT_GT(line_angle(found.plane.normal, diagonal), radians(30.0));
    if (line_angle(found.plane.normal, Eigen::Vector3d::UnitX()) > radians(10.0)) continue;
    ++along_x;
    EXPECT_LT(std::abs(found.plane.signed_distance(middle)), 0.003);
  }
  EXPECT_EQ(along_x, 1);
}

TEST(Choice, PlanesThatAClassAddsHaveTheResidualsOfDetectedOnes) {
  const SceneProposals proposals = proposal_of_box({0.1, 0.16, 0.23}, 0.9);
  PipelineOptions detect, add;
  detect.classes.complete_symmetries = false;
  add.object_symmetry.min_plane_probability = 1.0;  // lists none
  const SegmentationResult detected = choose_objects(proposals, detect);
  const SegmentationResult added = choose_objects(proposals, add);
  ASSERT_EQ(detected.objects.size(), 1U);
  ASSERT_EQ(added.objects.size(), 1U);
  ASSERT_GE(detected.objects[0].reflectional.size(), 2U);
  ASSERT_EQ(added.objects[0].reflectional.size(), 3U);
  double greatest = 0.0;
  for (const ObjectPlane& plane : detected.objects[0].reflectional) {
    for (const ObjectPlane& other : added.objects[0].reflectional) {
      if (line_angle(plane.plane.normal, other.plane.normal) > radians(3.0)) continue;
      EXPECT_NEAR(other.residual, plane.residual, 0.02);
      greatest = std::max(greatest, other.residual);
    }
  }
  EXPECT_GT(greatest, 0.03) << "the images of the top are not matched";
}

TEST(Choice, FindsTheAxisOfAVaseAndNoPlaneThroughIt) {
  const SegmentationResult result = choose_objects(proposal_of(standing(testing::vase()), 0.9));
  ASSERT_EQ(result.objects.size(), 1U);
  const SceneObject& vase = result.objects[0];
  ASSERT_EQ(vase.rotational.size(), 1U);
  const RotationAxis& axis = vase.rotational[0].axis;
  EXPECT_LT(line_angle(axis.direction, Eigen::Vector3d::UnitZ()), radians(2.0));
  EXPECT_LT(axis.distance(Eigen::Vector3d(0.0, 0.0, 0.1)), 0.004);
  EXPECT_TRUE(vase.reflectional.empty());
}

TEST(Choice, LeavesAnImprobableProposalOut) {
  const SegmentationResult result =
      choose_objects(proposal_of(testing::box({0.1, 0.1, 0.1}), 0.15));
  EXPECT_TRUE(result.objects.empty());
  ASSERT_EQ(result.rejected.size(), 1U);
  EXPECT_EQ(result.rejected[0].reason, "score");
}

TEST(Proposals, ContainBothObjectsOnATableByFallingScore) {
  const Scene scene = box_and_vase();
  const SceneProposals proposals = propose_objects(scene);
  double box = 0.0, vase = 0.0, last = 1.0;
  PointIndices of_box, of_vase;
  for (Index i = 0; i < proposals.cloud.size(); ++i)
    (proposals.cloud.position(i).x() < 0.09F ? of_box : of_vase).push_back(i);
  for (const ObjectProposal& proposal : proposals.objects) {
    EXPECT_TRUE(std::is_sorted(proposal.merged.points.begin(), proposal.merged.points.end()));
    EXPECT_LE(proposal.score, last);
    last = proposal.score;
    box = std::max(box, intersection_over_union(proposal.merged.points, of_box));
    vase = std::max(vase, intersection_over_union(proposal.merged.points, of_vase));
  }
  EXPECT_GT(box, 0.95);
  EXPECT_GT(vase, 0.95);
}

TEST(Proposals, ScoreObjectsHighAndFragmentsAndUnionsLow) {
  const SceneProposals proposals = propose_objects(box_and_vase());
  PointIndices of_box, of_vase;
  for (Index i = 0; i < proposals.cloud.size(); ++i)
    (proposals.cloud.position(i).x() < 0.09F ? of_box : of_vase).push_back(i);
  double box = 0.0, vase = 0.0;
  std::size_t others = 0;
  for (const ObjectProposal& proposal : proposals.objects) {
    const double of_whole_box = intersection_over_union(proposal.merged.points, of_box);
    const double of_whole_vase = intersection_over_union(proposal.merged.points, of_vase);
    if (of_whole_box > 0.95) box = std::max(box, proposal.score);
    if (of_whole_vase > 0.95) vase = std::max(vase, proposal.score);
    if (of_whole_box > 0.6 || of_whole_vase > 0.6) continue;
    ++others;
    EXPECT_LT(proposal.score, SelectionOptions{}.min_score)
        << proposal.merged.points.size() << " points";
  }
  EXPECT_GT(box, 0.7);
  EXPECT_GT(vase, 0.7);
  EXPECT_GT(others, 0U);
}

TEST(Proposals, UseTheModelsThatAreGiven) {
  PipelineOptions options;
  const auto constant = [](const TreeModel& model) {
    return std::make_shared<const TreeModel>(model.name(), model.features(), -3.0F,
                                             std::vector<Tree>{});
  };
  options.models.object_alone.model = constant(object_model());
  EXPECT_THROW(propose_objects(box_and_vase(), options), InputError);  // one of two
  options.models.object_among_others.model = constant(object_context_model());
  for (const ObjectProposal& proposal : propose_objects(box_and_vase(), options).objects)
    EXPECT_NEAR(proposal.score, 1.0 / (1.0 + std::exp(3.0)), 1e-12);
  options.models.axis.model = options.models.object_alone.model;
  EXPECT_THROW(propose_objects(box_and_vase(), options), InputError);  // not an axis model
}

TEST(Proposals, AreTheSameForAnyNumberOfThreads) {
  const Scene scene = box_and_vase();
  const auto run = [&] { return propose_objects(scene); };
  const SceneProposals one = testing::with_threads(1, run), two = testing::with_threads(2, run);
  ASSERT_EQ(one.objects.size(), two.objects.size());
  for (std::size_t k = 0; k < one.objects.size(); ++k) {
    EXPECT_EQ(one.objects[k].merged.points, two.objects[k].merged.points);
    EXPECT_EQ(one.objects[k].score, two.objects[k].score);
    EXPECT_EQ(values_of(one.objects[k].features), values_of(two.objects[k].features));
  }
}

TEST(Choice, IsTheSameForAnyNumberOfThreads) {
  const SceneProposals proposals = propose_objects(box_and_vase());
  const auto choose = [&] { return choose_objects(proposals); };
  const SegmentationResult a = testing::with_threads(1, choose);
  const SegmentationResult b = testing::with_threads(2, choose);
  ASSERT_EQ(a.objects.size(), b.objects.size());
  EXPECT_EQ(a.rejected.size(), b.rejected.size());
  for (std::size_t k = 0; k < a.objects.size(); ++k) {
    EXPECT_EQ(a.objects[k].points, b.objects[k].points);
    ASSERT_EQ(a.objects[k].rotational.size(), b.objects[k].rotational.size());
    ASSERT_EQ(a.objects[k].reflectional.size(), b.objects[k].reflectional.size());
    for (std::size_t s = 0; s < a.objects[k].rotational.size(); ++s)
      EXPECT_EQ(a.objects[k].rotational[s].residual, b.objects[k].rotational[s].residual);
    for (std::size_t s = 0; s < a.objects[k].reflectional.size(); ++s) {
      EXPECT_EQ(a.objects[k].reflectional[s].plane.normal,
                b.objects[k].reflectional[s].plane.normal);
      EXPECT_EQ(a.objects[k].reflectional[s].residual, b.objects[k].reflectional[s].residual);
    }
  }
}

}  // namespace
}  // namespace symscene
