#include "symscene/labels/label_image.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "symscene/core/error.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

const CameraIntrinsics camera{120, 90, 150, 150, 59.5, 44.5};
constexpr double wall = 1.2;   // [m]
constexpr double front = 0.8;  // [m]

/// A wall, with two squares side by side and 2 cm apart in depth before its middle.
DepthFrame two_squares() {
  DepthFrame frame;
  frame.depth.assign(camera.pixels(), static_cast<float>(wall));
  for (Index v = 30; v < 60; ++v) {
    for (Index u = 30; u < 90; ++u)
      frame.depth[std::size_t{v} * camera.width + u] =
          static_cast<float>(u < 60 ? front : front + 0.02);
  }
  return frame;
}

struct Squares {
  PointCloud cloud;
  std::vector<PointIndices> masks{{}, {}};
};

/// Every second pixel of every second row of the squares.
Squares squares_of(const DepthFrame& frame, Index first_row = 30) {
  Squares squares;
  std::vector<Eigen::Vector3f> points;
  for (Index v = first_row; v < 60; v += 2) {
    for (Index u = 30; u < 90; u += 2) {
      squares.masks[u < 60 ? 0 : 1].push_back(static_cast<Index>(points.size()));
      const double z = frame.depth[std::size_t{v} * camera.width + u];
      points.push_back((z * camera.ray(u, v)).cast<float>());
    }
  }
  squares.cloud.positions.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    squares.cloud.positions.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  return squares;
}

std::vector<std::uint16_t> labels_of(
    const Squares& squares, const DepthFrame& frame,
    const std::optional<Plane>& table = std::nullopt,
    const Eigen::Isometry3d& T_cloud_camera = Eigen::Isometry3d::Identity()) {
  const PointsInView points(squares.cloud, table);
  return label_image(points.points_of(camera, frame.depth, T_cloud_camera), squares.masks,
                     squares.cloud.size());
}

std::uint16_t expected_label(std::size_t pixel) {
  const std::size_t u = pixel % camera.width, v = pixel / camera.width;
  if (u < 30 || u >= 90 || v < 30 || v >= 60) return 0;
  return u < 60 ? 1 : 2;
}

TEST(LabelImage, EveryPixelOfAnObjectHasItsLabelUpToTheDepthEdges) {
  const DepthFrame frame = two_squares();
  const auto labels = labels_of(squares_of(frame), frame);
  for (std::size_t i = 0; i < labels.size(); ++i) EXPECT_EQ(labels[i], expected_label(i)) << i;
}

TEST(LabelImage, PixelsWithoutDepthHaveNoLabel) {
  DepthFrame frame = two_squares();
  const Squares squares = squares_of(frame);
  for (std::size_t i = 0; i < frame.depth.size(); i += 3) frame.depth[i] = 0.0F;
  const auto labels = labels_of(squares, frame);
  for (std::size_t i = 0; i < labels.size(); ++i)
    EXPECT_EQ(labels[i], i % 3 == 0 ? 0 : expected_label(i));
}

TEST(LabelImage, LabelsGrowOverTheSurfaceButNotAcrossADepthEdge) {
  const DepthFrame frame = two_squares();
  // The first rows have no points: 4 rows of 5 mm.
  const auto labels = labels_of(squares_of(frame, 34), frame);
  for (std::size_t i = 0; i < labels.size(); ++i) EXPECT_EQ(labels[i], expected_label(i)) << i;
}

TEST(LabelImage, LabelsGrowNoFartherThanTheirBound) {
  const DepthFrame frame = two_squares();
  const auto labels = labels_of(squares_of(frame, 50), frame);
  EXPECT_EQ(labels[std::size_t{49} * camera.width + 40], 1);
  EXPECT_EQ(labels[std::size_t{32} * camera.width + 40], 0);
}

TEST(LabelImage, MovesWithTheCamera) {
  const DepthFrame frame = two_squares();
  Squares squares = squares_of(frame);
  Eigen::Isometry3d moved(Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()));
  moved.pretranslate(Eigen::Vector3d(0.3, -2.0, 1.0));
  for (Eigen::Index i = 0; i < squares.cloud.positions.rows(); ++i) {
    const Eigen::Vector3d p = squares.cloud.positions.row(i).transpose().cast<double>();
    squares.cloud.positions.row(i) = (moved * p).cast<float>().transpose();
  }
  const auto labels = labels_of(squares, frame, std::nullopt, moved);
  for (std::size_t i = 0; i < labels.size(); ++i) EXPECT_EQ(labels[i], expected_label(i)) << i;
}

TEST(LabelImage, PixelsOfTheTableHaveNoLabel) {
  // The right square is the table, though points of an object are 4 mm above it.
  const DepthFrame frame = two_squares();
  Squares squares = squares_of(frame);
  for (const Index i : squares.masks[1]) squares.cloud.positions(i, 2) -= 0.004F;
  const Plane table{-Eigen::Vector3d::UnitZ(), front + 0.02};
  const auto labels = labels_of(squares, frame, table);
  for (std::size_t i = 0; i < labels.size(); ++i)
    EXPECT_EQ(labels[i], expected_label(i) == 1 ? 1 : 0) << i;
}

TEST(LabelImage, IsTheSameForAnyNumberOfThreads) {
  const DepthFrame frame = two_squares();
  const auto run = [&] { return labels_of(squares_of(frame), frame); };
  EXPECT_EQ(testing::with_threads(1, run), testing::with_threads(2, run));
}

TEST(LabelImage, FirstMaskHasThePointThatTwoShare) {
  const std::vector<Index> shown{0, 1, PointsInView::none};
  const std::vector<PointIndices> masks{{0}, {0, 1}};
  EXPECT_EQ(label_image(shown, masks, 2), (std::vector<std::uint16_t>{1, 2, 0}));
  EXPECT_THROW(label_image(shown, masks, 1), InputError);
}

TEST(LabelImage, OverlayColoursObjectsOnly) {
  const DepthFrame frame = two_squares();
  std::vector<std::uint16_t> labels(camera.pixels(), 0);
  labels[500] = 3;
  const Colors shown = overlay(camera, frame, labels);
  EXPECT_EQ(shown(0, 0), shown(0, 1));
  EXPECT_NE(shown.row(500).minCoeff(), shown.row(500).maxCoeff());
  labels.pop_back();
  EXPECT_THROW(overlay(camera, frame, labels), InputError);
}

}  // namespace
}  // namespace symscene
