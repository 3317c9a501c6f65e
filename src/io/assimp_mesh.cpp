#include "io/assimp_mesh.hpp"

#include <exception>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include <assimp/BaseImporter.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>

#include "io/color.hpp"
#include "io/text.hpp"
#include "io/weld.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/atomic_file.hpp"

namespace symscene {
namespace {

constexpr unsigned post_processing = aiProcess_Triangulate;

/// Finds no file: what is parsed from memory stands for itself.
class NoFiles : public Assimp::IOSystem {
 public:
  bool Exists(const char* /*path*/) const override { return false; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* /*path*/, const char* /*mode*/) override { return nullptr; }
  void Close(Assimp::IOStream* /*stream*/) override {}
};

/// Leaves only the formats that we ask for, so that no other importer guesses at a file.
void keep_known_formats(Assimp::Importer& importer) {
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
    const aiImporterDesc* description = importer.GetImporterInfo(i);
    const std::string_view extensions = description != nullptr ? description->mFileExtensions : "";
    bool known = false;
    for (const std::string_view extension : words_of(extensions)) {
      known = known || extension == "obj" || extension == "stl" || extension == "glb";
    }
    if (known) continue;
    const std::unique_ptr<Assimp::BaseImporter> dropped(importer.GetImporter(i));
    importer.UnregisterLoader(dropped.get());
  }
}

/// Meshes joined, each moved to where its node puts it.
class MeshJoiner {
 public:
  explicit MeshJoiner(const aiScene& scene) : scene_(scene) {}

  TriangleMesh join() {
    add_nodes();
    TriangleMesh mesh;
    using RowPoints = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;
    mesh.vertices = Eigen::Map<const RowPoints>(positions_.data(), rows(positions_), 3);
    mesh.triangles = Eigen::Map<const decltype(mesh.triangles)>(corners_.data(), rows(corners_), 3);
    if (has_colors_) mesh.colors = Eigen::Map<const Colors>(colors_.data(), rows(colors_), 3);
    return mesh;
  }

 private:
  template <class Value>
  static Eigen::Index rows(const std::vector<Value>& values) {
    return static_cast<Eigen::Index>(values.size() / 3);
  }

  void add_nodes() {
    std::vector<std::pair<const aiNode*, aiMatrix4x4>> open = {{scene_.mRootNode, {}}};
    while (!open.empty()) {
      const auto [node, T_world_parent] = open.back();
      open.pop_back();
      const aiMatrix4x4 T_world_node = T_world_parent * node->mTransformation;
      for (unsigned m = 0; m < node->mNumMeshes; ++m) {
        add_mesh(*scene_.mMeshes[node->mMeshes[m]], T_world_node);
      }
      for (unsigned c = node->mNumChildren; c-- > 0;) {
        open.emplace_back(node->mChildren[c], T_world_node);
      }
    }
  }

  void add_mesh(const aiMesh& mesh, const aiMatrix4x4& T_world_mesh) {
    const auto first = static_cast<Index>(positions_.size() / 3);
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D position = T_world_mesh * mesh.mVertices[v];
      positions_.insert(positions_.end(), {position.x, position.y, position.z});
      add_color(mesh, v);
    }
    const bool mirrored = T_world_mesh.Determinant() < 0.0F;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) continue;
      const unsigned second = mirrored ? 2 : 1;
      for (const unsigned k : {0U, second, 3U - second}) {
        if (face.mIndices[k] >= mesh.mNumVertices) throw std::out_of_range("face");
        corners_.push_back(first + face.mIndices[k]);
      }
    }
  }

  void add_color(const aiMesh& mesh, unsigned v) {
    const bool colored = mesh.HasVertexColors(0);
    has_colors_ = has_colors_ || colored;
    const aiColor4D color = colored ? mesh.mColors[0][v] : aiColor4D(1.0F, 1.0F, 1.0F, 1.0F);
    for (const float channel : {color.r, color.g, color.b}) {
      colors_.push_back(to_color(channel * 255.0F));
    }
  }

  const aiScene& scene_;
  std::vector<float> positions_;
  std::vector<std::uint8_t> colors_;
  std::vector<Index> corners_;
  bool has_colors_ = false;
};

TriangleMesh mesh_of(const Assimp::Importer& importer, const aiScene* scene,
                     const std::string& name) {
  if (scene == nullptr || scene->mRootNode == nullptr) {
    throw InputError(name, "a mesh", in_quotes(importer.GetErrorString()));
  }
  TriangleMesh mesh = weld_vertices(MeshJoiner(*scene).join());
  if (mesh.triangles.rows() == 0) throw InputError(name, "a mesh", "no triangle");
  return mesh;
}

/// Calls import(importer) for a scene; whatever Assimp throws becomes an InputError.
template <class Import>
TriangleMesh guarded(const std::string& name, const Import& import) {
  try {
    Assimp::Importer importer;
    keep_known_formats(importer);
    return mesh_of(importer, import(importer), name);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(name, "a mesh", in_quotes(error.what()));
  }
}

}  // namespace

TriangleMesh load_with_assimp(const std::filesystem::path& path) {
  read_file(path);  // for the message if it cannot be read
  return guarded(path.string(), [&](Assimp::Importer& importer) {
    return importer.ReadFile(path.string(), post_processing);
  });
}

TriangleMesh parse_with_assimp(std::string_view bytes, const std::string& extension,
                               const std::string& name) {
  return guarded(name, [&](Assimp::Importer& importer) {
    importer.SetIOHandler(std::make_unique<NoFiles>().release());  // the importer owns it
    return importer.ReadFileFromMemory(bytes.data(), bytes.size(), post_processing,
                                       extension.c_str());
  });
}

}  // namespace symscene
