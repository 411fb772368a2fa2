// The quick passes of the open-close iteration: Newton's method on the balance of a step with Coulomb friction in it.
//
// The forces of the interfaces are piecewise linear in the increments. With the pieces of the point reached, a pass
// solves (A + C) step = residual, where A is the symmetric matrix of the active rows and C lets the shear force of ends
// that slide follow their normal force. C is not symmetric, so the solver is GMRES, with what is known of the inverse
// of A as its preconditioner, and a step is only solved for as well as its pieces are likely to hold. No potential
// falls with such a step, and nothing assures that the passes end: mostly they do after a few, and where they do not,
// ConvexPasses go the sure way.
//
// Local passes: after a few passes most of a large scene is in balance, and only where contacts still change is there
// something to do. Such a pass moves the blocks that are out of balance and some rings of neighbours, as if all others
// were held; what that brings out of balance beside them belongs to the part of the next pass.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "engine/contact/contact_pieces.h"
#include "engine/core/status.h"
#include "engine/linear/block_part.h"
#include "engine/linear/krylov.h"
#include "engine/solve/iterate.h"
#include "engine/solve/live_contact.h"

namespace dda {

// How many passes a search for the balance may take.
struct Patience {
  double in_vain;  // such as come no nearer
  int passes = std::numeric_limits<int>::max();
};

class FrictionPasses {
 public:
  // Lists the contacts with a broken end, which are not linear. False where everything is linear, whatever comes: one
  // solve is then all there is to do.
  [[nodiscard]] bool has_something_to_settle(const Iterate& at);

  // Measured on walls of 1,600 to 10,000 bricks that gravity is switched on for: where passes settle they take 5 to 20,
  // and up to 60 in the first step, when all contacts start without force. Hardly any step settles that has not come
  // nearer to the balance with the work of ten passes over all blocks; a local pass does its part of that, and a little
  // in any case. Where there is something else to try soon (see ContactSolver) three are enough.
  static constexpr Patience patience{10}, short_patience{3};

  // Moves the iterate to the balance. False where that was not found with so many passes; the iterate is then anywhere.
  [[nodiscard]] bool find_balance(Iterate& at, const Patience& most);

 private:
  // How friction ties the shear forces of sliding ends to their normal gaps.
  struct Coupling {
    const LiveContact* contact;
    Mat2 shear_by_gap;  // N/m per m of thickness: rows 1 and 3 by the gaps of rows 0 and 2
  };

  // What ends that ride up as they slide answer beyond the rows in the matrix.
  struct Riding {
    const LiveContact* contact;
    std::array<Mat2, 2> slopes;  // of each end, N/m per m of thickness: normal and shear force by these gaps
  };

  // How a step judges the contacts that it moves.
  struct JudgedBy {
    bool strictly;    // PieceRule
    bool one_by_one;  // only the first of those that want to goes over to other pieces
  };

  // What the pass nearest to the balance came to, and what was done since.
  struct Nearest {
    double imbalance = 0;  // N per m of thickness
    int pass = 0;
    double work = 0;             // since then, in passes over all blocks
    int steps_away = 0;          // since then, on trust
    bool is_trust_lost = false;  // from then on steps that lead away are halved

    void begin(double imbalance_reached, int by_pass) { *this = {imbalance_reached, by_pass}; }
  };

  struct LiveOnes {
    bool some_lie = false;     // on beds
    bool have_depths = false;  // all of them
  };

  static constexpr int basis = 40;  // of GMRES

  void resize(Eigen::Index unknowns);
  void take_all();
  void take_part();

  [[nodiscard]] bool goes_in_circles(int stalled_passes) const;
  [[nodiscard]] bool changes_one_by_one(int stalled_passes) const;
  [[nodiscard]] double work_of_pass(const Iterate& at) const;
  [[nodiscard]] bool is_asked_for_more(const Iterate& at) const;
  [[nodiscard]] bool is_balanced(const Iterate& at) const;
  [[nodiscard]] double negligible_imbalance(const Iterate& at) const;
  void form_residual(const Iterate& at);
  void sum_residual(const Iterate& at);

  [[nodiscard]] Status solve_newton_step(Iterate& at, double relative);
  void solve_with_factor(const Iterate& at, double relative);
  void list_couplings(const Iterate& at);
  void list_riding(const Iterate& at, const LiveContact& contact, Mat2& shear_by_gap);
  void multiply_in_pass(const Iterate& at, const Eigen::VectorXd& v, Eigen::VectorXd& w) const;
  void multiply_coupled(const Iterate& at, const Eigen::VectorXd& v, Eigen::VectorXd& w) const;
  void order_by_depth(const Iterate& at);
  void take_whole_step(Iterate& at, const JudgedBy& judged_by);

  // trusted_steps.cpp
  void take_step(Iterate& at, const JudgedBy& judged_by);
  void go_back(Iterate& at, const JudgedBy& judged_by);
  void halve_step(Iterate& at, const JudgedBy& judged_by, double enough);

  // local_pass.cpp
  [[nodiscard]] Status prepare_pass(Iterate& at, bool& changed);
  [[nodiscard]] Status amend_matrix(Iterate& at, bool& changed) const;
  [[nodiscard]] Status prepare_whole_pass(Iterate& at);
  [[nodiscard]] bool choose_part(const Iterate& at);
  void add_neighbours(const Iterate& at);
  void follow_residual(const Iterate& at, const LiveContact& contact, const Vec4& force_before);

  std::vector<LiveContact> live_;
  std::vector<std::size_t> taken_;  // of these, those that the pass moves
  std::vector<Coupling> couplings_;
  std::vector<Riding> riding_;
  BlockPart part_;               // the blocks that a local pass moves
  bool is_local_ = false;        // the pass
  bool between_pieces_ = false;  // some live contact is
  LiveOnes live_ones_;
  Nearest nearest_;
  PointLeft left_;

  std::vector<Vec4> constants_;  // forces of the live contacts that do not depend on the unknowns

  // 6 entries a block.
  Eigen::VectorXd residual_;    // what is left of the balance at the increments reached
  Eigen::VectorXd step_;        // of Newton's method
  Eigen::VectorXd image_;       // matrix * increments
  Eigen::VectorXd correction_;  // of the step, for round-off
  ConjugateGradients gradients_;
  Gmres gmres_{basis};

  double imbalance_ = 0;      // largest entry of the residual, N per m of thickness
  double largest_force_ = 0;  // of contacts and bolts, N per m of thickness
  double largest_asked_ = 0;  // what may be left out of balance on blocks of some weight, N per m of thickness
};

}  // namespace dda
