#pragma once

namespace symscene {

/// The standard deviation of a depth of a structured-light camera over its square (Khoshelham and
/// Elberink 2012, Eq. 10), which is that of an inverse depth: the default of all stages. [1/m]
constexpr double structured_light_noise = 1.425e-3;

}  // namespace symscene
