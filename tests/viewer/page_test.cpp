#include "symscene/viewer/page.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "symscene/core/error.hpp"
#include "symscene/viewer/page_surface.hpp"
#include "viewer/page_payload.hpp"

namespace symscene {
namespace {

/// A result of `count` points on a line and one object that holds the first two.
SegmentationResult small_result(Index count = 5) {
  SegmentationResult result;
  result.cloud.positions.resize(count, 3);
  for (Index i = 0; i < count; ++i) {
    result.cloud.positions.row(i) << 0.1F * static_cast<float>(i), 0.0F, -0.2F;
  }
  SceneObject object;
  object.points = {0, 1};
  object.score = 0.9;
  object.rotational.push_back({RotationAxis{}, 0.01});
  object.reflectional.push_back({ReflectionPlane{}, 0.02});
  result.objects.push_back(object);
  result.completed.emplace_back();
  result.timings.push_back({"merge", 0.001});
  result.funnel.push_back({"axes", 3});
  result.rejected.push_back({"rotational", "occlusion", 0.02, 0.015, 120});
  return result;
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(Page, IsOneDocumentWithoutPlaceholders) {
  const std::string page = render_page(small_result(), {.title = "Two cups"});
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  EXPECT_NE(page.find("<title>Two cups</title>"), std::string::npos);
  EXPECT_EQ(page.find("@@SYMSCENE"), std::string::npos);
  EXPECT_EQ(page.find("src=\"http"), std::string::npos);
  EXPECT_EQ(occurrences(page, "<script"), 2U);
}

TEST(Page, HasClosedSurfacesWithObservedVerticesWhite) {
  SegmentationResult result = small_result();
  ObjectSurface surface;
  surface.mesh.vertices.resize(6, 3);
  surface.mesh.vertices << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1;
  surface.mesh.triangles.resize(2, 3);
  surface.mesh.triangles << 0, 1, 2, 3, 4, 5;
  surface.observed = {1, 0};
  result.surfaces = {surface};
  EXPECT_NE(page_payload(result).find("\"closed\":{\"colors\":\"////////////AAAAAAAAAAAA\""),
            std::string::npos);
  result.surfaces = {ObjectSurface{}};
  EXPECT_NE(page_payload(result).find("\"closed\":null"), std::string::npos);
}

TEST(Page, EscapesMarkupInTexts) {
  const std::string hostile = "</title></script><script>alert(1)</script><!--";
  SegmentationResult result = small_result();
  result.timings[0].stage = hostile;
  result.rejected[0].reason = hostile;
  result.funnel[0].step = hostile;
  result.warnings = {hostile};
  const std::string page = render_page(result, {.title = hostile, .note = hostile});
  const std::string harmless = render_page(small_result());
  for (const char* markup : {"<script", "</script", "</title", "<!--", "alert(1)</"}) {
    EXPECT_EQ(occurrences(page, markup), occurrences(harmless, markup)) << markup;
  }
}

TEST(Page, AcceptsTextThatIsNotUtf8) {
  const std::string page = render_page(small_result(), {.title = "caf\xE9"});
  EXPECT_NE(page.find("caf\\ufffd"), std::string::npos);
}

TEST(Payload, HoldsTheContentsOfTheResult) {
  const std::string json = page_payload(small_result(), {.title = "t"});
  EXPECT_NE(json.find(R"("funnel":[{"count":3,"step":"axes"}])"), std::string::npos);
  EXPECT_NE(json.find(R"("points":"AAAAAAEAAAA=")"), std::string::npos);
  EXPECT_NE(json.find(R"("reason":"occlusion")"), std::string::npos);
  EXPECT_NE(json.find(R"("up":[0.0,0.0,1.0])"), std::string::npos);
  EXPECT_NE(json.find(R"("warnings":[])"), std::string::npos);
}

TEST(Payload, HoldsTheWarnings) {
  SegmentationResult result = small_result();
  result.warnings = {"no occupancy map", "no table"};
  EXPECT_NE(page_payload(result).find(R"("warnings":["no occupancy map","no table"])"),
            std::string::npos);
}

/// A grasp of the object of small_result(), and rejected candidates.
PageGrasps small_grasps(std::size_t rejected) {
  PageGrasps grasps;
  grasps.gripper.name = "two fingers";
  Grasp grasp;
  grasp.T_world_tool.translation() << 0.1, 0.0, 0.25;
  grasp.T_world_tool.linear().diagonal() << 1.0, -1.0, -1.0;
  grasp.quality = 0.75;
  grasp.source = GraspSource::rim;
  grasps.plan.grasps = {grasp};
  for (std::size_t k = 0; k < rejected; ++k)
    grasps.plan.rejected.push_back({grasp, GraspRejection::table, -0.01, 0.002});
  ObjectGraspSummary summary;
  summary.candidates = rejected + 1;
  summary.grasps = 1;
  summary.rejected[static_cast<std::size_t>(GraspRejection::table)] = rejected;
  grasps.plan.objects = {summary};
  return grasps;
}

TEST(Payload, HoldsGraspsWithGripperAndReasons) {
  const std::string json = page_payload(small_result(), {.grasps = small_grasps(1)});
  EXPECT_NE(json.find(R"("name":"two fingers")"), std::string::npos);
  EXPECT_NE(json.find(R"("approach":[0.0,0.0,-1.0],"closing":[0.0,-1.0,0.0])"), std::string::npos);
  EXPECT_NE(json.find(R"("position":[0.1,0.0,0.25],"quality":0.75,"source":"rim")"),
            std::string::npos);
  EXPECT_NE(json.find(R"("reason":"table")"), std::string::npos);
  EXPECT_NE(json.find(R"("rejected":{"table":1})"), std::string::npos);
  EXPECT_NE(json.find(R"("table":"the gripper would hit the table")"), std::string::npos);
  EXPECT_NE(page_payload(small_result()).find(R"("grasps":null)"), std::string::npos);
}

TEST(Payload, CountsAllRejectedGraspsButHoldsAFewOfEachReason) {
  const std::string json = page_payload(small_result(), {.grasps = small_grasps(1000)});
  EXPECT_NE(json.find(R"("rejected":{"table":1000})"), std::string::npos);
  EXPECT_EQ(occurrences(json, R"("bound":0.002)"), 12U);
}

TEST(Payload, RefusesGraspsThatAreNotOfTheResult) {
  PageGrasps foreign = small_grasps(1);
  foreign.plan.rejected[0].grasp.object = 1;
  EXPECT_THROW(page_payload(small_result(), {.grasps = foreign}), InputError);
  PageGrasps more = small_grasps(0);
  more.plan.objects.emplace_back();
  EXPECT_THROW(page_payload(small_result(), {.grasps = more}), InputError);
  PageGrasps broken = small_grasps(0);
  broken.plan.grasps[0].T_world_tool.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(page_payload(small_result(), {.grasps = broken}), InputError);
}

/// A view from above, looking down.
PageViews small_views() {
  PageViews views;
  views.policy = "symmetry";
  PageView view;
  view.candidate = 17;
  view.T_world_camera.linear().diagonal() << 1.0, -1.0, -1.0;
  view.T_world_camera.translation() << 0.0, 0.0, 0.5;
  view.gain = 12.5;
  views.views = {view};
  return views;
}

TEST(Payload, HoldsViewsWithTheirAxesAndGains) {
  const std::string json = page_payload(small_result(), {.views = small_views()});
  EXPECT_NE(json.find(R"("forward":[0.0,0.0,-1.0],"position":[0.0,0.0,0.5])"), std::string::npos);
  EXPECT_NE(json.find(R"("candidate":17)"), std::string::npos);
  EXPECT_NE(json.find(R"("gain":12.5)"), std::string::npos);
  EXPECT_NE(page_payload(small_result()).find(R"("views":null)"), std::string::npos);
}

TEST(Payload, RefusesViewsThatAreNotFinite) {
  PageViews views = small_views();
  views.views[0].gain = std::numeric_limits<double>::infinity();
  EXPECT_THROW(page_payload(small_result(), {.views = views}), InputError);
  views = small_views();
  views.half_width = 0.0;
  EXPECT_THROW(page_payload(small_result(), {.views = views}), InputError);
}

TEST(Payload, QuantizesCoordinatesUnlessTheBoxIsLarge) {
  SegmentationResult result = small_result(2);
  EXPECT_NE(page_payload(result).find(R"("data":"AAAAAAAA//8AAAAA")"), std::string::npos);
  result.cloud.positions(1, 0) = 100.0F;
  EXPECT_NE(page_payload(result).find(R"("encoding":"f32")"), std::string::npos);
}

TEST(Payload, TakesUpDirectionAndHeightFromTheTable) {
  const Plane table{Eigen::Vector3d(0.0, -2.0, 0.0), 1.0};
  const std::string json = page_payload(small_result(), {.table = table});
  EXPECT_NE(json.find(R"("table":-0.5)"), std::string::npos);
  EXPECT_NE(json.find("-1.0,0.0]"), std::string::npos);
}

TEST(Payload, AcceptsAnEmptyResult) {
  const std::string json = page_payload(SegmentationResult{});
  EXPECT_NE(json.find(R"("objects":[])"), std::string::npos);
}

/// A table of 4 cm squares at the height of the points of small_result(), 3 m wide.
TriangleMesh small_surface() {
  constexpr Index side = 75;
  TriangleMesh mesh;
  mesh.vertices.resize((side + 1) * (side + 1), 3);
  for (Index i = 0; i < mesh.vertices.rows(); ++i) {
    mesh.vertices.row(i) << 0.04F * static_cast<float>(i % (side + 1)) - 1.5F,
        0.04F * static_cast<float>(i / (side + 1)) - 1.5F, -0.2F;
  }
  mesh.triangles.resize(2 * side * side, 3);
  for (Index i = 0; i < side * side; ++i) {
    const Index a = i / side * (side + 1) + i % side;
    mesh.triangles.row(2 * i) << a, a + 1, a + side + 2;
    mesh.triangles.row(2 * i + 1) << a, a + side + 2, a + side + 1;
  }
  return mesh;
}

const PageSurfaceOptions wide_reach{.reach = 0.03F};

TEST(PageSurface, IsTheSurfaceAroundTheObjects) {
  const TriangleMesh shown = page_surface(small_surface(), small_result(), wide_reach);
  EXPECT_GT(shown.triangles.rows(), 100);
  // The object's points are at x = 0 and 0.1.
  const Eigen::RowVector3f center(0.05F, 0.0F, -0.2F);
  const float farthest = (shown.vertices.rowwise() - center).rowwise().norm().maxCoeff();
  EXPECT_LE(farthest, 0.05F + wide_reach.margin + 1e-5F);
}

TEST(PageSurface, IsAroundTheCloudIfThereIsNoObject) {
  SegmentationResult result = small_result();
  result.objects.clear();
  EXPECT_GT(page_surface(small_surface(), result, wide_reach).triangles.rows(),
            page_surface(small_surface(), small_result(), wide_reach).triangles.rows());
}

TEST(PageSurface, IsAllOfItIfThereIsNoPoint) {
  const TriangleMesh surface = small_surface();
  EXPECT_EQ(page_surface(surface, SegmentationResult{}).triangles.rows(), surface.triangles.rows());
  PageSurfaceOptions options;
  options.max_triangles = 150;
  const TriangleMesh thinned = page_surface(surface, SegmentationResult{}, options);
  EXPECT_GT(thinned.triangles.rows(), 0);
  EXPECT_LE(thinned.triangles.rows(), 150);
}

TEST(PageSurface, IsIdempotent) {
  PageSurfaceOptions options = wide_reach;
  options.max_triangles = 150;
  const TriangleMesh once = page_surface(small_surface(), small_result(), options);
  EXPECT_LE(once.triangles.rows(), 150);
  options.reach = 1.0F;
  const TriangleMesh twice = page_surface(once, small_result(), options);
  EXPECT_EQ(twice.triangles.rows(), once.triangles.rows());
}

TEST(PageSurface, RefusesASurfaceOfAnotherFrame) {
  TriangleMesh elsewhere = small_surface();
  elsewhere.vertices.col(2).array() += 0.1F;
  EXPECT_THROW(page_surface(elsewhere, small_result()), InputError);
  elsewhere.vertices.col(2).array() += 100.0F;
  EXPECT_THROW(page_surface(elsewhere, small_result()), InputError);
  EXPECT_THROW(render_page(small_result(), {.surface = elsewhere}), InputError);
  elsewhere.vertices.setConstant(std::numeric_limits<float>::quiet_NaN());
  EXPECT_THROW(page_surface(elsewhere, small_result()), InputError);
}

TEST(Payload, HoldsSurfaceAndPathIfGiven) {
  const std::string without = page_payload(small_result());
  EXPECT_NE(without.find(R"("surface":null)"), std::string::npos);
  EXPECT_NE(without.find(R"("trajectory":null)"), std::string::npos);

  PageOptions options;
  options.surface.vertices.resize(4, 3);
  options.surface.vertices << 0, 0, -0.2F, 0.1F, 0, -0.2F, 0, 0.1F, -0.2F, 0.3F, 0, -0.2F;
  options.surface.triangles.resize(2, 3);
  options.surface.triangles << 2, 1, 0, 0, 1, 3;
  options.trajectory.resize(1);
  SegmentationResult result = small_result(2);
  const std::string json = page_payload(result, options);
  // New, new, new; then the vertex that came up last, the one before it, and a new one.
  EXPECT_NE(json.find(R"("triangles":{"count":2,"data":"AAAAAQIA"})"), std::string::npos);
  EXPECT_NE(json.find(R"("frames":1)"), std::string::npos);
  EXPECT_NE(json.find(R"("forward":[0.0,0.0,1.0])"), std::string::npos);
}

TEST(Payload, HoldsGroundTruthAndSweepIfGiven) {
  PageOptions options;
  options.truth = {{"mug", {0, 1}}};
  options.sweep = {{Eigen::Isometry3d::Identity(), {2, 1, {0, 255}}}};
  const std::string payload = page_payload(small_result(), options);
  EXPECT_NE(payload.find("\"truth\":[{\"name\":\"mug\",\"points\":\"AAAAAAEAAAA=\"}]"),
            std::string::npos);
  EXPECT_NE(payload.find("{\"data\":\"AP8=\",\"height\":1,\"width\":2}"), std::string::npos);
  options.sweep.front().depth.nearness.pop_back();
  EXPECT_THROW(page_payload(small_result(), options), InputError);
  options.sweep.clear();
  options.truth.front().points = {99};
  EXPECT_THROW(page_payload(small_result(), options), InputError);
}

TEST(Payload, HoldsAtMost128PointsOfARejectedHypothesis) {
  SegmentationResult result = small_result(400);
  for (Index i = 0; i < 400; ++i) result.rejected[0].points.push_back(i);
  const std::string payload = page_payload(result);
  const std::size_t rejected = payload.find("\"rejected\":");
  const std::size_t points = payload.find("\"points\":\"", rejected) + 10;
  EXPECT_EQ(payload.find('"', points) - points, (4 * 128 + 2) / 3 * 4);
}

TEST(ShownDepth, TakesTheNearestOfThePixelsInOne) {
  const CameraIntrinsics camera{.width = 4, .height = 2, .fx = 1, .fy = 1, .cx = 1, .cy = 1};
  const std::vector<float> depth{0, 2, 0, 0, 1, 3, 0, 0};
  const ShownDepth shown = shown_depth(depth, camera, 2);
  EXPECT_EQ(shown.width, 2U);
  EXPECT_EQ(shown.height, 1U);
  EXPECT_EQ(shown.nearness, (std::vector<std::uint8_t>{1, 0}));
  EXPECT_THROW(shown_depth(depth, camera, 0), InputError);
}

TEST(Payload, RefusesAnInvalidResult) {
  SegmentationResult outside = small_result();
  outside.objects[0].points = {99};
  EXPECT_THROW(page_payload(outside), InputError);

  SegmentationResult infinite = small_result();
  infinite.cloud.positions(0, 0) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(page_payload(infinite), InputError);

  SegmentationResult uneven = small_result();
  uneven.completed.resize(3);
  EXPECT_THROW(page_payload(uneven), InputError);
  uneven.completed.clear();
  uneven.surfaces.resize(3);
  EXPECT_THROW(page_payload(uneven), InputError);

  EXPECT_THROW(page_payload(small_result(), {.up = Eigen::Vector3d::Zero()}), InputError);
}

}  // namespace
}  // namespace symscene
