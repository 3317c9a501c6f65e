#pragma once

/// Every options struct lists its fields once, for configuration files, `--dump-config` and
/// bindings:
///
///   struct SamplingOptions {
///     double voxel_size = 0.005;  ///< [m]
///
///     template <class Self, class Visit>
///     static void visit_fields(Self& self, Visit&& visit) {
///       visit("voxel_size", self.voxel_size, "m", "edge of the voxels that thin the cloud");
///     }
///     void validate() const;  // throws InputError
///   };
///
/// A visitor is called as visit(name, value, unit, help) for a field, value being double, int, bool
/// or std::uint64_t, and as visit(name, group) for a nested options struct. `Self` is const or not,
/// as the caller needs.
namespace symscene {

/// Calls `visit` for every field of `options`.
template <class Options, class Visit>
void visit_options(Options& options, Visit&& visit) {
  Options::visit_fields(options, visit);
}

}  // namespace symscene
