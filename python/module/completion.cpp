#include <numeric>

#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "handles.hpp"
#include "option_reading.hpp"
#include "pipeline/object_completion.hpp"
#include "pipeline/stage_options.hpp"
#include "running.hpp"
#include "scenes.hpp"
#include "segmentation/workspace.hpp"
#include "symscene/workflow/segment_options.hpp"

namespace symscene::python {
namespace {

/// Symmetries of an object from rows of a point and a direction, the best first.
template <class Symmetry, class Make>
std::vector<Symmetry> symmetries_from(const py::list& rows, const char* name, const Make& make) {
  std::vector<Symmetry> symmetries;
  for (const py::handle row : rows) {
    const std::vector<double> n = numbers_from(row, 6, name);
    const Eigen::Vector3d direction(n[3], n[4], n[5]);
    if (!(direction.norm() > 0.0)) throw InputError(name, "a direction that is not zero", "0 0 0");
    symmetries.push_back({make(Eigen::Vector3d(n[0], n[1], n[2]), direction.normalized()), 0.0});
  }
  return symmetries;
}

/// An object of all points of a sampled cloud, completed.
SegmentationResult completed(const Workspace& space, const Scene& scene, SceneObject object,
                             const PipelineOptions& options) {
  SegmentationResult result;
  result.cloud = space.cloud;
  result.table = scene.table;
  result.warnings = space.warnings;
  object.points.resize(space.cloud.size());
  std::iota(object.points.begin(), object.points.end(), Index{0});
  result.objects.push_back(std::move(object));
  complete_objects(space.field, options, result);
  return result;
}

ObjectHandle complete(const CloudHandle& cloud, const py::list& axes, const py::list& planes,
                      const OccupancyHandle* occupancy, py::handle table, const std::string& json,
                      int threads) {
  const auto options = options_from<SegmentOptions>(json).pipeline;
  SceneObject object;
  object.rotational =
      symmetries_from<ObjectAxis>(axes, "axes", [](const auto& point, const auto& d) {
        return RotationAxis{point, d};
      });
  object.reflectional =
      symmetries_from<ObjectPlane>(planes, "planes", [](const auto& point, const auto& n) {
        return ReflectionPlane{point, n};
      });
  Scene scene{*cloud.cloud, {}, {}};
  if (occupancy != nullptr) scene.occupancy = *occupancy->map;
  if (!table.is_none()) scene.table = plane_from(table, "table");
  return Running(py::none(), threads).without_gil([&] {
    StageTimer timer;
    const Workspace space = sampled_workspace(scene, workspace_options(options), timer);
    return ObjectHandle{make_result(completed(space, scene, object, options), nullptr).data, 0};
  });
}

}  // namespace

void bind_completion(py::module_& module) {
  module.def("complete", &complete, py::arg("cloud"), py::arg("axes"), py::arg("planes"),
             py::arg("occupancy"), py::arg("table"), py::arg("options"), py::arg("threads"));
}

}  // namespace symscene::python
