// Solves the problem of a step (step_problem.h): the open-close iteration.
//
//   const StepSolution& solution = solver.solve(problem);
//   while (solution.status == Status::ok && something broke) solver.go_on(problem);
//
// Quick passes first (friction_passes.h), and where they do not end, sure ones (convex_passes.h). Two outer loops
// follow: dilations move to those of the slips until forces stand still, and ends and bolts beyond their strength
// break, which each can do once. What breaks is an event: the call returns and says so, so that whoever has posed the
// problem can replace what lies outside of it before the iteration goes on from where it stands.
//
// Warm, it allocates nothing.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/core/status.h"
#include "engine/linear/solver_choice.h"
#include "engine/solve/convex_passes.h"
#include "engine/solve/friction_passes.h"
#include "engine/solve/interior_passes.h"
#include "engine/solve/iterate.h"
#include "engine/solve/step_problem.h"

namespace dda {

struct StepSolution {
  Status status = Status::ok;
  Failure failure = Failure::none;
  // Friction followed the forces, quick passes found no balance, and interior ones did: there may be another one.
  bool settled_from_inside = false;
  // An open-close iteration that did not settle, or quick passes that did not: the contact (place among all interfaces;
  // -1: none) that still changes most, and by how much, N per m of thickness.
  int restless_contact = -1;
  double restless_force = 0;
  // Contacts (their places) with an end that broke or began to slide with residual strength, and links of bolts that
  // broke, since the call began. What is reached is then not the answer yet.
  std::vector<int> broken_contacts, broken_links;

  [[nodiscard]] bool something_broke() const { return !broken_contacts.empty() || !broken_links.empty(); }
};

class ContactSolver {
 public:
  explicit ContactSolver(Costs& costs) : at_(costs) {}

  // To be called before the first problem, and when the linear solver or the pattern of the matrix is to be another.
  void begin(BlockMatrix pattern, SolverKind kind, double chi);
  void set_pattern(BlockMatrix pattern);
  void end() { at_.matrix.end(); }
  // The list of bolts may be another than so far: all of their rows are taken up with the next problem.
  void begin_bolts_anew() { at_.bolts = {}; }

  // Solves from the start of the step; goes on from where the last call ended.
  const StepSolution& solve(const StepProblem& problem);
  const StepSolution& go_on(const StepProblem& problem);

  // To be called between the two: an interface that was bonded is now the contact at index k of
  // problem.contacts.places, with these ends broken.
  void admit(const StepProblem& problem, std::size_t k, const std::array<bool, 2>& broken);

  // The solution: increments of all blocks, and contacts and bolts at the end of the step.
  [[nodiscard]] const Eigen::VectorXd& increment() const { return at_.increment; }
  [[nodiscard]] const InterfaceTrials& contacts() const { return at_.contacts; }
  [[nodiscard]] const BoltTrials& bolts() const { return at_.bolts; }

  // Counts those of the linear solver in use; those of earlier ones are in the costs.
  [[nodiscard]] std::int64_t solver_iterations() const { return at_.matrix.iterations(); }

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [at, friction, convex, interior, solution, base_version, rises, without_quick_passes, is_sure] = self;
    archive(at, without_quick_passes);  // all else begins with every step
  }

 private:
  void begin_at(const Eigen::VectorXd& increment);
  void move_held_blocks();
  const StepSolution& settle_from_here();
  [[nodiscard]] Status settle();
  [[nodiscard]] Status settle_contacts();
  [[nodiscard]] bool settle_quickly(const Patience& most = FrictionPasses::short_patience);
  [[nodiscard]] bool settle_from_inside();
  [[nodiscard]] Status settle_with_given_capacities();
  [[nodiscard]] bool settle_with_friction();
  void note_restless();

  Iterate at_;
  FrictionPasses friction_;
  ConvexPasses convex_;
  InteriorPasses interior_;
  StepSolution solution_;
  std::uint64_t base_version_ = 0;
  int rises_ = 0;                 // times that dilations moved in this step
  int without_quick_passes_ = 0;  // > 0: steps in a row that begin with interior ones, up to the next
  bool is_sure_ = false;  // its dilations move between sure passes: the quick ones, which have them, did not settle
};

}  // namespace dda
