#include "engine/simulation/lining_set.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/model/lining_chord.h"

namespace dda {
namespace {

// Forces of elements that yield stand still when they change by no more than this share of the largest.
constexpr double force_tolerance = 1e-10;

// Newton's method takes a few rounds; where it goes in circles elastic slopes lead to the same end, slowly.
constexpr int quick_rounds = 20;

const Mat2& deformation_of(const State& state, int block) { return state.deformation[static_cast<std::size_t>(block)]; }

Vec2 drawn_chord(const LiningNode& a, const LiningNode& b) { return b.point - a.point; }

// How the chord has changed, exact however small that is.
Vec2 change_of_chord(const Model& model, const State& state, const LiningNode& a, const LiningNode& b) {
  return point_displacement(model, state, b.block, b.point) - point_displacement(model, state, a.block, a.point);
}

LiningGrip grip_in(const Model& model, const State& state, const LiningNode& node) {
  return {local_position(model, state, node.block, node.point) - local_centroid(model, state, node.block),
          (deformation_of(state, node.block) * node.tangent).normalized()};
}

// By which angle the direction `drawn` has turned when it has become drawn + change.
double turn_by(const Vec2& drawn, const Vec2& change) { return angle_between(drawn, drawn + change); }

double stretch_by(const Vec2& drawn, const Vec2& change) {
  return change.dot(2 * drawn + change) / ((drawn + change).norm() + drawn.norm());
}

// Returns the same turn within half a turn of none.
double wrapped(double turn) { return std::remainder(turn, 2 * std::numbers::pi); }

// The gaps as measured from the drawing: they follow the chord, so that no rigid motion counts.
Vec3 measured(const Model& model, const State& state, const LiningNode& a, const LiningNode& b) {
  const Vec2 chord = drawn_chord(a, b);
  const Vec2 change = change_of_chord(model, state, a, b);
  const Vec2 change_a = deformation_of(state, a.block) * a.tangent - a.tangent;
  const Vec2 change_b = deformation_of(state, b.block) * b.tangent - b.tangent;
  const double turn = turn_by(chord, change);
  const double turn_a = wrapped(turn_by(a.tangent, change_a) - turn);
  const double turn_b = wrapped(turn_by(b.tangent, change_b) - turn);
  const double grown = stretch_by(b.tangent, change_b) - stretch_by(a.tangent, change_a);
  return {stretch_by(chord, change), turn_b - turn_a,
          (turn_a + turn_b) / 2 + grown * angle_between(a.tangent, b.tangent) / 12};
}

// Rows where the blocks are in `acting`.
void place(const Model& model, const State& acting, const LiningNode& a, const LiningNode& b, LiningElement& element) {
  const Vec2 chord = drawn_chord(a, b) + change_of_chord(model, acting, a, b);
  element.rows = lining_rows(chord, grip_in(model, acting, a), grip_in(model, acting, b));
}

Mat3 slope_of(const LiningElement& element) {
  return element.tangent.is_elastic ? Mat3(element.stiffness.asDiagonal()) : element.tangent.slope;
}

// Diagonal blocks keep both triangles, alike to the last bit.
Mat6 symmetric(const Mat6& matrix) { return (matrix + matrix.transpose()) / 2; }

// By how much the gaps grow as all blocks move by `increment`.
Vec3 growth(const LiningElement& element, const Eigen::VectorXd& increment) {
  return element.rows.a * increment.segment<6>(6 * element.block_a) +
         element.rows.b * increment.segment<6>(6 * element.block_b);
}

// What the step takes for the force where the gap is `gap`.
Vec3 expected(const LiningElement& element, const Vec3& gap) {
  if (element.tangent.is_elastic) return element.stiffness.cwiseProduct(gap);
  return element.tangent.force + element.tangent.slope * (gap - element.tangent.at);
}

// The largest of N, M and Q by size: M and Q are divided by the thickness as their lever, so that they compare with N.
double size_of(const LiningElement& element, const Vec3& force) {
  const Vec3 comparable(force(0), force(1) / element.strength.thickness, force(2) / element.strength.thickness);
  return comparable.cwiseAbs().maxCoeff();
}

// The forces that the element exerts, as internal forces.
void add(const LiningElement& element, Eigen::VectorXd& force) {
  force.segment<6>(6 * element.block_a).noalias() += element.rows.a.transpose() * element.force();
  force.segment<6>(6 * element.block_b).noalias() += element.rows.b.transpose() * element.force();
}

void leave_waiting(LiningElement& element) {
  element.waits = true;
  element.gap.setZero();
  element.plastic.setZero();
}

bool is_same_node(const LiningNode& a, const LiningNode& b) {
  return a.block == b.block && a.point == b.point && a.tangent == b.tangent;
}

bool is_same_lining(const Lining& a, const Lining& b) {
  return a.closed == b.closed && a.thickness == b.thickness && a.young == b.young && a.poisson == b.poisson &&
         std::ranges::equal(a.nodes, b.nodes, is_same_node);
}

}  // namespace

LiningSet::LiningSet(const Model& model, const State& state) {
  for (const Lining& lining : model.linings) {
    first_element_.push_back(elements_.size());
    const LiningStrength strength{lining.thickness, lining.compressive_strength * lining.thickness,
                                  lining.tensile_strength * lining.thickness};
    const LiningSection section = lining_section(lining.thickness, lining.young, lining.poisson);
    for (std::size_t i = 0; i < lining.elements(); ++i) {
      const LiningNode& a = lining.start_of(i);
      const LiningNode& b = lining.end_of(i);
      LiningElement element;
      element.block_a = a.block;
      element.block_b = b.block;
      element.can_yield = lining.yields();
      element.strength = strength;
      element.stiffness = lining_stiffness(section, chord_of(lining, i).norm());
      element.waits = lining.first_stage > 0;
      place(model, state, a, b, element);
      elements_.push_back(element);
    }
  }
}

SectionForces LiningSet::forces(const Model& model, std::size_t lining, std::size_t element) const {
  const LiningElement& at = this->element(lining, element);
  const Vec3 force = at.force();
  const double length = chord_of(model.linings[lining], element).norm();
  const double used = at.can_yield ? utilisation(at.strength, force) : 0;
  return {-force(0), force(1) - force(2) / 2, force(1) + force(2) / 2, force(2) / length, used};
}

std::vector<std::pair<int, int>> LiningSet::pairs() const {
  std::vector<std::pair<int, int>> pairs;
  for (const LiningElement& element : elements_)
    if (!element.waits && element.block_a != element.block_b) pairs.emplace_back(element.block_a, element.block_b);
  return pairs;
}

double LiningSet::stored_energy() const {
  double energy = 0;
  for (const LiningElement& element : elements_) energy += element.gap.dot(element.force()) / 2;
  return energy;
}

void LiningSet::add_stiffness(double factor, BlockMatrix& matrix) const {
  for (const LiningElement& element : elements_) {
    if (element.waits) continue;  // the matrix has no room for it
    const Mat3 slope = factor * slope_of(element);
    const Eigen::Matrix<double, 6, 3> weighted_a = element.rows.a.transpose() * slope;
    const Eigen::Matrix<double, 6, 3> weighted_b = element.rows.b.transpose() * slope;
    matrix.diagonal(element.block_a) += symmetric(weighted_a * element.rows.a);
    matrix.diagonal(element.block_b) += symmetric(weighted_b * element.rows.b);
    const Mat6 coupling = weighted_b * element.rows.a;
    if (element.block_a == element.block_b) {
      matrix.diagonal(element.block_a) += coupling + coupling.transpose();
    } else {
      matrix.add_coupling(element.block_b, element.block_a, coupling);
    }
  }
}

void LiningSet::add_force(Eigen::VectorXd& force) const {
  for (const LiningElement& element : elements_)
    if (!element.waits) add(element, force);
}

void LiningSet::take_out(std::size_t lining, const Model& model, Eigen::VectorXd& exerted) {
  for (std::size_t j = 0; j < model.linings[lining].elements(); ++j) {
    LiningElement& element = elements_[first_element_[lining] + j];
    if (element.waits) continue;
    add(element, exerted);
    leave_waiting(element);
  }
}

void LiningSet::put_in_those_of(std::size_t stage, const Model& model, const State& state, const State& acting) {
  for (std::size_t i = 0; i < model.linings.size(); ++i)
    if (static_cast<std::size_t>(model.linings[i].first_stage) == stage) put_in(i, model, state, acting);
}

void LiningSet::put_in(std::size_t i, const Model& model, const State& state, const State& acting) {
  const Lining& lining = model.linings[i];
  for (std::size_t j = 0; j < lining.elements(); ++j) {
    LiningElement& element = elements_[first_element_[i] + j];
    element.waits = false;
    element.gap.setZero();
    element.plastic.setZero();
    element.start = measured(model, state, lining.start_of(j), lining.end_of(j));
    place(model, acting, lining.start_of(j), lining.end_of(j), element);
  }
}

void LiningSet::go_on_from(const Model& before_model, const LiningSet& before, const Model& model, std::size_t next,
                           const State& state, const State& acting) {
  for (std::size_t i = 0; i < model.linings.size(); ++i) {
    const Lining& lining = model.linings[i];
    const auto same =
        std::ranges::find_if(before_model.linings, [&](const Lining& each) { return is_same_lining(each, lining); });
    const auto place_before = static_cast<std::size_t>(same - before_model.linings.begin());
    const bool waits = static_cast<std::size_t>(lining.first_stage) >= next || lining.withdrawal.is_over_in(next - 1);
    const bool is_new = same == before_model.linings.end() || before.element(place_before, 0).waits;
    if (!waits && is_new) put_in(i, model, state, acting);
    for (std::size_t j = 0; j < lining.elements(); ++j) {
      LiningElement& element = elements_[first_element_[i] + j];
      if (waits) {
        leave_waiting(element);
      } else if (!is_new) {
        const LiningElement now = element;
        element = before.element(place_before, j);
        element.can_yield = now.can_yield;
        element.strength = now.strength;
      }
    }
  }
}

void LiningSet::update_geometry(const Model& model, const State& state, const State& acting) {
  std::size_t next = 0;
  for (const Lining& lining : model.linings)
    for (std::size_t j = 0; j < lining.elements(); ++j) {
      LiningElement& element = elements_[next++];
      if (element.waits) continue;
      place(model, acting, lining.start_of(j), lining.end_of(j), element);
      element.gap = measured(model, state, lining.start_of(j), lining.end_of(j)) - element.start - element.plastic;
    }
}

void LiningSet::advance(const Eigen::VectorXd& increment) {
  for (LiningElement& element : elements_)
    if (!element.waits) element.gap += growth(element, increment);
}

bool LiningSet::begin_step() {
  bool changed = false;
  for (LiningElement& element : elements_) {
    changed = changed || !element.tangent.is_elastic;
    element.tangent.is_elastic = true;
  }
  return changed;
}

LiningRound LiningSet::follow(const Eigen::VectorXd& increment, int round) {
  const bool surely = round >= quick_rounds;
  LiningRound done;
  double largest = 0;
  double mismatch = 0;
  for (LiningElement& element : elements_) {
    if (element.waits || !element.can_yield) continue;
    const Vec3 gap = element.gap + growth(element, increment);
    const LiningAnswer answer = lining_answer(element.strength, element.stiffness, gap);
    mismatch = std::max(mismatch, size_of(element, answer.force - expected(element, gap)));
    largest = std::max(largest, size_of(element, answer.force));
    const Mat3 slope_before = slope_of(element);
    element.tangent = {!answer.yields, gap, answer.force,
                       surely ? Mat3(element.stiffness.asDiagonal()) : answer.tangent};
    if (slope_of(element) != slope_before) done.has_other_slopes = true;
  }
  done.goes_on = mismatch > force_tolerance * largest;
  return done;
}

void LiningSet::add_constant_forces(double factor, Eigen::VectorXd& rhs) const {
  for (const LiningElement& element : elements_) {
    if (element.tangent.is_elastic || element.waits) continue;
    const Vec3 constant = factor * (expected(element, element.gap) - element.force());
    rhs.segment<6>(6 * element.block_a).noalias() -= element.rows.a.transpose() * constant;
    rhs.segment<6>(6 * element.block_b).noalias() -= element.rows.b.transpose() * constant;
  }
}

void LiningSet::accept(const Eigen::VectorXd& increment, EnergyAudit& audit) {
  for (LiningElement& element : elements_) {
    if (element.waits) continue;
    const Vec3 grown = growth(element, increment);
    const Vec3 before = element.gap;
    element.gap += grown;
    if (!element.can_yield) continue;
    const LiningAnswer answer = lining_answer(element.strength, element.stiffness, element.gap);
    if (!answer.yields) continue;
    const Vec3 trial = element.gap;
    element.gap = answer.force.cwiseQuotient(element.stiffness);
    element.plastic += trial - element.gap;
    const Vec3 force_before = element.stiffness.cwiseProduct(before);
    const double work = grown.dot(force_before + answer.force) / 2;
    const double stored = (element.gap.dot(answer.force) - before.dot(force_before)) / 2;
    const double plastic = answer.force.dot(trial - element.gap);
    audit.bolt_changed(plastic, work - stored - plastic);
  }
}

}  // namespace dda
