#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "symscene/core/point_cloud.hpp"
#include "symscene/symmetry/single_object.hpp"
#include "symscene/symmetry/symmetry_group.hpp"

namespace symscene::app {

/// The symmetries of a model, in the unit of its file.
struct ModelSymmetries {
  std::string name;
  double millimetres = 1000.0;  ///< in a unit of the file
  Box box;                      ///< of the vertices, or of the cloud's points
  double diameter = 0.0;        ///< of the same
  SymmetryGroup group;
};

nlohmann::ordered_json group_json(const ModelSymmetries& model);
/// What was found in a partial scan, with residuals of normals and images between 0 and 1.
nlohmann::ordered_json partial_json(const std::string& name, const ObjectSymmetries& found);

/// An entry of models_info.json as the BOP benchmark defines it (Hodan et al. 2018), in
/// millimetres. Of a sphere it has three continuous axes.
nlohmann::ordered_json bop_json(const ModelSymmetries& model);

/// Text of JSON with lists of numbers on one line.
std::string format_json(const nlohmann::ordered_json& json);
std::string format_yaml(const nlohmann::ordered_json& json);

}  // namespace symscene::app
