#pragma once

#include "core/random.hpp"
#include "symscene/simulation/sensor_noise.hpp"

namespace symscene {

SensorFrame structured_light_frame(const SensorFrame& exact, const CameraIntrinsics& camera,
                                   const SensorNoiseOptions& options, Random random);
SensorFrame stereo_frame(const SensorFrame& exact, const CameraIntrinsics& camera,
                         const SensorNoiseOptions& options, Random random);
SensorFrame time_of_flight_frame(const SensorFrame& exact, const CameraIntrinsics& camera,
                                 const SensorNoiseOptions& options, Random random);

/// Copies what pixel `source` of `exact` shows to `pixel` of `noisy`, but with depth `z`.
void set_pixel(SensorFrame& noisy, std::size_t pixel, const SensorFrame& exact, std::size_t source,
               double z);

/// Marks a pixel as not measured.
void clear_pixel(SensorFrame& noisy, std::size_t pixel);

/// Share of the light that the surface reflects, from its colour. In [0, 1].
double reflectance(const SensorFrame& frame, std::size_t pixel);

/// Probability that a pixel is not measured for its angle of incidence.
double grazing_loss(const SensorFrame& frame, std::size_t pixel, const SensorNoiseOptions& options);

}  // namespace symscene
