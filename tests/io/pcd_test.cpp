#include "io/pcd.hpp"

#include <fmt/format.h>

#include "io/io_support.hpp"
#include "io/ply.hpp"
#include "symscene/io/cloud.hpp"

namespace symscene {
namespace {

using namespace io_test;

template <class T>
void append(std::string& text, T value) {
  text.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

/// Compresses with LZF: references to the last 8 KiB where possible, else literals.
std::string compress_lzf(const std::string& data) {
  std::string out;
  std::string literals;
  const auto flush = [&] {
    for (std::size_t begin = 0; begin < literals.size(); begin += 32) {
      const std::string run = literals.substr(begin, 32);
      out += static_cast<char>(run.size() - 1);
      out += run;
    }
    literals.clear();
  };
  for (std::size_t i = 0; i < data.size();) {
    std::size_t best = 0;
    std::size_t best_distance = 0;
    for (std::size_t distance = 1; distance <= std::min<std::size_t>(i, 400); ++distance) {
      std::size_t length = 0;
      while (length < 264 && i + length < data.size() &&
             data[i + length] == data[i + length - distance]) {
        ++length;
      }
      if (length > best) best = length, best_distance = distance;
    }
    if (best < 3) {
      literals += data[i++];
      continue;
    }
    flush();
    const std::size_t length = best - 2;
    const std::size_t offset = best_distance - 1;
    out += static_cast<char>((std::min<std::size_t>(length, 7) << 5) | (offset >> 8));
    if (length >= 7) out += static_cast<char>(length - 7);
    out += static_cast<char>(offset & 255);
    i += best;
  }
  flush();
  return out;
}

std::string pcd_header(Eigen::Index points, const std::string& encoding, const char* color = "rgb",
                       char color_type = 'F') {
  return fmt::format(
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n"
      "FIELDS x y z {0} histogram normal_x normal_y normal_z\nSIZE 4 4 4 4 2 4 4 4\n"
      "TYPE F F F {1} U F F F\nCOUNT 1 1 1 1 3 1 1 1\nWIDTH {2}\nHEIGHT 1\n"
      "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS {2}\nDATA {3}\n",
      color, color_type, points, encoding);
}

std::uint32_t packed(const PointCloud& cloud, Eigen::Index i) {
  const auto c = cloud.colors.row(i).cast<std::uint32_t>();
  return (255U << 24) | (c[0] << 16) | (c[1] << 8) | c[2];
}

/// The fields of point i from field `begin` on, in the order of pcd_header().
void append_field(std::string& out, const PointCloud& cloud, Eigen::Index i, int field) {
  if (field < 3) append(out, cloud.positions(i, field));
  if (field == 3) append(out, packed(cloud, i));
  for (int k = 0; field == 4 && k < 3; ++k) append(out, static_cast<std::uint16_t>(k));
  if (field > 4) append(out, cloud.normals(i, field - 5));
}

std::string binary(const PointCloud& cloud) {
  std::string out = pcd_header(cloud.positions.rows(), "binary");
  for (Eigen::Index i = 0; i < cloud.positions.rows(); ++i) {
    for (int field = 0; field < 8; ++field) append_field(out, cloud, i, field);
  }
  return out;
}

std::string compressed(const PointCloud& cloud) {
  std::string data;
  for (int field = 0; field < 8; ++field) {
    for (Eigen::Index i = 0; i < cloud.positions.rows(); ++i) append_field(data, cloud, i, field);
  }
  const std::string stream = compress_lzf(data);
  std::string out = pcd_header(cloud.positions.rows(), "binary_compressed", "rgba", 'U');
  append(out, static_cast<std::uint32_t>(stream.size()));
  append(out, static_cast<std::uint32_t>(data.size()));
  return out + stream;
}

std::string ascii(const PointCloud& cloud, bool float_color) {
  std::string out = pcd_header(cloud.positions.rows(), "ascii", "rgb", float_color ? 'F' : 'U');
  for (Eigen::Index i = 0; i < cloud.positions.rows(); ++i) {
    const std::uint32_t color = packed(cloud, i) & 0xFFFFFFU;
    out += fmt::format("{} {} {} ", cloud.positions(i, 0), cloud.positions(i, 1),
                       cloud.positions(i, 2));
    out +=
        float_color ? fmt::format("{} ", std::bit_cast<float>(color)) : fmt::format("{} ", color);
    out += fmt::format("0 1 2 {} {} {}\n", cloud.normals(i, 0), cloud.normals(i, 1),
                       cloud.normals(i, 2));
  }
  return out;
}

TEST(Pcd, TheThreeEncodingsGiveTheSameCloud) {
  PointCloud cloud = random_cloud(500, 1);
  cloud.positions.col(2).setConstant(0.25F);  // something to compress
  expect_same(parse_pcd(binary(cloud), "x"), cloud);
  expect_same(parse_pcd(compressed(cloud), "x"), cloud);
  expect_same(parse_pcd(ascii(cloud, true), "x"), cloud);
  expect_same(parse_pcd(ascii(cloud, false), "x"), cloud);
}

TEST(Pcd, WritingAndReadingGiveTheSameBits) {
  for (const bool normals : {false, true}) {
    for (const bool colors : {false, true}) {
      for (const Eigen::Index size : {0, 1, 1000}) {
        const PointCloud cloud = random_cloud(size, 2, normals, colors);
        expect_same(parse_pcd(format_pcd(cloud), "x"), cloud);
      }
    }
  }
}

TEST(Pcd, OlderHeadersAreRead) {
  const std::string old =
      "# a comment\nVERSION .6\nCOLUMNS x y z\nSIZE 8 4 2\nTYPE F F I\nWIDTH 2\nHEIGHT 1\n"
      "DATA ascii\n1.5 2 -3\nnan inf 4\n";
  const PointCloud cloud = parse_pcd(old, "x");
  ASSERT_EQ(cloud.size(), 2U);
  EXPECT_EQ(cloud.position(0), Eigen::Vector3f(1.5F, 2.0F, -3.0F));
  EXPECT_TRUE(std::isnan(cloud.positions(1, 0)));
}

TEST(Pcd, DamagedFilesAreReadOrRefused) {
  const PointCloud cloud = random_cloud(12, 3);
  const auto parse = [](std::string_view bytes) { parse_pcd(bytes, "x"); };
  EXPECT_EQ(damage(binary(cloud), parse), 0);
  EXPECT_EQ(damage(compressed(cloud), parse), 0);
  damage(ascii(cloud, true), parse);
}

TEST(Pcd, LzfReferencesBeforeTheBeginningAreRefused) {
  std::string file =
      "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 1\nPOINTS 1\n"
      "DATA binary_compressed\n";
  append(file, std::uint32_t{4});
  append(file, std::uint32_t{12});
  EXPECT_EQ(refusal([&] { parse_pcd(file + std::string("\0a\xE0\x05", 4), "a.pcd"); }),
            "a.pcd: expected LZF data that stand for 12 bytes, found other data");
}

TEST(Pcd, SizesBeyondTheFileAreRefusedBeforeMemoryIsTaken) {
  const auto file = [](const std::string& points, const std::string& encoding) {
    return "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS " + points + "\nDATA " +
           encoding + "\n";
  };
  EXPECT_EQ(refusal([&] { parse_pcd(file("4000000000", "binary"), "a.pcd"); }),
            "a.pcd: expected 4000000000 points, found only 0 bytes");
  std::string bomb = file("300000000", "binary_compressed");
  append(bomb, std::uint32_t{4});
  append(bomb, std::uint32_t{3600000000U});
  EXPECT_THROW(parse_pcd(bomb + "abcd", "x"), InputError);
  EXPECT_THROW(parse_pcd(file("99999999999", "ascii"), "x"), InputError);
}

TEST(Pcd, RefusalsNameFileExpectedAndFound) {
  EXPECT_EQ(refusal([] {
              parse_pcd(
                  "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F Q\nPOINTS 0\n"
                  "DATA ascii\n",
                  "a.pcd");
            }),
            "a.pcd: expected TYPE I or U of SIZE 1, 2, 4, 8 or F of 4, 8, found \"Q\" of \"4\"");
  EXPECT_EQ(refusal([] {
              parse_pcd("VERSION 0.7\nFIELDS x y\nSIZE 4 4\nTYPE F F\nPOINTS 0\nDATA ascii\n",
                        "a.pcd");
            }),
            "a.pcd: expected fields x, y and z, found other fields");
}

TEST(Pcd, HeadersThatContradictThemselvesAreRefused) {
  const auto refused = [](const std::string& lines, const std::string& body = "0 0 0\n1 0 0\n") {
    return refusal([&] {
      parse_pcd("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n" + lines + "DATA ascii\n" + body, "a.pcd");
    });
  };
  EXPECT_EQ(refused("VERSION .7\nWIDTH 2\nHEIGHT 1\nPOINTS 2\n"), "nothing was refused");
  EXPECT_EQ(refused("VERSION 99\nPOINTS 2\n"),
            "a.pcd: expected a PCD file of version 0.5, 0.6 or 0.7, found \"99\"");
  EXPECT_EQ(refused("WIDTH 3\nHEIGHT 1\nPOINTS 2\n"),
            "a.pcd: expected as many POINTS as WIDTH times HEIGHT, found 2");
  EXPECT_EQ(refused("POINTS 2\nPOINTS 1\n"),
            "a.pcd: expected each line of a PCD header once, found \"POINTS\" twice");
  EXPECT_EQ(refused("POINTS 1\n"), "a.pcd: expected the values of 1 points, found more");
  PointCloud cloud;
  cloud.positions = Points::Zero(2, 3);
  EXPECT_EQ(refusal([&] { parse_pcd(format_pcd(cloud) + "abc", "a.pcd"); }),
            "a.pcd: expected the end of the file, found 3 bytes more");
}

TEST(Cloud, TheFormatIsRecognisedByTheFirstBytesWhateverTheExtension) {
  const TemporaryFolder folder;
  const PointCloud cloud = random_cloud(20, 4);
  write_text(folder / "a.xyz", format_ply(cloud));
  write_text(folder / "b", format_pcd(cloud));
  expect_same(read_cloud(folder / "a.xyz"), cloud);
  expect_same(read_cloud(folder / "b"), cloud);
  write_text(folder / "c.ply", "hello\n");
  EXPECT_EQ(refusal([&] { read_cloud(folder / "c.ply"); }),
            (folder / "c.ply").string() +
                ": expected a point cloud in PLY or PCD format, found \"hello\"");
}

TEST(Cloud, KnowsWhereItsSensorWas) {
  const TemporaryFolder folder;
  const std::string header =
      "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\n";
  const std::string body = "POINTS 1\nDATA ascii\n1 2 3\n";
  write_text(folder / "a.pcd", header + "VIEWPOINT 0.5 -1 2 1 0 0 0\n" + body);
  EXPECT_EQ(read_sensor_cloud(folder / "a.pcd").viewpoint, Eigen::Vector3d(0.5, -1.0, 2.0));
  write_text(folder / "b.pcd", header + body);
  EXPECT_EQ(read_sensor_cloud(folder / "b.pcd").viewpoint, Eigen::Vector3d::Zero());
  write_text(folder / "c.pcd", header + "VIEWPOINT 0 inf 0 1 0 0 0\n" + body);
  EXPECT_THROW(read_sensor_cloud(folder / "c.pcd"), InputError);
}

TEST(Cloud, IsWrittenInTheFormatOfItsExtension) {
  const TemporaryFolder folder;
  const PointCloud cloud = random_cloud(20, 4);
  for (const char* file : {"a.ply", "a.pcd"}) {
    write_cloud(folder / file, cloud);
    expect_same(read_cloud(folder / file), cloud);
  }
  EXPECT_EQ(read_text(folder / "a.ply"), format_ply(cloud));
  EXPECT_EQ(read_text(folder / "a.pcd"), format_pcd(cloud));
  EXPECT_EQ(
      refusal([&] { write_cloud(folder / "a.xyz", cloud); }),
      (folder / "a.xyz").string() + ": expected a name that ends in .ply or .pcd, found .xyz");
}

}  // namespace
}  // namespace symscene
