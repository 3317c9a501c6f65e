#include "core/nearest_name.hpp"

#include <gtest/gtest.h>

namespace symscene {
namespace {

TEST(NearestName, IsTheMostSimilarOfSimilarOnes) {
  EXPECT_EQ(nearest_name("hme", {"name", "home"}), "home");
  EXPECT_EQ(nearest_name("xyz", {"name", "home"}), "");
  EXPECT_EQ(with_nearest_name("xyz", {"home"}), "\"xyz\"");
  EXPECT_EQ(with_nearest_name("hme", {"home"}), "\"hme\" (did you mean \"home\"?)");
}

}  // namespace
}  // namespace symscene
