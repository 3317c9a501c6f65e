#pragma once

#include "symscene/evaluation/missed_objects.hpp"

namespace symscene {

/// Adds to a missed object what was chosen in its place: which of the result's objects have a tenth
/// of its points or more, and a picture from obliquely above: its points in none of them are red,
/// those in them green, yellow and violet in turn, their other points blue and all else grey.
void show_failure(const PointIndices& mask, const SegmentationResult& result,
                  ObjectOutcome& outcome);

}  // namespace symscene
