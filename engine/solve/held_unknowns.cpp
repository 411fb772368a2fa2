#include "engine/solve/held_unknowns.h"

namespace dda {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

void HeldUnknowns::put(Eigen::VectorXd& d) const {
  for (std::size_t i = 0; i < blocks.size(); ++i) d.segment<6>(6 * blocks[i]) = increments[i];
}

void HeldUnknowns::clear(Eigen::VectorXd& force) const {
  for (const int block : blocks) force.segment<6>(6 * block).setZero();
}

bool HeldUnknowns::moved_by(const Eigen::VectorXd& p) const {
  for (const int block : blocks)
    if (!p.segment<6>(6 * block).isZero(0)) return true;
  return false;
}

double HeldUnknowns::work(const Eigen::VectorXd& force) const {
  double work = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) work += increments[i].dot(force.segment<6>(6 * blocks[i]));
  return work;
}

Vec4 HeldUnknowns::gap_increment(const InterfaceElement& element) const {
  Vec4 gap = Vec4::Zero();
  const int a = place[at(element.block_a)];
  const int b = place[at(element.block_b)];
  if (a >= 0) gap += element.rows_a * increments[at(a)];
  if (b >= 0) gap += element.rows_b * increments[at(b)];
  return gap;
}

void HeldCouplings::take_out(const HeldUnknowns& held, BlockMatrix& matrix) {
  if (held.empty()) return;
  couplings_.clear();
  for (int column = 0; column < matrix.size(); ++column) {
    const bool column_is_held = held.holds(column);
    if (column_is_held) matrix.diagonal(column).setIdentity();
    const auto first = at(matrix.column_starts()[at(column)]) + 1;
    const auto last = at(matrix.column_starts()[at(column) + 1]);
    for (std::size_t k = first; k < last; ++k) {
      const int row = matrix.block_rows()[k];
      const bool row_is_held = held.holds(row);
      if (!column_is_held && !row_is_held) continue;
      auto entry = matrix.offdiagonal(static_cast<int>(k));
      if (held.move && !row_is_held) couplings_.push_back({row, column, entry});
      if (held.move && !column_is_held) couplings_.push_back({column, row, entry.transpose()});
      entry.setZero();
    }
  }
}

void HeldCouplings::move_to_right(const HeldUnknowns& held, Eigen::VectorXd& rhs) const {
  for (const Coupling& coupling : couplings_)
    rhs.segment<6>(6 * coupling.block).noalias() -=
        coupling.stiffness * held.increments[at(held.place[at(coupling.held)])];
  held.put(rhs);
}

double HeldCouplings::work(const Eigen::VectorXd& d, const Eigen::VectorXd& p) const {
  double work = 0;
  for (const Coupling& coupling : couplings_)
    work += p.segment<6>(6 * coupling.block).dot(coupling.stiffness * d.segment<6>(6 * coupling.held));
  return work;
}

}  // namespace dda
