#include "symscene/workflow/live_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "reconstruction/analytic_scenes.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

using namespace symscene::testing;

/// tabletop() is a table, three boxes and two balls.
constexpr std::size_t first_ball = 4;

/// Frames of a camera that goes on around the table, with their poses.
class Filmed {
 public:
  void film(const Bodies& bodies, int frames) {
    for (int k = 0; k < frames; ++k, ++taken_) {
      const Eigen::Isometry3d pose = around_table(0.03 * taken_);
      scene.add(render(bodies, half_vga(), pose), pose);
    }
  }

  LiveScene scene{half_vga()};

 private:
  int taken_ = 0;
};

/// The number of the object whose points are nearest to a place, within a few centimetres; 0 if
/// there is none.
ObjectNumber number_at(const LiveUpdate& update, const Eigen::Vector3d& place) {
  ObjectNumber number = 0;
  double nearest = 0.05;
  for (std::size_t i = 0; i < update.result.objects.size(); ++i) {
    const double distance =
        (centroid(update.result.cloud.positions, update.result.objects[i].points) - place).norm();
    if (distance < nearest) number = update.identified.numbers[i];
    nearest = std::min(nearest, distance);
  }
  return number;
}

bool tells(const LiveUpdate& update, ObjectNumber number, ObjectChangeKind kind) {
  return std::any_of(
      update.identified.changes.begin(), update.identified.changes.end(),
      [&](const ObjectChange& change) { return change.number == number && change.kind == kind; });
}

const Eigen::Vector3d ball{-0.1, -0.08, 0.05};
const Eigen::Vector3d other_ball{0.2, -0.08, 0.04};

TEST(LiveScene, WithinHalfASecondOfFramesABallIsGoneAndBackAndTheOthersKeepTheirNumbers) {
  Filmed filmed;
  const Bodies all = tabletop();
  Bodies without = all;
  without.erase(without.begin() + first_ball);
  filmed.film(all, 30);
  const LiveUpdate before = filmed.scene.objects();
  const ObjectNumber taken = number_at(before, ball), kept = number_at(before, other_ball);
  ASSERT_NE(taken, 0U);
  ASSERT_NE(kept, 0U);
  EXPECT_EQ(before.frames, 30U);

  filmed.film(without, 15);
  const LiveUpdate after = filmed.scene.objects();
  EXPECT_TRUE(tells(after, taken, ObjectChangeKind::gone));
  EXPECT_EQ(number_at(after, ball), 0U);
  EXPECT_EQ(number_at(after, other_ball), kept);

  filmed.film(all, 15);
  const LiveUpdate again = filmed.scene.objects();
  EXPECT_EQ(number_at(again, ball), taken);
  EXPECT_TRUE(tells(again, taken, ObjectChangeKind::returned));
  EXPECT_EQ(number_at(again, other_ball), kept);
}

TEST(LiveScene, AnUpdateOfASnapshotDoesNotSeeLaterFrames) {
  Filmed filmed;
  filmed.film(tabletop(), 6);
  const LiveSnapshot snapshot = filmed.scene.snapshot();
  filmed.film({plane(Eigen::Vector3d::UnitZ(), 0.0)}, 20);
  const LiveUpdate update = filmed.scene.update(snapshot);
  EXPECT_EQ(update.frames, 6U);
  EXPECT_NE(number_at(update, other_ball), 0U);
}

TEST(LiveScene, WithoutAFrameThereIsNoSnapshot) {
  EXPECT_THROW(LiveScene(half_vga()).snapshot(), InputError);
}

TEST(LiveScene, OptionsOutOfTheirRangeAreRefused) {
  LiveOptions options;
  options.tracked.reconstruction.tsdf.max_contradicted_looks = -1.0;
  EXPECT_THROW(LiveScene(half_vga(), options), InputError);
}

}  // namespace
}  // namespace symscene
