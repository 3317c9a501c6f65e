#include "symscene/io/table_plane.hpp"

#include "io/io_support.hpp"

namespace symscene {
namespace {

using namespace io_test;

TEST(TablePlane, OneLineAndFourLinesGiveTheSamePlane) {
  const Plane a = parse_table_plane("0 0 2 -1", "x");
  const Plane b = parse_table_plane("0\n0\r\n2\n-1\n\n", "x");
  EXPECT_EQ(a.normal, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(a.offset, -0.5);
  EXPECT_EQ(a.normal, b.normal);
  EXPECT_EQ(a.offset, b.offset);
}

TEST(TablePlane, ScalingTheNumbersDoesNotMoveThePlane) {
  const Plane a = parse_table_plane("0.3 -0.4 1.2 0.7", "x");
  for (const char* scaled :
       {"3 -4 12 7", "3e150 -4e150 12e150 7e150", "3e-150 -4e-150 12e-150 7e-150"}) {
    const Plane b = parse_table_plane(scaled, "x");
    EXPECT_LT((a.normal - b.normal).norm(), 1e-12) << scaled;
    EXPECT_NEAR(a.offset, b.offset, 1e-12) << scaled;
  }
}

TEST(TablePlane, WritingAndReadingGiveTheSameBits) {
  std::mt19937 random(1);
  std::normal_distribution<double> number;
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d normal(number(random), number(random), number(random));
    const Plane plane{normal.normalized(), number(random)};
    const Plane again = parse_table_plane(format_table_plane(plane), "x");
    EXPECT_EQ(again.normal, plane.normal);
    EXPECT_EQ(again.offset, plane.offset);
  }
}

TEST(TablePlane, AnythingButFourFiniteNumbersWithANormalIsRefused) {
  for (const char* text : {"", "1 2 3", "1 2 3 4 5", "0 0 0 1", "nan 0 1 0", "0 0 1 inf", "a b c d",
                           "0 0 1 2x", "1,2,3,4"}) {
    EXPECT_THROW(parse_table_plane(text, "x"), InputError) << text;
  }
  EXPECT_EQ(refusal([] { parse_table_plane("1 2 3", "table_plane.txt"); }),
            "table_plane.txt: expected four numbers a b c d, the plane ax + by + cz + d = 0, found "
            "only 3");
  EXPECT_EQ(refusal([] { parse_table_plane("0 0 0 1", "table_plane.txt"); }),
            "table_plane.txt: expected a direction, found a vector without length");
}

TEST(TablePlane, DamagedFilesAreReadOrRefused) {
  damage("0.0106272\n-0.797762\n-0.602879\n0.645567\n",
         [](std::string_view bytes) { parse_table_plane(bytes, "x"); });
}

}  // namespace
}  // namespace symscene
