#include <gtest/gtest.h>

#include <limits>
#include <type_traits>

#include "symscene/core/error.hpp"
#include "symscene/reconstruction/reconstruction.hpp"

namespace symscene {
namespace {

/// Sets one field, by its number, to an invalid value.
struct Spoiler {
  int target;
  double bad;
  int seen = 0;
  std::string name;

  template <class Value>
  void operator()(const char* field, Value& value, const char*, const Range&, const char*) {
    if constexpr (!std::is_same_v<Value, bool>) {
      if (seen++ != target) return;
      name = field;
      if constexpr (std::is_same_v<Value, double>) {
        value = bad;
      } else {
        value = static_cast<Value>(std::numeric_limits<int>::min());
      }
    }
  }
  template <class Nested>
  void operator()(const char*, Nested& nested) {
    visit_options(nested, *this);
  }
};

template <class Options>
int expect_every_field_is_checked() {
  int fields = 0;
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity(), 1e300, -1e9}) {
    for (fields = 0;; ++fields) {
      Options options;
      Spoiler spoiler{fields, bad, 0, {}};
      visit_options(options, spoiler);
      if (spoiler.name.empty()) break;
      EXPECT_THROW(options.validate(), InputError) << spoiler.name << " = " << bad;
    }
  }
  return fields;
}

TEST(ReconstructionOptions, OutOfRangeAreRefusedFieldByField) {
  EXPECT_EQ(expect_every_field_is_checked<MeasurementOptions>(), 15);
  EXPECT_EQ(expect_every_field_is_checked<TsdfOptions>(), 13);
  EXPECT_EQ(expect_every_field_is_checked<TrackingOptions>(), 33);
  EXPECT_EQ(expect_every_field_is_checked<SurfaceExtractionOptions>(), 3);
}

TEST(ReconstructionOptions, ByDefaultAreInRange) {
  EXPECT_NO_THROW(ReconstructionOptions().validate());
}

TEST(ReconstructionOptions, MustBeConsistent) {
  const auto refused = [](auto&& change) {
    ReconstructionOptions options;
    change(options);
    EXPECT_THROW(options.validate(), InputError);
    EXPECT_THROW(Reconstruction({160, 120, 140, 140, 80, 60}, options), InputError);
  };
  refused([](auto& o) { o.measurement.min_depth = 6.2; });
  refused([](auto& o) { o.tsdf.truncation = 0.004; });
  refused([](auto& o) { o.tsdf.voxel_size = 0.01; });
  refused([](auto& o) { o.tsdf.max_truncation = 0.01; });
  refused([](auto& o) { o.tracking.min_overlap = 1.1; });
  refused([](auto& o) { o.tracking.iterations_fine = 0; });
  refused([](auto& o) { o.surface.min_triangles = 0; });
  refused([](auto& o) { o.occupancy.resolution = 0.0; });
}

}  // namespace
}  // namespace symscene
