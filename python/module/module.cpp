#include "bindings.hpp"
#include "errors.hpp"

PYBIND11_MODULE(_symscene, module) {
  using namespace symscene::python;
  module.doc() =
      "Functions and types of the SymScene library; use them through the package symscene.";
  module.attr("__version__") = SYMSCENE_VERSION;
  bind_errors(module);
  bind_geometry(module);
  bind_clouds(module);
  bind_scenes(module);
  bind_results(module);
  bind_options(module);
  bind_segmentation(module);
  bind_symmetries(module);
  bind_sequences(module);
  bind_reconstruction(module);
  bind_grasps(module);
  bind_completion(module);
  bind_evaluation(module);
}
