#pragma once

#include <cmath>

#include "core/random.hpp"

namespace symscene::testing {

/// Features of any magnitude from 1e-3 to 10.
template <class Features>
Features random_features(Random& random) {
  Features features;
  Features::visit_fields(features, [&](const char*, double& value) {
    const double scale = std::pow(10.0, random.uniform(-3.0, 1.0));
    value = scale * random.uniform();
  });
  return features;
}

}  // namespace symscene::testing
