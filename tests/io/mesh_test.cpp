#include "symscene/io/mesh.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <limits>

#include "io/io_support.hpp"

namespace symscene {
namespace {

using namespace io_test;

const std::string tetrahedron_obj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

TriangleMesh tetrahedron() { return parse_mesh(tetrahedron_obj, "obj", "x"); }

std::string tetrahedron_stl() {
  const TriangleMesh mesh = tetrahedron();
  std::string stl(80, ' ');
  const auto append = [&](auto value) {
    stl.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  append(std::uint32_t{4});
  for (Eigen::Index t = 0; t < 4; ++t) {
    for (int k = 0; k < 3; ++k) append(0.0F);
    for (int corner = 0; corner < 3; ++corner) {
      for (int k = 0; k < 3; ++k) append(mesh.vertices(mesh.triangles(t, corner), k));
    }
    append(std::uint16_t{0});
  }
  return stl;
}

/// A triangle with colours that its node moves by (10, 0, 0) and scales by (2, 2, `z_scale`).
std::string triangle_glb(const std::string& z_scale = "2") {
  std::string binary;
  const auto append = [](std::string& out, auto value) {
    out.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) append(binary, x);
  for (const float c : {1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F}) append(binary, c);
  for (const std::uint32_t i : {0U, 1U, 2U}) append(binary, i);
  std::string json =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"children":[1],)"
      R"("translation":[10,0,0]},{"mesh":0,"scale":[2,2,)" +
      z_scale +
      R"(]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"COLOR_0":1},"indices":2}]}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",)"
      R"("min":[0,0,0],"max":[1,1,0]},{"bufferView":1,"componentType":5126,"count":3,)"
      R"("type":"VEC3"},{"bufferView":2,"componentType":5125,"count":3,"type":"SCALAR"}],)"
      R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},{"buffer":0,"byteOffset":36,)"
      R"("byteLength":36},{"buffer":0,"byteOffset":72,"byteLength":12}],)"
      R"("buffers":[{"byteLength":84}]})";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string glb = "glTF";
  append(glb, std::uint32_t{2});
  append(glb, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + binary.size()));
  append(glb, static_cast<std::uint32_t>(json.size()));
  glb += "JSON" + json;
  append(glb, static_cast<std::uint32_t>(binary.size()));
  return glb + std::string("BIN\0", 4) + binary;
}

TEST(Mesh, PolygonsOfAnObjAreSplitIntoTriangles) {
  const TriangleMesh mesh =
      parse_mesh("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", "obj", "x");
  EXPECT_EQ(mesh.vertices.rows(), 4);
  EXPECT_EQ(mesh.triangles.rows(), 2);
  EXPECT_EQ(mesh.colors.rows(), 0);
}

TEST(Mesh, TrianglesOfAnStlShareTheirVertices) {
  const TriangleMesh mesh = parse_mesh(tetrahedron_stl(), "stl", "x");
  EXPECT_EQ(mesh.vertices.rows(), 4);
  EXPECT_EQ(mesh.triangles.rows(), 4);
}

TEST(Mesh, ANonFiniteVertexIsKept) {
  std::string stl = tetrahedron_stl();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(stl.data() + 84 + 12, &nan, sizeof(nan));
  const TriangleMesh mesh = parse_mesh(stl, "stl", "x");
  EXPECT_EQ(mesh.vertices.rows(), 5);
  EXPECT_EQ(mesh.vertices.rowwise().sum().array().isNaN().count(), 1);
}

TEST(Mesh, FilesThatBytesReferToAreNotOpened) {
  const std::string gltf =
      R"({"asset":{"version":"2.0"},"buffers":[{"uri":"/dev/zero","byteLength":4}]})";
  EXPECT_EQ(refusal([&] { parse_mesh(gltf, "gltf", "x"); }),
            "x: buffers[0].uri: expected a file in the same folder, found \"/dev/zero\"");
  EXPECT_EQ(parse_mesh("mtllib /dev/zero\n" + tetrahedron_obj, "obj", "x").triangles.rows(), 4);
}

TEST(Mesh, NodesOfAGlbTransformTheirMeshes) {
  const TriangleMesh mesh = parse_mesh(triangle_glb(), "glb", "x");
  ASSERT_EQ(mesh.triangles.rows(), 1);
  const Eigen::RowVector3f corner = mesh.vertices.row(mesh.triangles(0, 1));
  EXPECT_EQ(corner, Eigen::RowVector3f(12.0F, 0.0F, 0.0F));
  ASSERT_EQ(mesh.colors.rows(), 3);
  EXPECT_EQ(mesh.colors.row(mesh.triangles(0, 1)).cast<int>(), Eigen::RowVector3i(0, 255, 0));
}

/// A glTF with a square as a triangle strip, base64 data and these `nodes`.
std::string strip_gltf(const std::string& nodes, const std::string& count = "4") {
  return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[)" + nodes +
         R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":5}]}],"accessors":)"
         R"([{"bufferView":0,"componentType":5126,"count":)" +
         count +
         R"(,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":48}],"buffers":[{)"
         R"("byteLength":48,"uri":"data:application/octet-stream;base64,)"
         R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAACAPwAAgD8AAAAA"}]})";
}

TEST(Mesh, TriangleStripsAndBase64DataAreRead) {
  const TriangleMesh mesh = parse_mesh(strip_gltf(R"({"mesh":0})"), "gltf", "x");
  decltype(mesh.triangles) expected(2, 3);
  expected << 0, 1, 2, 1, 3, 2;
  EXPECT_EQ(mesh.triangles, expected);
  EXPECT_EQ(mesh.vertices.row(3), Eigen::RowVector3f(1.0F, 1.0F, 0.0F));
}

TEST(Mesh, CyclesOfNodesAndDataOutsideTheirBufferAreRefused) {
  const auto message = [](const std::string& gltf) {
    return refusal([&] { parse_mesh(gltf, "gltf", "a.gltf"); });
  };
  EXPECT_EQ(message(strip_gltf(R"({"mesh":0,"children":[0]})")),
            "a.gltf: nodes[0].children[0]: expected a tree of nodes, found 0");
  EXPECT_EQ(message(strip_gltf(R"({"mesh":0})", "5")),
            "a.gltf: accessors[0]: expected elements inside the 48 bytes of its view, found an "
            "object");
  EXPECT_EQ(message(strip_gltf(R"({"mesh":0})", "18446744073709551615")),
            "a.gltf: accessors[0]: expected elements inside the 48 bytes of its view, found an "
            "object");
  EXPECT_EQ(message(strip_gltf(R"({"mesh":1})")),
            "a.gltf: meshes: expected an array of more than 1, found an array of 1");
}

/// `item` repeated `count` times as items of a JSON array.
std::string repeated(const std::string& item, std::size_t count) {
  std::string items = item;
  for (std::size_t i = 1; i < count; ++i) items += "," + item;
  return items;
}

TEST(Mesh, ManyNodesWithAMeshOfManyPrimitivesAreRefusedQuickly) {
  std::string children = "1";
  for (int node = 2; node <= 6000; ++node) children += fmt::format(",{}", node);
  const std::string gltf = fmt::format(
      R"({{"asset":{{"version":"2.0"}},"scenes":[{{"nodes":[0]}}],"nodes":[{{"children":[{}]}},{}],)"
      R"("meshes":[{{"primitives":[{}]}}]}})",
      children, repeated(R"({"mesh":0})", 6000), repeated(R"({"mode":0})", 6000));
  EXPECT_EQ(refusal([&] { parse_mesh(gltf, "gltf", "a.gltf"); }),
            "a.gltf: meshes[0].primitives: expected at most 1000000 primitives at all nodes, "
            "found more");
}

TEST(Mesh, ManyNodesWithALargeMeshAreRefused) {
  std::string triangles;  // 333 times (0,0,0) (1,0,0) (0,1,0)
  for (int i = 0; i < 333; ++i) triangles += "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
  const auto gltf = [&](std::size_t nodes) {
    std::string children = "1";
    for (std::size_t node = 2; node <= nodes; ++node) children += fmt::format(",{}", node);
    return fmt::format(
        R"({{"asset":{{"version":"2.0"}},"scenes":[{{"nodes":[0]}}],"nodes":[{{"children":[{}]}},)"
        R"({}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],"accessors":[)"
        R"({{"bufferView":0,"componentType":5126,"count":999,"type":"VEC3"}}],"bufferViews":[)"
        R"({{"buffer":0,"byteLength":11988}}],"buffers":[{{"byteLength":11988,"uri":)"
        R"("data:application/octet-stream;base64,{}"}}]}})",
        children, repeated(R"({"mesh":0})", nodes), triangles);
  };
  EXPECT_EQ(parse_mesh(gltf(100), "gltf", "a.gltf").triangles.rows(), 33300);
  EXPECT_EQ(refusal([&] { parse_mesh(gltf(2000), "gltf", "a.gltf"); }),
            "a.gltf: meshes[0].primitives[0]: expected at most 30 vertices and corners per byte "
            "of the file, found more, as many nodes share a mesh");
}

TEST(Mesh, BytesBehindAnStlAreRefusedAndPaddingIsNot) {
  const std::string stl = tetrahedron_stl();
  EXPECT_EQ(parse_mesh(stl + std::string(3, '\0'), "stl", "x").triangles.rows(), 4);
  EXPECT_EQ(refusal([&] { parse_mesh(stl + "more", "stl", "a.stl"); }),
            "a.stl: expected the end of the file, found 4 bytes more");
}

TEST(Mesh, DataBesideAGltfIsReadFromItsFolder) {
  const TemporaryFolder folder;
  std::string gltf = strip_gltf(R"({"mesh":0})");
  const std::size_t begin = gltf.find("data:");
  gltf.replace(begin, gltf.find('"', begin) - begin, "a.bin");
  const float corners[] = {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 1.F, 1.F, 0.F};
  write_text(folder / "a.gltf", gltf);
  EXPECT_THROW(read_mesh(folder / "a.gltf"), InputError);
  write_text(folder / "a.bin", std::string(reinterpret_cast<const char*>(corners), 48));
  EXPECT_EQ(read_mesh(folder / "a.gltf").triangles.rows(), 2);
}

TEST(Mesh, TextStlAndBinaryStlGiveTheSameMesh) {
  const TriangleMesh binary = parse_mesh(tetrahedron_stl(), "stl", "x");
  const TriangleMesh mesh = tetrahedron();
  std::string text = "solid a name\r\n";
  for (Eigen::Index t = 0; t < 4; ++t) {
    text += "facet normal 0 0 0\n  outer loop\n";
    for (int k = 0; k < 3; ++k) {
      const Eigen::RowVector3f v = mesh.vertices.row(mesh.triangles(t, k));
      text += fmt::format("    vertex {} {:e} {}\n", v.x(), v.y(), v.z());
    }
    text += "  endloop\nendfacet\n";
  }
  const TriangleMesh again = parse_mesh(text + "endsolid a name", "stl", "x");
  EXPECT_EQ(again.vertices, binary.vertices);
  EXPECT_EQ(again.triangles, binary.triangles);
  EXPECT_EQ(refusal([&] { parse_mesh(text, "stl", "a.stl"); }),
            "a.stl: expected endsolid, found the end of the file");
}

TEST(Mesh, ObjFacesMayHaveNormalsAndNegativeIndicesAndVerticesColours) {
  const TriangleMesh mesh = parse_mesh(
      "# a comment\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nvn 0 0 1\nvt 0 0\n"
      "f 1//1 2/1 3/1/1\nf -1 -2 -3",
      "obj", "x");
  decltype(mesh.triangles) expected(2, 3);
  expected << 0, 1, 2, 2, 1, 0;
  EXPECT_EQ(mesh.triangles, expected);
  EXPECT_EQ(mesh.colors.row(1).cast<int>(), Eigen::RowVector3i(0, 255, 0));
  for (const char* face : {"f 1 2 4", "f 0 1 2", "f -4 1 2", "f a b c"}) {
    const std::string text = std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\n") + face;
    EXPECT_THROW(parse_mesh(text, "obj", "x"), InputError) << face;
  }
}

TEST(Mesh, AMirroringTransformKeepsTheOrientation) {
  const TriangleMesh mesh = parse_mesh(triangle_glb("-2"), "glb", "x");
  ASSERT_EQ(mesh.triangles.rows(), 1);
  const auto corner = [&](int k) -> Eigen::Vector3f {
    return mesh.vertices.row(mesh.triangles(0, k)).transpose();
  };
  const Eigen::Vector3f normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
  EXPECT_LT(normal.z(), 0.0F);
}

TEST(Mesh, EveryFormatIsRecognisedByItsExtension) {
  const TemporaryFolder folder;
  write_text(folder / "a.OBJ", tetrahedron_obj);
  write_text(folder / "a.stl", tetrahedron_stl());
  write_text(folder / "a.glb", triangle_glb());
  write_mesh(folder / "a.ply", tetrahedron());
  for (const char* file : {"a.OBJ", "a.stl", "a.ply"}) {
    EXPECT_EQ(read_mesh(folder / file).triangles.rows(), 4) << file;
  }
  EXPECT_EQ(read_mesh(folder / "a.glb").triangles.rows(), 1);
}

TEST(MeshFolder, IsSortedByNameAndSkipsFilesThatCannotBeRead) {
  const TemporaryFolder folder;
  write_text(folder / "b.obj", tetrahedron_obj);
  write_mesh(folder / "a.ply", tetrahedron());
  write_text(folder / "corrupt.ply", "ply\nformat");
  write_text(folder / "notes.txt", "no mesh");
  const auto [meshes, warnings] = read_mesh_folder(folder / ".");
  ASSERT_EQ(meshes.size(), 2U);
  EXPECT_EQ(meshes[0].name, "a");
  EXPECT_EQ(meshes[1].name, "b");
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("corrupt.ply"), std::string::npos);
}

TEST(MeshFolder, OfFilesWithOneNameTheFirstIsReadWithAWarning) {
  const TemporaryFolder folder;
  write_text(folder / "a.obj", tetrahedron_obj);
  write_text(folder / "a.glb", triangle_glb());
  const auto [meshes, warnings] = read_mesh_folder(folder / ".");
  ASSERT_EQ(meshes.size(), 1U);
  EXPECT_EQ(meshes[0].mesh.triangles.rows(), 1);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("have one name: only one is used"), std::string::npos);
}

TEST(Mesh, DeeplyNestedJsonIsRead) {
  std::string gltf = strip_gltf(R"({"mesh":0})");
  const std::size_t depth = 300'000;
  gltf.back() = ',';
  gltf += "\"extras\":" + std::string(depth, '[') + std::string(depth, ']') + "}";
  EXPECT_EQ(parse_mesh(gltf, "gltf", "x").triangles.rows(), 2);
}

TEST(MeshFolder, WithoutAnyMeshIsRefused) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_mesh_folder(folder / "nowhere"), InputError);
  EXPECT_THROW(read_mesh_folder(folder / "."), InputError);
  write_text(folder / "corrupt.ply", "ply");
  EXPECT_THROW(read_mesh_folder(folder / "."), InputError);
  EXPECT_THROW(read_mesh_folder(folder / "corrupt.ply"), InputError);
}

TEST(Mesh, OtherFilesAreRefused) {
  const TemporaryFolder folder;
  EXPECT_EQ(refusal([] { parse_mesh("", "blend", "a.blend"); }),
            "a.blend: expected a mesh in PLY, OBJ, STL, GLB or glTF format, found .blend");
  EXPECT_EQ(refusal([&] { read_mesh("/nowhere/a.obj"); }),
            "/nowhere/a.obj: expected a file, found nothing of that name");
  for (const char* extension : {"ply", "obj", "stl", "glb", "gltf"}) {
    for (const char* garbage : {"", "garbage", "v 0 0 0\n", "solid\n", "{}", "glTF\2\0\0\0"}) {
      EXPECT_THROW(parse_mesh(garbage, extension, "x"), InputError) << extension << garbage;
    }
  }
}

TEST(Mesh, DamagedFilesAreReadOrRefused) {
  damage(tetrahedron_obj, [](std::string_view b) { parse_mesh(b, "obj", "x"); });
  damage(tetrahedron_stl(), [](std::string_view b) { parse_mesh(b, "stl", "x"); });
  damage(triangle_glb(), [](std::string_view b) { parse_mesh(b, "glb", "x"); });
}

}  // namespace
}  // namespace symscene
