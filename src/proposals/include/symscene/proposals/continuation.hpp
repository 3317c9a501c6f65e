#pragma once

#include "symscene/core/options.hpp"

namespace symscene {

/// Which proposals are joined because one continues the other behind what hides the space between.
struct ContinuationOptions {
  int most = 40;                   ///< proposals that may continue another, the best ones
  double min_score = 0.1;          ///< least score of proposals that are looked at
  double min_continuation = 0.15;  ///< least share of points of both that continue the other
  double whole_belief = 0.75;      ///< that parts are one, where together they look like an object
  double reach = 0.2;              ///< greatest distance between the two [m]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("most", self.most, "", "so many of the best proposals may continue another");
    visit("min_score", self.min_score, "", "least score of proposals that are looked at");
    visit("min_continuation", self.min_continuation, "",
          "share of points that continue the other, for two to be joined");
    visit("whole_belief", self.whole_belief, "",
          "that what continues one another is one object where it looks like one");
    visit("reach", self.reach, "m", "greatest distance between the two");
  }
  /// Throws InputError on a value below 0.
  void validate() const;
};

}  // namespace symscene
