#pragma once

#include "symscene/core/options.hpp"
#include "symscene/core/tree_model.hpp"

namespace symscene {

/// Fitted models in place of the embedded ones (models/README.md).
struct ModelOptions {
  ModelChoice object_alone;
  ModelChoice object_among_others;
  ModelChoice axis;
  ModelChoice plane;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("object_alone", self.object_alone.file, "", any_value(),
          "file of the model that scores a proposal by itself; empty: models/object_alone.txt, "
          "embedded");
    visit("object_among_others", self.object_among_others.file, "", any_value(),
          "file of the model that scores a proposal among the others, fitted with object_alone; "
          "empty: embedded");
    visit("axis", self.axis.file, "", any_value(),
          "file of the model of an object's axis; empty: models/axis.txt, embedded");
    visit("plane", self.plane.file, "", any_value(),
          "file of the model of an object's mirror planes; empty: models/plane.txt, embedded");
  }
  /// Calls `act` for every choice.
  template <class Act>
  void for_each(Act&& act) {
    for (ModelChoice* choice : {&object_alone, &object_among_others, &axis, &plane}) act(*choice);
  }
  /// Throws InputError if a file is given without its model, a model was fitted to other features,
  /// or only one of the two object models is replaced.
  void validate() const;
};

}  // namespace symscene
