#include "proposals/object_score.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/model_features.hpp"

namespace symscene {

std::string_view object_alone_model_text();         // models/object_alone.txt
std::string_view object_among_others_model_text();  // models/object_among_others.txt

const TreeModel& object_model() {
  static const TreeModel model =
      embedded_model<ObjectFeatures>("object_alone", object_alone_model_text());
  return model;
}

const TreeModel& object_context_model() {
  static const TreeModel model = embedded_model<ObjectFeatures, ProposalContext>(
      "object_among_others", object_among_others_model_text());
  return model;
}

double estimated_probability(const ObjectFeatures& features, const TreeModel& model) {
  return model.probability(values_of(features));
}

double estimated_probability(const ObjectFeatures& features, const ProposalContext& context,
                             const TreeModel& model) {
  return model.probability(values_of(features, context));
}

double log_odds(double probability) {
  constexpr double least = std::numeric_limits<double>::epsilon();
  const double bounded = std::clamp(probability, least, 1.0 - least);
  return std::log(bounded / (1.0 - bounded));
}

double pooled_probability(double a, double b, double weight_a) {
  const double pooled = (weight_a * log_odds(a)) + ((1.0 - weight_a) * log_odds(b));
  return 1.0 / (1.0 + std::exp(-pooled));
}

}  // namespace symscene
