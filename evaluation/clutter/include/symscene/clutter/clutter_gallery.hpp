#pragma once

#include <span>
#include <string>

#include "symscene/clutter/clutter_rounds.hpp"
#include "symscene/io/image.hpp"

namespace symscene {

/// The world with the open gripper (orange) at a grasp, seen along the pads.
ColorImage grasp_image(const ClutterWorld& world, const Grasp& grasp);

/// An attempt on the page of failures.
struct GalleryEntry {
  std::string image;  ///< path of its image, relative to the page
  ClutterAttempt attempt;
};

/// A page in HTML that lists attempts with their images, how they ended and the features of their
/// grasps.
std::string format_gallery(const std::string& title, std::span<const GalleryEntry> entries);

}  // namespace symscene
