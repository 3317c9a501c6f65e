#include "workflow/score_models.hpp"

#include <memory>

#include "symscene/io/tree_model.hpp"

namespace symscene {

void read_score_models(ModelOptions& options) {
  options.for_each([](ModelChoice& choice) {
    if (!choice.file.empty())
      choice.model = std::make_shared<const TreeModel>(read_tree_model(choice.file));
  });
}

}  // namespace symscene
