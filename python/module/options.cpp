#include <array>
#include <functional>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "bindings.hpp"
#include "option_reading.hpp"
#include "symscene/core/error.hpp"
#include "symscene/grasping/grasp_options.hpp"
#include "symscene/symmetry/single_object.hpp"
#include "symscene/symmetry/symmetry_group.hpp"
#include "symscene/workflow/segment_options.hpp"
#include "symscene/workflow/tracked_scene_options.hpp"

namespace symscene::python {
namespace {

namespace py = pybind11;

using Visit = std::function<py::object(const OptionFields&)>;

template <class Options>
py::object visit_defaults(const Visit& visit) {
  Options options;
  return visit(option_fields(options));
}

struct NamedOptions {
  const char* name;
  py::object (*visit)(const Visit&);
};

constexpr std::array named_options = {
    NamedOptions{"segment", visit_defaults<SegmentOptions>},
    NamedOptions{"symmetries", visit_defaults<SymmetryGroupOptions>},
    NamedOptions{"partial_symmetries", visit_defaults<SingleObjectOptions>},
    NamedOptions{"reconstruct", visit_defaults<TrackedSceneOptions>},
    NamedOptions{"grasps", visit_defaults<GraspOptions>},
};

/// Calls `visit` with the options of that name.
py::object with_options(const std::string& name, const Visit& visit) {
  std::string known;
  for (const NamedOptions& options : named_options) {
    if (name == options.name) return options.visit(visit);
    known += (known.empty() ? "" : ", ") + std::string(options.name);
  }
  throw InputError("function", "one of " + known, "\"" + name + "\"");
}

py::object described_fields(const OptionFields& fields) {
  py::list list;
  for (const OptionField& field : fields) {
    const py::object value =
        std::visit([](const auto* v) { return py::object(py::cast(*v)); }, field.value);
    list.append(py::make_tuple(field.name, value, field.unit, to_string(field.range), field.help));
  }
  return list;
}

}  // namespace

void bind_options(py::module_& module) {
  module.def(
      "option_values",
      [](const std::string& function) {
        return with_options(function, [](const OptionFields& fields) {
          return py::object(py::str(option_values(fields)));
        });
      },
      py::arg("function"));
  module.def(
      "option_descriptions",
      [](const std::string& function) { return with_options(function, described_fields); },
      py::arg("function"));
}

}  // namespace symscene::python
