#pragma once

#include "symscene/core/options.hpp"

namespace symscene {

/// How the objects of a scene are chosen among proposals.
struct SelectionOptions {
  bool by_score = true;
  double min_score = 0.4;
  double uncovered_ratio = 0.5;
  double uncovered_size = 0.25;
  double max_overlap = 0.5;
  double min_parts_cover = 0.9;
  double confidence_exponent = 1.0;
  double part_contained_share = 0.8;
  double max_part_share = 0.85;
  int max_exact_conflicts = 24;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("by_score", self.by_score, "", any_value(),
          "choose among all proposals by probability; otherwise among the hypotheses within the "
          "bounds of section 4.3.3, by size and confidence");
    visit("min_score", self.min_score, "", between(0.0, 1.0),
          "least probability of an object, with by_score");
    visit("uncovered_ratio", self.uncovered_ratio, "", between(0.0, 1.0),
          "share of min_score that an object needs where no likelier one covers it, as what stands "
          "on a table belongs to some object; 1 to require min_score everywhere");
    visit("uncovered_size", self.uncovered_size, "", at_least(0.0),
          "size of the smallest such object, as a share of the median size of the likelier ones: "
          "smaller ones are fragments");
    visit("max_overlap", self.max_overlap, "", between(0.0, 1.0),
          "two objects that share more of the smaller one's points exclude each other");
    visit("min_parts_cover", self.min_parts_cover, "", between(0.0, 1.0),
          "without by_score, an object is rejected if others inside it hold a greater share of its "
          "points");
    visit("confidence_exponent", self.confidence_exponent, "", between(0.0, 20.0),
          "without by_score, an object's weight is its size times this power of its confidence");
    visit("part_contained_share", self.part_contained_share, "", between(0.0, 1.0),
          "without by_score, an object lies inside another that holds a greater share of its "
          "points");
    visit("max_part_share", self.max_part_share, "", between(0.0, 1.0),
          "without by_score, an object inside another has a smaller share of its points");
    visit("max_exact_conflicts", self.max_exact_conflicts, "", between(1, 32),
          "larger components of the conflict graph are solved by local search instead of exactly");
  }
  void validate() const { check_fields(*this); }
};

}  // namespace symscene
