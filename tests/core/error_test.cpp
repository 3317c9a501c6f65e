#include "symscene/core/error.hpp"

#include <gtest/gtest.h>

namespace symscene {
namespace {

TEST(InputError, IsOneSentenceThatNamesPlaceExpectedAndFound) {
  const InputError error("cloud.ply", "a PLY header", "an empty file");
  EXPECT_STREQ(error.what(), "cloud.ply: expected a PLY header, found an empty file");
  EXPECT_EQ(error.where(), "cloud.ply");
  EXPECT_EQ(error.expected(), "a PLY header");
  EXPECT_EQ(error.found(), "an empty file");
}

TEST(RequireOption, ThrowsOnlyWhereTheConditionFails) {
  EXPECT_NO_THROW(require_option(true, "voxel_size", "a positive length in metres", 0.005));
  EXPECT_THROW(require_option(false, "voxel_size", "a positive length in metres", 0.0), InputError);
}

}  // namespace
}  // namespace symscene
