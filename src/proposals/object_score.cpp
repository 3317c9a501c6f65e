#include "object_score.hpp"

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

}  // namespace symscene
