// Writes a page from C++ for the browser's tests: make_page PAGE.html
#include <fstream>
#include <numbers>

#include "symscene/viewer/page.hpp"

namespace {

/// The front half of a can that stands on the table at (x, 0).
void add_can(symscene::SegmentationResult& result, float x) {
  constexpr int around = 60;
  constexpr int rows = 40;
  symscene::Points& positions = result.cloud.positions;
  symscene::Points& normals = result.cloud.normals;
  Eigen::Index next = positions.rows();
  positions.conservativeResize(next + around * rows, Eigen::NoChange);
  normals.conservativeResize(next + around * rows, Eigen::NoChange);
  symscene::SceneObject object;
  for (int k = 0; k < around * rows; ++k, ++next) {
    const float angle =
        -std::numbers::pi_v<float> * static_cast<float>(k % around) / static_cast<float>(around);
    normals.row(next) << std::cos(angle), std::sin(angle), 0.0F;
    positions.row(next) << x, 0.0F, 0.003F * static_cast<float>(k / around);
    positions.row(next) += 0.04F * normals.row(next);
    object.points.push_back(static_cast<symscene::Index>(next));
  }
  object.score = 0.9;
  object.centroid = {x, 0.0, 0.06};
  object.rotational.push_back({{object.centroid, Eigen::Vector3d::UnitZ()}, 0.01});
  result.objects.push_back(object);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  symscene::SegmentationResult result;
  for (const float x : {-0.12F, 0.0F, 0.12F}) add_can(result, x);
  result.timings.push_back({"rotational", 0.02});
  std::ofstream(argv[1], std::ios::binary)
      << symscene::render_page(result, {.title = "Three cans", .table = symscene::Plane{}});
}
