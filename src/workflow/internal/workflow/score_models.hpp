#pragma once

#include "symscene/pipeline/model_options.hpp"

namespace symscene {

/// Reads the models that the options name by a file. Throws InputError if one cannot be read.
void read_score_models(ModelOptions& options);

}  // namespace symscene
