#pragma once

#include <cstdint>

#include "symscene/core/options.hpp"

namespace symscene {

/// The errors of an active stereo camera (RealSense D400).
///
/// - The disparity d = f b / z has a constant error, so σ_z = disparity_noise · z² / (f b). The
///   default, with the baseline of a D435, gives 3.8e-3 z² at f = 425 px; Ahn, Chae, Shin, Kim and
///   Moon, "Analysis and noise modeling of the Intel RealSense D435 for mobile robots", Ubiquitous
///   Robots 2019, fit 3.9e-3 z² beside smaller terms. Grunnet-Jepsen, Sweetser and Woodfill,
///   "Best-known-methods for tuning Intel RealSense D400 depth cameras for best performance", Intel
///   2018, expect 0.05 to 0.1 px.
/// - Matching compares windows, so errors are correlated over a window, and the foreground is
///   fattened: pixels up to half a window beyond a depth edge take its depth.
/// - What only one camera sees has no depth: a shadow beside the foreground.
/// - There are holes where the pattern does not return: in patches, and mostly on dark surfaces and
///   in the highlights of shiny ones.
struct StereoNoiseOptions {
  double baseline = 0.05;
  double disparity_noise = 0.08;
  double disparity_step = 0.03125;
  int window = 5;
  double hole_size = 9.0;
  double holes = 0.005;
  double dark = 0.2;
  double dark_holes = 0.25;
  double shiny = 0.15;
  double shiny_holes = 0.2;
  std::uint64_t material_seed = 1;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("baseline", self.baseline, "m", above(0.0), "distance between the cameras (D435: 50 mm)");
    visit("disparity_noise", self.disparity_noise, "px", at_least(0.0),
          "standard deviation of the disparity (Ahn et al. 2019; Grunnet-Jepsen et al. 2018)");
    visit("disparity_step", self.disparity_step, "px", at_least(0.0),
          "step of the disparity, 0 for none");
    visit("window", self.window, "px", between(1, 31),
          "width of the matching window: of correlated errors and fattened edges");
    visit("hole_size", self.hole_size, "px", at_least(1.0), "typical width of a hole");
    visit("holes", self.holes, "", between(0.0, 0.5), "share of the surface that has no depth");
    visit("dark", self.dark, "", between(0.0, 1.0), "reflectance below which a surface is dark");
    visit("dark_holes", self.dark_holes, "", between(0.0, 0.5),
          "share of a dark surface that has no depth");
    visit("shiny", self.shiny, "", between(0.0, 1.0), "share of the objects that are shiny");
    visit("shiny_holes", self.shiny_holes, "", between(0.0, 0.5),
          "share of a shiny surface that has no depth, most of it where it faces the camera");
    visit("material_seed", self.material_seed, "", any_value(), "seed of which objects are shiny");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

}  // namespace symscene
