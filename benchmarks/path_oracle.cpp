#include "path_oracle.hpp"

#include "symscene/core/error.hpp"

#ifdef SYMSCENE_HAS_OMPL
#include <numbers>

#include <ompl/base/MotionValidator.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#endif

namespace symscene::bench {

#ifdef SYMSCENE_HAS_OMPL

namespace {

namespace ob = ompl::base;

Eigen::VectorXd positions_of(const ob::State* state, Eigen::Index joints) {
  const double* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
  return Eigen::Map<const Eigen::VectorXd>(values, joints);
}

class Motions : public ob::MotionValidator {
 public:
  Motions(const ob::SpaceInformationPtr& information, const MotionValidity& validity,
          Eigen::Index joints)
      : ob::MotionValidator(information), validity_(validity), joints_(joints) {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    return validity_.is_free(positions_of(from, joints_), positions_of(to, joints_));
  }
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& /*last_valid*/) const override {
    return checkMotion(from, to);
  }

 private:
  const MotionValidity& validity_;
  Eigen::Index joints_;
};

std::shared_ptr<ob::RealVectorStateSpace> state_space(const JointSpace& space) {
  const auto joints = static_cast<unsigned>(space.size());
  ob::RealVectorBounds bounds(joints);
  for (unsigned i = 0; i < joints; ++i) {
    const bool turns = space.continuous[i];
    bounds.setLow(i, turns ? -std::numbers::pi : space.lower[i]);
    bounds.setHigh(i, turns ? std::numbers::pi : space.upper[i]);
  }
  auto states = std::make_shared<ob::RealVectorStateSpace>(joints);
  states->setBounds(bounds);
  return states;
}

}  // namespace

bool has_path_oracle() { return true; }

bool oracle_finds_path(const JointSpace& space, const Eigen::VectorXd& start,
                       const Eigen::VectorXd& goal, const MotionValidity& validity,
                       double seconds) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  const auto states = state_space(space);
  ompl::geometric::SimpleSetup setup(states);
  const ob::SpaceInformationPtr information = setup.getSpaceInformation();
  setup.setStateValidityChecker([&](const ob::State* state) {
    return validity.obstacle(positions_of(state, space.size())).empty();
  });
  information->setMotionValidator(std::make_shared<Motions>(information, validity, space.size()));
  ob::ScopedState<ob::RealVectorStateSpace> from(states);
  ob::ScopedState<ob::RealVectorStateSpace> to(states);
  for (Eigen::Index i = 0; i < space.size(); ++i) {
    from[static_cast<unsigned>(i)] = start[i];
    to[static_cast<unsigned>(i)] = goal[i];
  }
  setup.setStartAndGoalStates(from, to);
  setup.setPlanner(std::make_shared<ompl::geometric::RRTConnect>(information));
  return setup.solve(seconds) == ob::PlannerStatus::EXACT_SOLUTION;
}

#else

bool has_path_oracle() { return false; }

bool oracle_finds_path(const JointSpace&, const Eigen::VectorXd&, const Eigen::VectorXd&,
                       const MotionValidity&, double) {
  throw InputError("--oracle", "a build with OMPL (libompl-dev)", "none");
}

#endif

}  // namespace symscene::bench
