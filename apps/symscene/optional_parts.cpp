#include "optional_parts.hpp"

#include <fmt/format.h>

namespace symscene::app {
// CMake defines SYMSCENE_WITH_PART as 1 for each part that is built, as 0 for others.
std::vector<OptionalPart> optional_parts() {
  return {{"evaluation", "SYMSCENE_BUILD_EVALUATION", SYMSCENE_WITH_EVALUATION == 1},
          {"simulation", "SYMSCENE_BUILD_SIMULATION", SYMSCENE_WITH_SIMULATION == 1},
          {"physics", "libmujoco-dev", SYMSCENE_WITH_MUJOCO == 1},
          {"stitching and calibration by images", "libopencv-features2d-dev, libopencv-calib3d-dev",
           SYMSCENE_WITH_OPENCV == 1},
          {"ChArUco boards", "libopencv-contrib-dev", SYMSCENE_WITH_ARUCO == 1},
          {"ROS 1 bags", "librosbag-storage-dev", SYMSCENE_WITH_ROSBAG == 1},
          {"rosbag2 files of SQLite", "libsqlite3-dev", SYMSCENE_WITH_SQLITE == 1},
          {"MCAP compressed by LZ4", "liblz4-dev", SYMSCENE_WITH_LZ4 == 1},
          {"MCAP compressed by Zstandard", "libzstd-dev", SYMSCENE_WITH_ZSTD == 1},
          {"robots in URDF", "liburdfdom-dev", SYMSCENE_WITH_URDF == 1},
          {"files in YAML", "libyaml-cpp-dev", SYMSCENE_WITH_YAML == 1},
          {"the page of live scenes", "libcpp-httplib-dev", SYMSCENE_WITH_HTTP == 1},
          {"videos", "libgif-dev", SYMSCENE_WITH_GIF == 1},
          {"the baseline LCCP", "libpcl-dev", SYMSCENE_WITH_PCL == 1}};
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
