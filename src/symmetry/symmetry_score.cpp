#include "symmetry/symmetry_score.hpp"

#include "core/model_features.hpp"

namespace symscene {

std::string_view axis_model_text();   // models/axis.txt
std::string_view plane_model_text();  // models/plane.txt

const TreeModel& axis_model() {
  static const TreeModel model = embedded_model<AxisFeatures>("axis", axis_model_text());
  return model;
}

const TreeModel& plane_model() {
  static const TreeModel model = embedded_model<PlaneFeatures>("plane", plane_model_text());
  return model;
}

double axis_probability(const AxisFeatures& features, const TreeModel& model) {
  return model.probability(values_of(features));
}

double plane_probability(const PlaneFeatures& features, const TreeModel& model) {
  return model.probability(values_of(features));
}

}  // namespace symscene
