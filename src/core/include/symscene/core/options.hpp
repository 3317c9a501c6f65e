#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

/// Every options struct declares each of its fields once, with name, unit, valid range and help.
/// `--dump-config`, configuration files, docs/options.md, validation and bindings read it there:
///
///   struct SamplingOptions {
///     double voxel_size = 0.005;
///
///     template <class Self, class Visit>
///     static void visit_fields(Self& self, Visit&& visit) {
///       visit("voxel_size", self.voxel_size, "m", above(0.0), "edge of the voxels (section 2.1)");
///     }
///     void validate() const { check_fields(*this); }
///   };
///
/// A visitor is called as visit(name, value, unit, range, help) for a field, value being double,
/// int, bool, std::uint64_t or std::string (a path, whose range is any_value()), and as
/// visit(name, group) for a nested options struct. `Self` is const or not, as the caller needs.
/// `help` ends with its source where there is one: a section or equation of the thesis, or a paper.
namespace symscene {

/// The values that an option may have: an interval, open at an end that is excluded.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool excludes_low = false;
  bool excludes_high = false;

  /// NaN is in no range.
  constexpr bool contains(double value) const {
    return (excludes_low ? value > low : value >= low) &&
           (excludes_high ? value < high : value <= high);
  }
};

/// Any finite value.
constexpr Range any_value() {
  constexpr double most = std::numeric_limits<double>::max();
  return {-most, most};
}
constexpr Range at_least(double low) { return {low, std::numeric_limits<double>::max()}; }
constexpr Range above(double low) { return {low, std::numeric_limits<double>::max(), true}; }
constexpr Range between(double low, double high) { return {low, high}; }
/// low < value <= high.
constexpr Range above_up_to(double low, double high) { return {low, high, true}; }
/// low < value < high.
constexpr Range strictly_between(double low, double high) { return {low, high, true, true}; }

/// "in [0, 1]", "of at least 0", "above 0"; empty for any value.
std::string to_string(const Range& range);

/// Throws InputError naming `option` unless the value lies in the range, and in that of its unit.
void require_in_range(const char* option, double value, const char* unit, const Range& range);

/// Calls `visit` for every field of `options`.
template <class Options, class Visit>
void visit_options(Options& options, Visit&& visit) {
  Options::visit_fields(options, visit);
}

/// The visitor of check_fields().
struct FieldCheck {
  template <class Value>
  void operator()(const char* name, const Value& value, const char* unit, const Range& range,
                  const char* /*help*/) const {
    if constexpr (!std::is_same_v<Value, std::string>)
      require_in_range(name, static_cast<double>(value), unit, range);
  }
  template <class Group>
  void operator()(const char* /*name*/, const Group& group) const {
    group.validate();
  }
};

/// Throws InputError for the first field that is out of its range, in nested groups too (their
/// validate()). A validate() calls it first, then checks what fields must satisfy together.
template <class Options>
void check_fields(const Options& options) {
  visit_options(options, FieldCheck{});
}

}  // namespace symscene
