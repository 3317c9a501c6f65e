#pragma once

#include <functional>

#include "symscene/motion/joint_path.hpp"

namespace symscene {

/// Whether the arcs that round the corners of a path are free. `is_free` checks straight motions
/// between two configurations: the chords of the arcs.
bool arcs_are_free(
    const JointPath& path,
    const std::function<bool(const Eigen::VectorXd&, const Eigen::VectorXd&)>& is_free);

}  // namespace symscene
