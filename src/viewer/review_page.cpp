#include "symscene/viewer/review_page.hpp"

#include <algorithm>

#include "core/mesh_thinning.hpp"
#include "encoding.hpp"
#include "page_filling.hpp"
#include "page_template.hpp"
#include "scan_payload.hpp"

namespace symscene {
namespace {

using nlohmann::json;

constexpr Index all_triangles = 400'000;  ///< of all models: 4.4 MB
constexpr Index most_triangles = 20'000;  ///< of a model
constexpr Index fewest_triangles = 2'000;
constexpr Index most_points = 6'000;    ///< of a model without triangles
constexpr double smallest_cell = 1e-3;  ///< by the diagonal

json order_of(const ReviewedSymmetry& symmetry) {
  if (symmetry.kind != ReviewedSymmetry::Kind::axis) return nullptr;
  return symmetry.order == 0 ? json("continuous") : json(symmetry.order);
}

json symmetry_payload(const ReviewedSymmetry& symmetry, const ReviewedModel& model) {
  return {{"kind", to_string(symmetry.kind)},
          {"order", order_of(symmetry)},
          {"point", encode(symmetry.point)},
          {"direction", encode(symmetry.direction)},
          {"residual_mm", model.millimetres * symmetry.residual},
          {"residual_percent", 100.0 * symmetry.residual / model.diagonal}};
}

json model_payload(const ReviewedModel& model, Index max_triangles) {
  const auto cell = static_cast<float>(smallest_cell * model.diagonal);
  TriangleMesh mesh = thin(model.mesh, max_triangles, cell);
  mesh.colors.resize(0, 3);
  json symmetries = json::array();
  for (const ReviewedSymmetry& symmetry : model.symmetries)
    symmetries.push_back(symmetry_payload(symmetry, model));
  json payload = {{"name", model.name},
                  {"diameter_mm", model.millimetres * model.diameter},
                  {"diagonal_mm", model.millimetres * model.diagonal},
                  {"diagonal", model.diagonal},
                  {"surface", surface_payload(mesh)},
                  {"symmetries", std::move(symmetries)}};
  if (mesh.triangles.rows() == 0) {
    const auto count = static_cast<Index>(mesh.vertices.rows());
    payload["points"] =
        encode_positions(mesh.vertices(evenly_spread(count, most_points), Eigen::all));
  }
  return payload;
}

}  // namespace

const char* to_string(ReviewedSymmetry::Kind kind) {
  switch (kind) {
    case ReviewedSymmetry::Kind::plane:
      return "plane";
    case ReviewedSymmetry::Kind::axis:
      return "axis";
    case ReviewedSymmetry::Kind::sphere:
      return "sphere";
  }
  return "";
}

std::string render_review_page(const std::vector<ReviewedModel>& models, const std::string& title) {
  const auto count = static_cast<Index>(std::max<std::size_t>(models.size(), 1));
  const Index share = std::clamp(all_triangles / count, fewest_triangles, most_triangles);
  json list = json::array();
  for (const ReviewedModel& model : models) list.push_back(model_payload(model, share));
  const json payload = {{"version", 1}, {"title", title}, {"models", std::move(list)}};
  return fill_page(review_template(), title, script_json(payload));
}

}  // namespace symscene
