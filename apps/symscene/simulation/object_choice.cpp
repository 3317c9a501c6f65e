#include "simulation/object_choice.hpp"

#include <fmt/format.h>

#include "symscene/physics/physics_world.hpp"

namespace symscene::app {
namespace {

constexpr const char* household = "household";

}  // namespace

void ObjectChoice::add_to(Arguments& arguments) {
  arguments.text("--objects", "FOLDER|household", name,
                 "folder of meshes in metres, or household for simulated ones (default household)");
}

bool ObjectChoice::is_folder() const { return name != household; }

void ObjectChoice::check(const std::filesystem::path& output) const {
  if (!is_folder()) return;
  if (!std::filesystem::is_directory(name))
    throw InputError("--objects", fmt::format("a folder of meshes, or \"{}\"", household), name);
  require_not_input(output, name);
}

void require_physics(const char* flag, const std::string& without) {
  if (has_physics()) return;
  throw InputError(flag,
                   "a build with physics (the package libmujoco-dev, then configure and build "
                   "again)" +
                       without,
                   "one without");
}

}  // namespace symscene::app
