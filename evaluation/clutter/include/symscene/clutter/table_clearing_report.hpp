#pragma once

#include <span>
#include <string>

#include "symscene/clutter/round_share.hpp"
#include "symscene/clutter/table_clearing.hpp"

namespace symscene {

/// The figures of cleared tables, with intervals by resampling tables.
struct TableFigures {
  RoundShare graspable;               ///< of the objects: Graspability::at_all
  RoundShare with_grasp;              ///< objects with a grasp at the first look, of all
  RoundShare graspable_with_grasp;    ///< of those that are graspable
  RoundShare as_they_lie_with_grasp;  ///< of those that are graspable as they lie
  RoundShare each_success;            ///< of the best grasp of each object of the first looks, with
                                      ///< try_each_object
  RoundShare first_success;           ///< of the best grasps of the first looks
  RoundShare success;                 ///< of the best grasps of all looks (GSR)
  RoundShare no_penetration;          ///< of these, hands up to 2 mm in table or other objects
  RoundShare removed;                 ///< of the objects (DR), without tables that were stopped
  RoundShare graspable_removed;       ///< of those that are graspable
  RoundShare cleared;                 ///< tables on which nothing is left
};

TableFigures table_figures(std::span<const TableClearing> tables);

/// These figures for people, with reasons of objects without a grasp, outcomes of attempts, how
/// tables ended, the error of tracking, and times.
std::string format_table_report(std::span<const TableClearing> tables);

/// One line per look with its attempt, the names of the columns first.
std::string format_looks_csv(std::span<const TableClearing> tables);

/// One line per object with what the first look found of it, the names of the columns first.
std::string format_first_looks_csv(std::span<const TableClearing> tables);

}  // namespace symscene
