#include "symscene/dataset/scanned_models.hpp"

#include <algorithm>

#include "symscene/io/mesh.hpp"
#include "symscene/io/truth.hpp"

namespace symscene {

std::vector<ObjectModel> read_models(const std::filesystem::path& meshes,
                                     const std::filesystem::path& symmetries) {
  std::vector<TrueObject> known;
  if (!symmetries.empty()) known = read_model_symmetries(symmetries);
  std::vector<ObjectModel> models;
  for (NamedMesh& file : read_mesh_folder(meshes)) {
    ObjectModel model{std::move(file.name), std::move(file.mesh), {}, {}, false};
    const auto own = std::find_if(known.begin(), known.end(), [&](const TrueObject& object) {
      return object.name == model.name;
    });
    if (own != known.end()) {
      model.rotational = own->rotational;
      model.reflectional = own->reflectional;
      model.sphere = own->sphere;
    }
    models.push_back(std::move(model));
  }
  return models;
}

}  // namespace symscene
