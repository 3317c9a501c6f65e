#pragma once

namespace symscene {

/// Whether this build has physics (MuJoCo); without it what needs it throws InputError.
bool has_physics();

}  // namespace symscene
