#pragma once

#include "symscene/reconstruction/tsdf_volume.hpp"

namespace symscene {

/// The surface of the model as a camera at a pose would see it.
struct ModelView {
  SurfaceImage image;  ///< in the camera's frame
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
};

/// Casts a ray through every pixel to the first crossing of zero from before the surface to behind
/// it, found by trilinear interpolation (Newcombe et al. 2011, section 3.4). Rays start where
/// blocks that hold surface begin and skip those that hold none; where the corners of a tile of 4×4
/// pixels show one surface, those between them start shortly before it. (A thing that is thinner
/// than a tile and stands free before that surface can be missed, if no corner shows it.) Normals
/// are the gradient of the field.
ModelView cast_model_view(const TsdfVolume& volume, const CameraIntrinsics& camera,
                          const Eigen::Isometry3d& T_world_camera);

}  // namespace symscene
