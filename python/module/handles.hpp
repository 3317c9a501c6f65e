#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "symscene/core/camera.hpp"
#include "symscene/core/depth_frame.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/core/triangle_mesh.hpp"

/// What objects of Python hold: shared, constant values of the library, whose memory arrays view.
namespace symscene::python {

struct CloudHandle {
  std::shared_ptr<const PointCloud> cloud;
  Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();  ///< of the sensor, where it is known [m]
};

struct MeshHandle {
  std::shared_ptr<const TriangleMesh> mesh;
};

struct OccupancyHandle {
  std::shared_ptr<const OccupancyMap> map;
};

/// A scene, and what its folder holds beside it.
struct SceneData {
  Scene scene;
  TriangleMesh surface = {};                    ///< may be empty
  Trajectory cameras = {};                      ///< may be empty
  std::optional<CameraIntrinsics> camera = {};  ///< of the frames at these poses
  LogOddsMap log_odds = {};                     ///< without leaves if it is not known
  std::vector<StageTime> timings = {};          ///< of making it
};
struct SceneHandle {
  std::shared_ptr<const SceneData> data;
};

/// A result, what it was made of, and the points of its objects.
struct ResultData {
  SegmentationResult result;
  std::shared_ptr<const SceneData> scene = {};  ///< null if it is not known
  std::vector<PointCloud> observed = {};        ///< per object
  std::vector<std::uint16_t> labels = {};       ///< of the pixels of a depth image
  Index width = 0;                              ///< of the depth image [px]
};
struct ResultHandle {
  std::shared_ptr<const ResultData> data;
};

/// An object of a result.
struct ObjectHandle {
  std::shared_ptr<const ResultData> data;
  std::size_t id = 0;

  const SceneObject& object() const { return data->result.objects[id]; }
};

/// A part of a shared value, which lives as long as the whole.
template <class Whole, class Part>
std::shared_ptr<const Part> part_of(const std::shared_ptr<const Whole>& whole, const Part& part) {
  return std::shared_ptr<const Part>(whole, &part);
}

template <class Value>
std::shared_ptr<const Value> shared(Value value) {
  return std::make_shared<const Value>(std::move(value));
}

/// A result with the points of its objects.
ResultHandle make_result(SegmentationResult result, std::shared_ptr<const SceneData> scene,
                         std::vector<std::uint16_t> labels = {}, Index width = 0);

}  // namespace symscene::python
