#include <filesystem>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "handles.hpp"
#include "io/atomic_file.hpp"
#include "option_reading.hpp"
#include "running.hpp"
#include "symscene/grasping/planner.hpp"
#include "symscene/io/grasps.hpp"
#include "workflow/gripper_choice.hpp"

namespace symscene::python {
namespace {

namespace fs = std::filesystem;

/// A plan, and the gripper for which it was made.
struct PlanHandle {
  std::shared_ptr<const GraspFile> file;
};

PlanHandle plan(const ResultHandle& result, const std::string& gripper, const SceneHandle* scene,
                const std::string& json, int threads) {
  const auto options = options_from<GraspOptions>(json);
  const Gripper hand = chosen_gripper(gripper, "gripper");
  const std::shared_ptr<const SceneData> around =
      scene != nullptr ? scene->data : result.data->scene;
  return Running(py::none(), threads).without_gil([&] {
    const GraspScene known =
        grasp_scene(result.data->result, around ? &around->scene : nullptr, options);
    return PlanHandle{shared(GraspFile{hand, plan_grasps(known, hand, options)})};
  });
}

py::dict features_of(const Grasp& grasp) {
  py::dict features;
  GraspFeatures::visit_fields(grasp.features,
                              [&](const char* name, double value) { features[name] = value; });
  return features;
}

py::list reasons_of(const PlanHandle& handle) {
  py::list reasons;
  for (const ObjectGraspSummary& object : handle.file->plan.objects) {
    if (object.reason)
      reasons.append(description(*object.reason));
    else
      reasons.append(py::none());
  }
  return reasons;
}

void bind_grasp(py::module_& module) {
  py::class_<Grasp>(module, "Grasp", "A pose of the gripper at which it closes on an object.")
      .def_readonly("object", &Grasp::object, "id of the object in the result")
      .def_property_readonly(
          "T_world_tool", [](const Grasp& g) { return array_of(g.T_world_tool); },
          "(4, 4) of the tool frame: z is the direction of approach, fingers close along y [m]")
      .def_readonly("opening", &Grasp::opening, "width of the object between the pads [m]")
      .def_readonly("quality", &Grasp::quality, "estimated probability of success, in [0, 1]")
      .def_property_readonly(
          "source", [](const Grasp& g) { return to_string(g.source); },
          "what it was derived from: axis_side, axis_top, rim, mirror_plane, box_face or antipodal")
      .def_property_readonly("features", &features_of, "dict of what the quality is computed from")
      .def("__repr__", [](const Grasp& g) {
        return fmt::format("<Grasp of object {}: quality {:.2f}, {}>", g.object, g.quality,
                           to_string(g.source));
      });
}

}  // namespace

void bind_grasps(py::module_& module) {
  bind_grasp(module);
  py::class_<PlanHandle>(module, "GraspPlan", "The grasps of a result, best first.")
      .def_property_readonly(
          "grasps", [](const PlanHandle& p) { return p.file->plan.grasps; },
          "list of Grasp, by descending quality")
      .def_property_readonly(
          "gripper", [](const PlanHandle& p) { return p.file->gripper.name; },
          "name of the gripper for which they were made")
      .def_property_readonly("reasons", &reasons_of, "per object: None, or why it has no grasp")
      .def("__repr__", [](const PlanHandle& p) {
        return fmt::format("<GraspPlan of {} grasps>", p.file->plan.grasps.size());
      });
  module.def("plan_grasps", &plan, py::arg("result"), py::arg("gripper"), py::arg("scene"),
             py::arg("options"), py::arg("threads"));
  module.def(
      "read_grasps", [](const fs::path& path) { return PlanHandle{shared(read_grasps(path))}; },
      py::arg("path"), py::call_guard<py::gil_scoped_release>(), "Read grasps.json.");
  module.def(
      "write_grasps",
      [](const fs::path& path, const PlanHandle& plan) {
        write_file_atomically(path, format_grasps_json(plan.file->plan, plan.file->gripper));
      },
      py::arg("path"), py::arg("plan"), py::call_guard<py::gil_scoped_release>(),
      "Write grasps.json.");
}

}  // namespace symscene::python
