#pragma once

#include "symscene/core/options.hpp"

namespace symscene {

/// The errors of a time-of-flight camera (Kinect v2).
///
/// - The deviation hardly depends on the depth as long as enough light returns: 1 to 2 mm below 2 m
///   (Fankhauser et al., "Kinect v2 for mobile robot navigation", ICAR 2015). It grows where little
///   does: the amplitude is reflectance · cos(incidence) / z², in 1/m² (Sarbolandi, Lefloch and
///   Kolb, "Kinect range sensing: structured-light versus time-of-flight Kinect", CVIU 139, 2015,
///   section 5: dark and slanted surfaces).
/// - A pixel at a depth edge receives light from both sides: flying pixels between them (Sarbolandi
///   et al. 2015, section 5.8).
/// - Light that comes by another surface has a longer way: near concave corners depths are too
///   large, and the corner is rounded. One diffuse reflection is simulated (Fuchs, "Multipath
///   interference compensation in time-of-flight camera images", ICPR 2010).
struct TimeOfFlightNoiseOptions {
  double deviation = 0.0013;
  double full_amplitude = 0.05;
  double min_amplitude = 0.006;
  double flying = 0.6;
  double multipath = 0.5;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("deviation", self.deviation, "m", at_least(0.0),
          "standard deviation of a depth (Fankhauser et al. 2015)");
    visit("full_amplitude", self.full_amplitude, "1/m²", above(0.0),
          "amplitude below which the variance grows in inverse proportion to it");
    visit("min_amplitude", self.min_amplitude, "1/m²", at_least(0.0),
          "amplitude below which nothing is measured");
    visit("flying", self.flying, "", between(0.0, 1.0),
          "share of the pixels at depth edges that measure a depth between the two sides "
          "(Sarbolandi et al. 2015)");
    visit("multipath", self.multipath, "", between(0.0, 1.0),
          "reflectance of the surfaces by which light takes a longer way (Fuchs 2010)");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

}  // namespace symscene
