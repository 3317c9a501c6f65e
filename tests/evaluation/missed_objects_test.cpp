#include "symscene/evaluation/missed_objects.hpp"
#include "symscene/io/image.hpp"
#include "symscene/pipeline/pipeline.hpp"

#include <gtest/gtest.h>
#include "index_range.hpp"

namespace symscene {
namespace {

const ReflectionPlane mirror{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()};
const ReflectionPlane elsewhere{Eigen::Vector3d(0.3, 0, 0), Eigen::Vector3d::UnitX()};

/// An object of the points 0 to 99 of 300, with one plane of symmetry.
class MissedObjects : public ::testing::Test {
 protected:
  MissedObjects() {
    truth_.objects.emplace_back();
    truth_.objects.front().name = "box";
    truth_.objects.front().reflectional.push_back({mirror, true});
    proposals_.cloud.positions = Points::Zero(300, 3);
    for (Eigen::Index i = 0; i < 300; ++i)
      proposals_.cloud.positions(i, 0) = 0.001F * static_cast<float>(i);
    options_.reflectional_segmentation.bounds.min_size = 20;
    options_.selection.by_score = false;
  }

  void propose(const ReflectionPlane& plane, PointIndices support) {
    proposals_.planes.push_back({plane, {}, std::move(support)});
  }
  void add_hypothesis(PointIndices points, HypothesisResiduals residuals = {0.1, 0.001, 0.1}) {
    proposals_.reflectional.push_back({std::move(points), residuals, {}, mirror});
  }
  /// The outcome of the object with the pipeline's own selection.
  ObjectOutcome outcome() const { return outcome(choose_objects(proposals_, options_)); }
  ObjectOutcome outcome(const SegmentationResult& result) const {
    return object_outcomes(truth_, {testing::index_range(0, 100)}, proposals_, result).at(0);
  }
  void expect(Outcome expected, const std::string& reason) const {
    const ObjectOutcome seen = outcome();
    EXPECT_EQ(outcome_name(seen.outcome), outcome_name(expected));
    EXPECT_EQ(seen.reason, reason);
  }

  SceneTruth truth_;
  SceneProposals proposals_;
  PipelineOptions options_;
};

TEST_F(MissedObjects, AGoodMaskIsFound) {
  propose(mirror, testing::index_range(10, 60));
  add_hypothesis(testing::index_range(0, 95));
  expect(Outcome::found, "");
  EXPECT_DOUBLE_EQ(outcome().best_overlap, 0.95);
  EXPECT_EQ(outcome().kind, "box");
  EXPECT_EQ(outcome().points, 100U);
  EXPECT_EQ(outcome().symmetries, 1U);
  EXPECT_EQ(outcome().symmetries_met, 1U);
}

TEST_F(MissedObjects, TellAndShowWhatWasChosenInTheirPlace) {
  propose(mirror, testing::index_range(10, 60));
  add_hypothesis(testing::index_range(60, 160));
  const ObjectOutcome missed = outcome();
  EXPECT_EQ(missed.instead, "object 0 with 100 points, 40 of its 100");
  const ColorImage picture = parse_color_image(missed.picture, "picture");
  const auto is_red = [&](Eigen::Index i) {
    return picture.pixels(i, 0) > 150 && picture.pixels(i, 1) < 60;
  };
  bool any_red = false;
  for (Eigen::Index i = 0; i < picture.pixels.rows(); ++i) any_red = any_red || is_red(i);
  EXPECT_TRUE(any_red) << "60 of its points are in no object";
}

TEST_F(MissedObjects, ThatAreFoundHaveNoPicture) {
  propose(mirror, testing::index_range(10, 60));
  add_hypothesis(testing::index_range(0, 95));
  EXPECT_EQ(outcome().picture, "");
}

TEST_F(MissedObjects, WithoutACandidateInItAnObjectIsNotProposed) {
  propose(mirror, testing::index_range(80, 160));
  expect(Outcome::not_proposed, "no segment");
}

TEST_F(MissedObjects, ACandidateThatIsNoSymmetryOfTheObjectDoesNotProposeIt) {
  propose(elsewhere, testing::index_range(0, 50));
  expect(Outcome::not_proposed, "no symmetry");
}

TEST_F(MissedObjects, AProposalOfOverHalfTheObjectProposesItWithoutASymmetry) {
  add_hypothesis(testing::index_range(0, 60));
  expect(Outcome::wrongly_segmented, "too little");
  proposals_.reflectional.clear();
  add_hypothesis(testing::index_range(0, 50));
  expect(Outcome::not_proposed, "no segment");  // half of it is not enough
}

TEST_F(MissedObjects, AnObjectWithoutKnownSymmetriesIsProposedByAnyCandidateInIt) {
  truth_.objects.front().reflectional.clear();
  propose(elsewhere, testing::index_range(0, 50));
  add_hypothesis(testing::index_range(0, 50));
  expect(Outcome::wrongly_segmented, "too little");
}

TEST_F(MissedObjects, AProposalOfHalfTheObjectIsTooLittleAndOneOfTwiceItTooMuch) {
  propose(mirror, testing::index_range(0, 50));
  add_hypothesis(testing::index_range(0, 50));
  expect(Outcome::wrongly_segmented, "too little");
  proposals_.reflectional.clear();
  add_hypothesis(testing::index_range(0, 180));
  expect(Outcome::wrongly_segmented, "too much");
  proposals_.reflectional.clear();
  expect(Outcome::wrongly_segmented, "too little");
}

TEST_F(MissedObjects, TheBoundThatRejectsAGoodHypothesisIsNamed) {
  propose(mirror, testing::index_range(0, 50));
  add_hypothesis(testing::index_range(0, 100), {0.1, 0.9, 0.1});
  expect(Outcome::rejected, "occlusion");
  add_hypothesis(testing::index_range(0, 99), {0.9, 0.001, 0.1});
  expect(Outcome::rejected, "occlusion");  // which comes after symmetry
  EXPECT_DOUBLE_EQ(outcome().best_proposal_overlap, 1.0);
  EXPECT_DOUBLE_EQ(outcome().best_overlap, 0.0);
  options_.reflectional_segmentation.bounds.min_size = 200;
  expect(Outcome::rejected, "size");
}

TEST_F(MissedObjects, AHypothesisRejectedForItsSupportIsNamed) {
  propose(mirror, testing::index_range(0, 50));
  proposals_.rejected.push_back(
      {"reflectional", "support", 0.3, 0.5, 100, testing::index_range(0, 100)});
  expect(Outcome::rejected, "support");
}

TEST_F(MissedObjects, AGoodHypothesisMayBeRejectedForItsOverlapWithABetterOne) {
  propose(mirror, testing::index_range(0, 50));
  add_hypothesis(testing::index_range(0, 100), {0.2, 0.003, 0.1});
  add_hypothesis(testing::index_range(0, 190), {0.01, 0.0001, 0.01});
  expect(Outcome::rejected, "overlap");
}

TEST_F(MissedObjects, AGoodHypothesisMayBeRejectedAsAComposite) {
  propose(mirror, testing::index_range(0, 50));
  add_hypothesis(testing::index_range(0, 100));
  add_hypothesis(testing::index_range(0, 50), {0.05, 0.001, 0.1});
  add_hypothesis(testing::index_range(50, 100), {0.05, 0.001, 0.1});
  expect(Outcome::rejected, "composite");
}

TEST_F(MissedObjects, AGoodProposalMayBeRejectedForItsScore) {
  propose(mirror, testing::index_range(0, 50));
  options_.selection.by_score = true;
  ObjectProposal proposal;
  proposal.merged.points = testing::index_range(0, 100);
  proposal.score = 0.5 * options_.selection.min_score;
  proposals_.objects.push_back(proposal);
  expect(Outcome::rejected, "score");
}

TEST_F(MissedObjects, AGoodHypothesisMayBeMergedIntoAnObjectWithAWorseMask) {
  propose(mirror, testing::index_range(0, 50));
  add_hypothesis(testing::index_range(0, 109), {0.2, 0.003, 0.1});
  add_hypothesis(testing::index_range(0, 113), {0.01, 0.0001, 0.01});
  expect(Outcome::rejected, "merge");
}

TEST_F(MissedObjects, AnObjectWithoutAPointIsLost) {
  propose(mirror, testing::index_range(0, 50));
  add_hypothesis(testing::index_range(0, 100));
  const ObjectOutcome lost =
      object_outcomes(truth_, {{}}, proposals_, choose_objects(proposals_, options_)).at(0);
  EXPECT_EQ(outcome_name(lost.outcome), "lost before segmentation");
  EXPECT_EQ(lost.reason, "no point");
  EXPECT_EQ(lost.best_overlap, 0.0);
  EXPECT_TRUE(lost.is_small);
}

TEST_F(MissedObjects, AnObjectIsSmallByItsPointsAtFiveMillimetres) {
  EXPECT_TRUE(outcome().is_small);  // 100 points, but a row of 10 cm
  for (Eigen::Index i = 0; i < 300; ++i)
    proposals_.cloud.positions(i, 0) = 0.006F * static_cast<float>(i);
  EXPECT_FALSE(outcome().is_small);
}

}  // namespace
}  // namespace symscene
