#include "picking/failed_places.hpp"

#include <gtest/gtest.h>

namespace symscene {
namespace {

TEST(FailedPlaces, CountsAttemptsWithinTheRadiusOnly) {
  FailedPlaces places(0.02);
  places.add({0.0, 0.0, 0.1});
  places.add({0.01, 0.0, 0.1});
  places.add({0.5, 0.0, 0.1});
  EXPECT_EQ(places.failures_at({0.005, 0.0, 0.1}), 2);
  EXPECT_EQ(places.failures_at({0.5, 0.01, 0.1}), 1);
  EXPECT_EQ(places.failures_at({0.0, 0.0, 0.2}), 0);
}

}  // namespace
}  // namespace symscene
