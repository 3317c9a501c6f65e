#include "io/ply.hpp"
#include "symscene/io/cloud.hpp"

#include <fmt/format.h>

#include <limits>

#include "io/atomic_file.hpp"
#include "io/io_support.hpp"

namespace symscene {
namespace {

using namespace io_test;

/// Writes the body of a PLY file in any of the three encodings.
class PlyText {
 public:
  explicit PlyText(std::string encoding, const std::string& header)
      : encoding_(std::move(encoding)),
        text_("ply\nformat " + encoding_ + " 1.0\ncomment made by hand\n" + header +
              "end_header\n") {}

  template <class T>
  PlyText& add(T value) {
    if (encoding_ == "ascii") {
      text_ += fmt::format("{} ", +value);
      return *this;
    }
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    const bool big = encoding_ == "binary_big_endian";
    if (big != (std::endian::native == std::endian::big)) std::reverse(bytes, bytes + sizeof(T));
    text_.append(bytes, sizeof(T));
    return *this;
  }

  const std::string& text() const { return text_; }

 private:
  std::string encoding_;
  std::string text_;
};

class PlyEncodings : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, PlyEncodings,
                         ::testing::Values("ascii", "binary_little_endian", "binary_big_endian"),
                         [](const auto& suite) { return std::string(suite.param); });

TEST(Ply, WritingAndReadingGiveTheSameBits) {
  for (const bool normals : {false, true}) {
    for (const bool colors : {false, true}) {
      for (const Eigen::Index size : {0, 1, 1000}) {
        const PointCloud cloud = random_cloud(size, 1, normals, colors);
        expect_same(parse_ply_cloud(format_ply(cloud), "x"), cloud);
      }
    }
  }
}

TEST(Ply, NonFiniteValuesAreKept) {
  PointCloud cloud = random_cloud(3, 2);
  cloud.positions(1, 2) = std::numeric_limits<float>::quiet_NaN();
  cloud.positions(2, 0) = std::numeric_limits<float>::infinity();
  expect_same(parse_ply_cloud(format_ply(cloud), "x"), cloud);
}

TEST(Ply, WritingAndReadingAMeshGiveTheSameBits) {
  TriangleMesh mesh;
  mesh.vertices = random_cloud(50, 3).positions;
  mesh.colors = random_cloud(50, 3).colors;
  mesh.normals = random_cloud(50, 3).normals;
  mesh.triangles.resize(40, 3);
  for (Index t = 0; t < 40; ++t) mesh.triangles.row(t) << t, t + 1, (7 * t) % 50;
  const TriangleMesh again = parse_ply_mesh(format_ply(mesh), "x");
  EXPECT_TRUE(same_bits(again.vertices, mesh.vertices));
  EXPECT_TRUE(same_bits(again.triangles, mesh.triangles));
  EXPECT_TRUE(same_bits(again.colors, mesh.colors));
  EXPECT_TRUE(same_bits(again.normals, mesh.normals));
}

TEST_P(PlyEncodings, EveryScalarTypeUnderBothNamesIsRead) {
  PlyText ply(GetParam(),
              "element vertex 2\n"
              "property double x\nproperty float64 y\nproperty float z\nproperty float32 a\n"
              "property char b\nproperty int8 c\nproperty uchar red\nproperty uint8 green\n"
              "property uchar blue\nproperty short d\nproperty int16 e\nproperty ushort f\n"
              "property uint16 g\nproperty int h\nproperty int32 i\nproperty uint j\n"
              "property uint32 k\n");
  for (int row = 0; row < 2; ++row) {
    ply.add(1.5 + row).add(-2.25).add(3.75F).add(0.0F);
    ply.add(std::int8_t{-1}).add(std::int8_t{1}).add(std::uint8_t{200}).add(std::uint8_t{100});
    ply.add(std::uint8_t{50}).add(std::int16_t{-300}).add(std::int16_t{300});
    ply.add(std::uint16_t{60000}).add(std::uint16_t{1}).add(-70000).add(70000);
    ply.add(4000000000U).add(1U);
  }
  const PointCloud cloud = parse_ply_cloud(ply.text(), "x");
  ASSERT_EQ(cloud.size(), 2U);
  EXPECT_EQ(cloud.position(0), Eigen::Vector3f(1.5F, -2.25F, 3.75F));
  EXPECT_EQ(cloud.position(1), Eigen::Vector3f(2.5F, -2.25F, 3.75F));
  EXPECT_EQ(cloud.colors.row(1).cast<int>(), Eigen::RowVector3i(200, 100, 50));
}

TEST_P(PlyEncodings, UnknownElementsAndListsAreSkipped) {
  PlyText ply(GetParam(),
              "element junk 2\nproperty list uchar int values\nproperty float w\n"
              "element nothing 1000000000000\n"
              "element vertex 2\nproperty list uint8 double extra\n"
              "property float x\nproperty float y\nproperty float z\nproperty float curvature\n"
              "property float nx\nproperty float ny\nproperty float nz\n"
              "element camera 1\nproperty float view_px\nproperty int viewportx\n");
  ply.add(std::uint8_t{2}).add(5).add(6).add(1.0F).add(std::uint8_t{0}).add(2.0F);
  ply.add(std::uint8_t{1}).add(9.0).add(1.0F).add(2.0F).add(3.0F).add(0.5F);
  ply.add(0.0F).add(0.0F).add(1.0F);
  ply.add(std::uint8_t{0}).add(4.0F).add(5.0F).add(6.0F).add(0.5F);
  ply.add(0.0F).add(1.0F).add(0.0F);
  ply.add(7.0F).add(8);
  const PointCloud cloud = parse_ply_cloud(ply.text(), "x");
  ASSERT_EQ(cloud.size(), 2U);
  EXPECT_EQ(cloud.position(1), Eigen::Vector3f(4.0F, 5.0F, 6.0F));
  EXPECT_EQ(cloud.normal(1), Eigen::Vector3f(0.0F, 1.0F, 0.0F));
  EXPECT_FALSE(cloud.has_colors());
}

TEST_P(PlyEncodings, PolygonsBecomeFansAndLinesAreDropped) {
  PlyText ply(GetParam(),
              "element vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
              "element face 3\nproperty uchar flag\nproperty list uchar int vertex_index\n");
  for (int i = 0; i < 15; ++i) ply.add(static_cast<float>(i));
  ply.add(std::uint8_t{0}).add(std::uint8_t{5}).add(0).add(1).add(2).add(3).add(4);
  ply.add(std::uint8_t{0}).add(std::uint8_t{2}).add(0).add(1);
  ply.add(std::uint8_t{0}).add(std::uint8_t{3}).add(4).add(2).add(0);
  const TriangleMesh mesh = parse_ply_mesh(ply.text(), "x");
  decltype(mesh.triangles) expected(4, 3);
  expected << 0, 1, 2, 0, 2, 3, 0, 3, 4, 4, 2, 0;
  EXPECT_EQ(mesh.triangles, expected);
}

TEST_P(PlyEncodings, DamagedFilesAreReadOrRefused) {
  PlyText ply(GetParam(),
              "element vertex 4\nproperty double x\nproperty float y\nproperty float z\n"
              "property uchar red\nproperty uchar green\nproperty uchar blue\n"
              "element face 2\nproperty list uchar int vertex_indices\n");
  for (int i = 0; i < 4; ++i) {
    ply.add(0.5 * i).add(1.0F).add(2.0F).add(std::uint8_t{9}).add(std::uint8_t{8});
    ply.add(std::uint8_t{7});
  }
  ply.add(std::uint8_t{4}).add(0).add(1).add(2).add(3).add(std::uint8_t{3}).add(1).add(2).add(3);
  const bool text = std::string(GetParam()) == "ascii";
  const int accepted = damage(ply.text(), [](std::string_view b) { parse_ply_mesh(b, "x"); });
  // Only the space at the end of a text file can be missed.
  EXPECT_EQ(accepted, text ? 1 : 0);
  damage(ply.text(), [](std::string_view b) { parse_ply_cloud(b, "x"); });
}

TEST(Ply, ColorsAsFloatsRunFromZeroToOne) {
  const std::string ply =
      "ply\r\nformat ascii 1.0\r\nelement vertex 2\r\nproperty float x\r\nproperty float y\r\n"
      "property float z\r\nproperty float red\r\nproperty float green\r\nproperty float blue\r\n"
      "end_header\r\n0 0 0 0 0.5 1\r\n0 0 0 nan -1 2\r\n";
  const PointCloud cloud = parse_ply_cloud(ply, "x");
  EXPECT_EQ(cloud.colors.row(0).cast<int>(), Eigen::RowVector3i(0, 128, 255));
  EXPECT_EQ(cloud.colors.row(1).cast<int>(), Eigen::RowVector3i(0, 0, 255));
}

std::string triangle_of_corner(const std::string& corner) {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
         "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
         "0 0 0 1 0 0 0 1 0\n3 0 1 " +
         corner + "\n";
}

TEST(Ply, AFaceWithAnInvalidVertexIsRefused) {
  EXPECT_EQ(parse_ply_mesh(triangle_of_corner("2"), "x").triangles.rows(), 1);
  for (const char* corner : {"3", "-1", "1.5", "nan", "1e30"}) {
    EXPECT_THROW(parse_ply_mesh(triangle_of_corner(corner), "x"), InputError) << corner;
  }
}

TEST(Ply, SizesBeyondTheFileAreRefusedBeforeMemoryIsTaken) {
  const auto with_count = [](const std::string& count) {
    return "ply\nformat binary_little_endian 1.0\nelement vertex " + count +
           "\nproperty float x\nproperty float y\nproperty float z\nend_header\n0123456789";
  };
  EXPECT_EQ(refusal([&] { parse_ply_cloud(with_count("4000000000"), "a.ply"); }),
            "a.ply: expected 4000000000 rows of element vertex, found only 10 bytes");
  EXPECT_THROW(parse_ply_cloud(with_count("18446744073709551615"), "x"), InputError);
  EXPECT_THROW(parse_ply_cloud(with_count("99999999999999999999999"), "x"), InputError);
  EXPECT_THROW(parse_ply_cloud(with_count("-1"), "x"), InputError);
}

TEST(Ply, BytesBehindTheElementsAreRefusedAndPaddingIsNot) {
  const std::string cloud = format_ply(random_cloud(3, 4));
  EXPECT_EQ(parse_ply_cloud(cloud + "\n\n", "x").size(), parse_ply_cloud(cloud, "x").size());
  EXPECT_EQ(refusal([&] { parse_ply_cloud(cloud + "more", "a.ply"); }),
            "a.ply: expected the end of the file, found 4 bytes more");
  EXPECT_THROW(parse_ply_cloud(triangle_of_corner("2") + "7\n", "x"), InputError);
  EXPECT_THROW(parse_ply_mesh(triangle_of_corner("2") + "7\n", "x"), InputError);
}

TEST(Ply, RefusalsNameFileExpectedAndFound) {
  EXPECT_EQ(
      refusal([] { parse_ply_cloud("solid cube\n", "cube.stl"); }),
      "cube.stl: expected a PLY file, which begins with a line \"ply\", found \"solid cube\"");
  EXPECT_EQ(refusal([] { parse_ply_cloud("ply\nformat ascii 2.0\nend_header\n", "a.ply"); }),
            "a.ply: expected format ascii, binary_little_endian or binary_big_endian 1.0, found "
            "\"format ascii 2.0\"");
  EXPECT_EQ(refusal([] {
              parse_ply_cloud(
                  "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                  "end_header\n1\n",
                  "a.ply");
            }),
            "a.ply: expected vertices with x, y and z, found other properties");
  EXPECT_EQ(refusal([] { read_cloud("/nowhere/a.ply"); }),
            "/nowhere/a.ply: expected a file, found nothing of that name");
}

TEST(Ply, AMeshWithoutFacesIsRefusedAndACloudWithFacesIsNot) {
  const PointCloud cloud = random_cloud(3, 4);
  EXPECT_THROW(parse_ply_mesh(format_ply(cloud), "x"), InputError);
  EXPECT_EQ(parse_ply_cloud(triangle_of_corner("2"), "x").size(), 3U);
}

TEST(Ply, AnInconsistentCloudIsNotWritten) {
  PointCloud cloud = random_cloud(3, 5);
  cloud.normals.conservativeResize(2, 3);
  EXPECT_THROW(format_ply(cloud), InputError);
}

TEST(Ply, AllPointsOfTheSampleSceneHaveNormalsAndColours) {
  const auto data = data_folder();
  if (!data) GTEST_SKIP() << "skipped: no data";
  const PointCloud cloud = read_cloud(*data / "ctd_sample/cloud.ply");
  EXPECT_EQ(cloud.size(), 88365U);
  EXPECT_TRUE(cloud.has_colors());
  EXPECT_LT((cloud.normals.rowwise().norm().array() - 1.0F).abs().maxCoeff(), 1e-3F);
}

}  // namespace
}  // namespace symscene
