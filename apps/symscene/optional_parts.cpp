#include "optional_parts.hpp"

#include <fmt/format.h>

namespace symscene::app {
namespace {

// CMake defines a name for each part that is built.
#ifdef SYMSCENE_HAS_EVALUATION
constexpr bool has_evaluation = true;
#else
constexpr bool has_evaluation = false;
#endif
#ifdef SYMSCENE_HAS_SIMULATION
constexpr bool has_simulation = true;
#else
constexpr bool has_simulation = false;
#endif
#ifdef SYMSCENE_HAS_MUJOCO
constexpr bool has_mujoco = true;
#else
constexpr bool has_mujoco = false;
#endif
#ifdef SYMSCENE_HAS_OPENCV
constexpr bool has_opencv = true;
#else
constexpr bool has_opencv = false;
#endif
#ifdef SYMSCENE_HAS_ROSBAG
constexpr bool has_rosbag = true;
#else
constexpr bool has_rosbag = false;
#endif
#ifdef SYMSCENE_HAS_URDF
constexpr bool has_urdf = true;
#else
constexpr bool has_urdf = false;
#endif
#ifdef SYMSCENE_HAS_YAML
constexpr bool has_yaml = true;
#else
constexpr bool has_yaml = false;
#endif
#ifdef SYMSCENE_HAS_GIF
constexpr bool has_gif_writer = true;
#else
constexpr bool has_gif_writer = false;
#endif
#ifdef SYMSCENE_HAS_PCL
constexpr bool has_pcl = true;
#else
constexpr bool has_pcl = false;
#endif

}  // namespace

std::vector<OptionalPart> optional_parts() {
  return {{"evaluation", "SYMSCENE_BUILD_EVALUATION", has_evaluation},
          {"simulation", "SYMSCENE_BUILD_SIMULATION", has_simulation},
          {"physics", "libmujoco-dev", has_mujoco},
          {"stitching and calibration by images", "libopencv-features2d-dev, libopencv-calib3d-dev",
           has_opencv},
          {"ROS 1 bags", "librosbag-storage-dev", has_rosbag},
          {"robots in URDF", "liburdfdom-dev", has_urdf},
          {"files in YAML", "libyaml-cpp-dev", has_yaml},
          {"videos", "libgif-dev", has_gif_writer},
          {"the baseline LCCP", "libpcl-dev", has_pcl}};
}

std::string version_text() {
  std::string with, without;
  for (const OptionalPart& part : optional_parts()) {
    if (part.is_in)
      with += "\n  " + part.name;
    else
      without += fmt::format("\n  {} (needs {})", part.name, part.needs);
  }
  std::string text = "symscene " SYMSCENE_VERSION;
  if (!with.empty()) text += "\nwith" + with;
  if (!without.empty()) text += "\nwithout" + without;
  return text;
}

}  // namespace symscene::app
