// What CholeskySolver does for parts of the blocks, whichever library factors the whole.
#include "engine/linear/cholesky_solver.h"

namespace dda {
namespace {

// Generations of fill: with one in place of two rock of a thousand blocks moves no faster.
constexpr int fill_level = 2;

}  // namespace

void CholeskySolver::do_analyze(const BlockMatrix& matrix) {
  part_factor_is_laid_out_ = false;
  order_and_lay_out(matrix);
}

Status CholeskySolver::do_factorize_part(const BlockMatrix& matrix, const BlockPart& part) {
  if (!part_factor_is_laid_out_) part_factor_.analyze(matrix, fill_level);
  part_factor_is_laid_out_ = true;
  return part_factor_.factorize(matrix, part) ? Status::ok : Status::singular;
}

double CholeskySolver::do_precondition(const Eigen::VectorXd& r, Eigen::VectorXd& z) {
  if (is_of_part()) return part_factor_.apply(r, z);
  return do_solve(r, z) == Status::ok ? r.dot(z) : 0;
}

}  // namespace dda
