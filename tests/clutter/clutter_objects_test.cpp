#include "symscene/clutter/clutter_objects.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;

constexpr const char* two_tetrahedra =
    "o first\nv 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
    "o second\nv 1 0 0\nv 1.1 0 0\nv 1 0.1 0\nv 1 0 0.1\nv 1 0 0.2\nf 5 7 6\nf 5 6 8\n";

std::string urdf(const std::string& name, const std::string& mass) {
  return "<robot name=\"" + name + "\"><link><inertial>\n<mass value=\"" + mass +
         "\"/></inertial>\n<visual><geometry><mesh filename=\"" + name +
         "_visual.obj\"/></geometry></visual>\n<collision>\n<geometry><mesh filename=\"" + name +
         "_collision.obj\"/></geometry></collision></link></robot>\n";
}

class ClutterObjectsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(dir_);
    fs::create_directories(dir_);
  }
  void TearDown() override { fs::remove_all(dir_); }

  void write(const std::string& file, const std::string& text) const {
    std::ofstream(dir_ / file) << text;
  }
  void write_object(const std::string& name, const std::string& mass = "0.25") const {
    write(name + ".urdf", urdf(name, mass));
    write(name + "_visual.obj", two_tetrahedra);
    write(name + "_collision.obj", two_tetrahedra);
  }

  const fs::path dir_ = fs::path(::testing::TempDir()) /
                        ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(ClutterObjectsTest, ReadsMassSurfaceAndOneConvexPartPerGroupSortedByName) {
  write_object("b");
  write_object("a", "1.5");
  const std::vector<ClutterObject> objects = read_clutter_objects(dir_);
  ASSERT_EQ(objects.size(), 2);
  EXPECT_EQ(objects[0].name, "a");
  EXPECT_EQ(objects[0].mass, 1.5);
  EXPECT_EQ(objects[1].mass, 0.25);
  EXPECT_EQ(objects[0].surface.triangles.rows(), 6);
  ASSERT_EQ(objects[0].parts.size(), 2);
  EXPECT_EQ(objects[0].parts[0].rows(), 4);
  EXPECT_EQ(objects[0].parts[1].rows(), 5);
  EXPECT_FLOAT_EQ(objects[0].parts[1](1, 0), 1.1F);
}

TEST_F(ClutterObjectsTest, TheSharesDivideTheObjects) {
  int held_out = 0;
  for (char name = 'a'; name <= 'z'; ++name) {
    write_object(std::string(1, name));
    held_out += is_held_out(std::string(1, name)) ? 1 : 0;
  }
  const auto fitting = read_clutter_objects(dir_, ObjectShare::fitting);
  const auto rest = read_clutter_objects(dir_, ObjectShare::held_out);
  EXPECT_EQ(fitting.size() + rest.size(), 26);
  EXPECT_EQ(rest.size(), held_out);
  for (const ClutterObject& object : fitting) EXPECT_FALSE(is_held_out(object.name));
}

TEST_F(ClutterObjectsTest, TheHashIsFnv1a) {
  // The published hash of "a" is af63dc4c8601ec8c.
  EXPECT_FALSE(is_held_out("a"));
  // Of "b": af63df4c8601f1a5.
  EXPECT_TRUE(is_held_out("b"));
}

TEST_F(ClutterObjectsTest, RefusesFoldersAndFilesThatHoldNoObject) {
  EXPECT_THROW(read_clutter_objects(dir_ / "absent"), InputError);
  EXPECT_THROW(read_clutter_objects(dir_), InputError);
  write_object("a", "0");
  EXPECT_THROW(read_clutter_objects(dir_), InputError);
  write_object("a", "much");
  EXPECT_THROW(read_clutter_objects(dir_), InputError);
  write_object("a");
  write("a_collision.obj", "v 0 0 0\n");
  EXPECT_THROW(read_clutter_objects(dir_), InputError);
  write_object("a");
  write("a.urdf", "<robot/>");
  EXPECT_THROW(read_clutter_objects(dir_), InputError);
  write("a.urdf", "<origin xyz=\"1 0 0\"/>" + urdf("a", "1"));
  EXPECT_THROW(read_clutter_objects(dir_), InputError);
  write_object("a");
  fs::remove(dir_ / "a_visual.obj");
  EXPECT_THROW(read_clutter_objects(dir_), InputError);
}

}  // namespace
}  // namespace symscene
