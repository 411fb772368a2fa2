// The matrix of a step without the held blocks, its factor, and what is known of how up to date both are.
//
// "Current" says that matrix and factor are those of the problem at hand, but for contacts that were amended since: a
// contact that changes in the course of an iteration is added to the matrix at once, while the factor stays behind and
// serves as a preconditioner.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>

#include "engine/contact/interface_element.h"
#include "engine/core/phase_clock.h"
#include "engine/core/status.h"
#include "engine/linear/block_matrix.h"
#include "engine/linear/block_part.h"
#include "engine/linear/solver.h"
#include "engine/linear/solver_choice.h"
#include "engine/solve/contact_rows.h"
#include "engine/solve/costs.h"
#include "engine/solve/held_unknowns.h"

namespace dda {

// Why a step has no solution.
enum class Failure { none, unsettled, singular_matrix, linear_solver, not_finite };

// Adds the stiffness of these rows of one interface, in those of its blocks that take part.
void add_contact(double factor, const InterfaceElement& element, const ContactRows& rows, bool in_a, bool in_b,
                 BlockMatrix& matrix);

class StepMatrix {
 public:
  explicit StepMatrix(Costs& costs) : costs_(costs) {}

  // Starts with another solver and the pattern of a matrix; its values are still to be assembled.
  void begin(BlockMatrix pattern, SolverKind kind, double chi, MatrixUse use = MatrixUse::changes);
  // The same solver goes on with another pattern.
  void set_pattern(BlockMatrix pattern);
  // Gives matrix and solver back.
  void end();

  [[nodiscard]] const BlockMatrix& values() const { return *matrix_; }
  [[nodiscard]] LinearSolver& solver() const { return *solver_; }
  [[nodiscard]] const HeldCouplings& couplings() const { return couplings_; }
  [[nodiscard]] std::int64_t iterations() const { return solver_ ? solver_->counts().iterations : 0; }

  [[nodiscard]] bool is_current() const { return is_current_; }
  [[nodiscard]] bool is_amended() const { return is_amended_; }
  [[nodiscard]] bool factor_is_of_part() const { return factor_is_of_part_; }
  [[nodiscard]] int amendments_since_factored() const { return amendments_; }
  // Whether the factor is that of the matrix as it is, so that one solution with it is all there is to do.
  [[nodiscard]] bool has_its_factor() const { return solver_->is_direct() && amendments_ == 0 && !factor_is_of_part_; }
  void outdate() { is_current_ = false; }

  // `write` writes all values, then held blocks are taken out.
  template <typename Write>
  void assemble(const HeldUnknowns& held, const Write& write) {
    const PhaseScope scope(Phase::assembly);
    write(*matrix_);
    couplings_.take_out(held, *matrix_);
    ++costs_.counters.matrix_rebuilds;
    is_amended_ = false;
  }

  [[nodiscard]] Status factorize();
  [[nodiscard]] Status factorize(const BlockPart& part);

  // Adds the stiffness of rows of a contact. Not where held blocks move: what was taken out would change too.
  void amend(double factor, const InterfaceElement& element, const ContactRows& rows, const HeldUnknowns& held);

  // Solves for the increments x; uses up `rhs`.
  [[nodiscard]] Status solve(const HeldUnknowns& held, Eigen::VectorXd& rhs, Eigen::VectorXd& x);

  // Why the last factorize() or solve() failed.
  [[nodiscard]] Failure failure() const { return failure_; }

 private:
  Costs& costs_;
  std::optional<BlockMatrix> matrix_;
  std::unique_ptr<LinearSolver> solver_;
  HeldCouplings couplings_;
  bool is_current_ = false;
  bool is_amended_ = false;
  bool factor_is_of_part_ = false;
  int amendments_ = 0;
  Failure failure_ = Failure::none;
};

}  // namespace dda
