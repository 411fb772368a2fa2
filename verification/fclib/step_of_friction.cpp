#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "verification/fclib/step_conversion.h"

namespace verify {
namespace {

// The blocks whose unknowns a contact moves, ascending.
std::vector<int> blocks_of(const FrictionProblem& problem, Eigen::Index contact, int unknowns) {
  std::vector<int> blocks;
  for (const Eigen::Index column : {2 * contact, 2 * contact + 1})
    for (SparseMatrix::InnerIterator entry(problem.directions, column); entry; ++entry)
      blocks.push_back(static_cast<int>(entry.row()) / unknowns);
  std::ranges::sort(blocks);
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  if (blocks.size() > 2)
    throw std::invalid_argument("contact " + std::to_string(contact) + " moves " + std::to_string(blocks.size()) +
                                " blocks, expected one or two");
  return blocks;
}

using Pairs = std::vector<std::pair<int, int>>;

Pairs pairs_of(const FrictionProblem& problem, int unknowns, int held) {
  Pairs pairs;
  for (Eigen::Index column = 0; column < problem.mass.outerSize(); ++column)
    for (SparseMatrix::InnerIterator entry(problem.mass, column); entry; ++entry)
      pairs.emplace_back(static_cast<int>(entry.row()) / unknowns, static_cast<int>(column) / unknowns);
  for (Eigen::Index k = 0; k < problem.contacts(); ++k) {
    const std::vector<int> blocks = blocks_of(problem, k, unknowns);
    if (!blocks.empty()) pairs.emplace_back(blocks.front(), blocks.size() == 2 ? blocks.back() : held);
  }
  return pairs;
}

void write_base(const FrictionProblem& problem, int unknowns, double rigid, OwnedStep& step) {
  const double stiff = rigid * problem.mass.diagonal().maxCoeff();  // strains of blocks that have none
  for (int i = 0; i < step.base.size(); ++i) step.base.diagonal(i) = stiff * dda::Mat6::Identity();
  for (int i = 0; i + 1 < step.base.size(); ++i) step.base.diagonal(i).topLeftCorner(unknowns, unknowns).setZero();
  for (Eigen::Index column = 0; column < problem.mass.outerSize(); ++column)
    for (SparseMatrix::InnerIterator entry(problem.mass, column); entry; ++entry) {
      const int i = static_cast<int>(entry.row()) / unknowns, j = static_cast<int>(column) / unknowns;
      if (i < j) continue;
      dda::Mat6 single = dda::Mat6::Zero();
      single(entry.row() % unknowns, column % unknowns) = entry.value();
      step.base.add_coupling(i, j, single);
    }
}

using Rows = Eigen::Matrix<double, 2, 6>;

// What the unknowns of a block do to the two gaps of a contact.
Rows rows_of(const FrictionProblem& problem, Eigen::Index contact, int block, int unknowns) {
  Rows rows = Rows::Zero();
  for (const int row : {0, 1})
    for (SparseMatrix::InnerIterator entry(problem.directions, 2 * contact + row); entry; ++entry)
      if (static_cast<int>(entry.row()) / unknowns == block) rows(row, entry.row() % unknowns) = entry.value();
  return rows;
}

// The engine's contacts are points of blocks: normal and arm say all. Unknowns that M has not follow from these.
Rows as_point(const Rows& given, const dda::Mat2& axes, double side, int unknowns, Eigen::Index contact) {
  const dda::Vec2 turned = side * axes.transpose() * given.col(2);  // by a rotation: (-arm_y, arm_x)
  const Rows rows = side * axes * dda::displacement_rows({turned.y(), -turned.x()});
  const double off = (rows.leftCols(unknowns) - given.leftCols(unknowns)).cwiseAbs().maxCoeff();
  if (!(off <= 1e-9 * given.cwiseAbs().maxCoeff()))
    throw std::invalid_argument("contact " + std::to_string(contact) + " is not at a point of its blocks");
  return unknowns == 6 ? given : rows;
}

// Where there are two blocks the later one is b. A block alone is b as well, and a is the one that is held.
dda::InterfaceElement element_of(const FrictionProblem& problem, Eigen::Index contact, int unknowns, int held) {
  const std::vector<int> blocks = blocks_of(problem, contact, unknowns);
  if (blocks.empty())
    throw std::invalid_argument("contact " + std::to_string(contact) + " moves no block, expected one or two");
  dda::InterfaceElement element;
  element.block_a = blocks.size() == 2 ? blocks.front() : held;
  element.block_b = blocks.back();
  element.rows_a.setZero();
  element.rows_b.setZero();
  element.stiffness.setZero();
  const Rows of_b = rows_of(problem, contact, element.block_b, unknowns);
  const dda::Mat2 axes = dda::local_axes(of_b.block<1, 2>(0, 0).transpose());
  element.rows_b.topRows<2>() = as_point(of_b, axes, 1, unknowns, contact);
  const Rows of_a = rows_of(problem, contact, element.block_a, unknowns);
  element.rows_a.topRows<2>() = element.block_a == held ? Rows(-axes * dda::displacement_rows(dda::Vec2::Zero()))
                                                        : as_point(of_a, axes, -1, unknowns, contact);
  return element;
}

// An entry on W's diagonal by the diagonal of M alone, which serves as a scale and no more.
double softness_of(const FrictionProblem& problem, Eigen::Index column) {
  double softness = 0;
  for (SparseMatrix::InnerIterator entry(problem.directions, column); entry; ++entry)
    softness += entry.value() * entry.value() / problem.mass.coeff(entry.row(), entry.row());
  return softness;
}

void add_contact(const FrictionProblem& problem, Eigen::Index contact, int unknowns, double rigid, OwnedStep& step) {
  dda::InterfaceElement element = element_of(problem, contact, unknowns, step.base.size() - 1);
  dda::InterfaceState state;
  state.broken = {true, true};
  for (const int row : {0, 1}) {
    const Eigen::Index column = 2 * contact + row;
    const double given = problem.compliance(column);
    element.stiffness(row) = given > 0 ? 1 / given : rigid / softness_of(problem, column);
    state.gap(row) = problem.gaps(column);
  }
  step.places.push_back(static_cast<int>(contact));
  step.elements.push_back(element);
  step.states.push_back(state);
  step.strengths.push_back({.friction = problem.friction(contact)});
}

}  // namespace

OwnedStep step_of(const FrictionProblem& problem, int unknowns, double rigid) {
  const Eigen::Index count = problem.mass.rows();
  if (unknowns < 1 || unknowns > 6 || count % unknowns != 0)
    throw std::invalid_argument("M has " + std::to_string(count) + " rows, expected a multiple of " +
                                std::to_string(unknowns) + ", those of a block");
  const int blocks = static_cast<int>(count) / unknowns;
  OwnedStep step(dda::BlockMatrix(blocks + 1, pairs_of(problem, unknowns, blocks)));
  write_base(problem, unknowns, rigid, step);
  step.rhs.setZero(6 * (blocks + 1));
  for (int i = 0; i < blocks; ++i) step.rhs.segment(6 * i, unknowns) = problem.force.segment(unknowns * i, unknowns);
  step.guess.setZero(step.rhs.size());
  step.areas.assign(static_cast<std::size_t>(blocks) + 1, 1.0);
  step.held.blocks = {blocks};
  step.held.increments = {dda::Vec6::Zero()};
  step.held.place.assign(step.areas.size(), -1);
  step.held.place.back() = 0;
  for (Eigen::Index k = 0; k < problem.contacts(); ++k) add_contact(problem, k, unknowns, rigid, step);
  return step;
}

OwnedStep::OwnedStep(const dda::StepProblem& copied)
    : base(copied.base),
      rhs(copied.rhs),
      guess(copied.guess),
      areas(copied.areas.begin(), copied.areas.end()),
      places(copied.contacts.places.begin(), copied.contacts.places.end()),
      elements(copied.contacts.elements.begin(), copied.contacts.elements.end()),
      strengths(copied.contacts.strengths.begin(), copied.contacts.strengths.end()),
      states(copied.contacts.states.begin(), copied.contacts.states.end()),
      held(copied.held),
      rule(copied.contacts.rule),
      factor(copied.factor),
      max_passes(copied.max_passes) {}

dda::StepProblem OwnedStep::problem() const {
  return {.base = base,
          .base_version = 1,
          .rhs = rhs,
          .guess = guess,
          .factor = factor,
          .areas = areas,
          .contacts = {places, elements, strengths, states, rule},
          .bolts = {},
          .held = held,
          .dilates = false,
          .max_passes = max_passes};
}

}  // namespace verify
