#pragma once

#include <string>

#include "arguments.hpp"
#include "core/naming.hpp"
#include "session.hpp"
#include "symscene/simulation/scanned_models.hpp"

namespace symscene::app {

/// --objects of subcommands that simulate a table: a folder of meshes, or household objects.
struct ObjectChoice {
  std::string name = "household";

  void add_to(Arguments& arguments);

  bool is_folder() const;

  /// Throws InputError unless household objects or a folder outside of which `output` lies are
  /// named.
  void check(const std::filesystem::path& output) const;

  /// Calls furnish(models) with the models of the folder, of which there are none for household
  /// objects. Errors name the folder; the session prints its warnings.
  template <class Furnish>
  auto furnished(Session& session, const Furnish& furnish) const {
    if (!is_folder()) return furnish(std::vector<ObjectModel>{});
    const ModelFolder folder = read_models(name, {});
    session.warn(folder.warnings);
    return naming(name, [&] { return furnish(folder.models); });
  }
};

/// Throws InputError, which names `flag`, unless physics is built in; `without` tells what is there
/// without it.
void require_physics(const char* flag, const std::string& without = "");

}  // namespace symscene::app
