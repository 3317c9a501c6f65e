#pragma once

#include <filesystem>

#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// Reads the points of a PLY or PCD file, recognised by the first bytes; values that are not finite
/// are kept.
/// Throws InputError if it is neither, or cannot be read.
PointCloud read_cloud(const std::filesystem::path& path);

/// A cloud and where its sensor was.
struct SensorCloud {
  PointCloud cloud;
  Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();  ///< VIEWPOINT of a PCD file [m]
};

/// The same, with the position of the sensor: the origin where the file does not give it.
SensorCloud read_sensor_cloud(const std::filesystem::path& path);

/// Writes a PLY (little-endian) or PCD (binary) file, by the extension of `path`, atomically.
/// Throws InputError if the extension is another, normals or colours are not as many as the points,
/// or the file cannot be written.
void write_cloud(const std::filesystem::path& path, const PointCloud& cloud);

}  // namespace symscene
