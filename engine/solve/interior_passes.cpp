#include "engine/solve/interior_passes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "engine/contact/contact_set.h"
#include "engine/contact/projected_law.h"
#include "engine/core/phase_clock.h"
#include "engine/solve/largest_entry.h"

namespace dda {
namespace {

// Steps go this share of the way to where the first force or length vanishes.
constexpr double kept_inside = 0.99;

// What a bed gives way goes without bound where little of it is closed, and the way there is the shorter the farther
// inside it begins. (In slopes of 481 and 1,030 blocks that settle, 13 of 273 and none of 80 such ways lead nowhere;
// with ten times as much 36 and 4, with a tenth 19 and 2, and with none 49 and 2.)
constexpr double farther_inside = 1e2;

// Most take 15 to 30, whatever the number of blocks.
constexpr int most_passes = 80;

// Where steps are shorter than that products are first brought to the same size; shorter ones lead nowhere.
constexpr double short_step = 0.1;
constexpr double shortest_step = 1e-6;

// So many short steps, one after the other, come to a place where the way turns back, as friction that follows the
// pressures has no answer beside it. (28 of 112 ways in a slope of 545 blocks that slides came to one. They went on for
// up to 50 passes, and none arrived.)
constexpr int most_short_steps = 5;

bool has_other_answers(const InterfaceSprings& springs, const InterfaceTrial& trial) {
  const bool is_damped = trial.rule.dashpot_rate != 0 && !springs.dashpot.isZero(0);
  const bool hardens = trial.hardening[0] != 0 || trial.hardening[1] != 0;
  return trial.rule.conserves_energy || trial.rule.sticks || is_damped || hardens;
}

}  // namespace

bool InteriorPasses::serve(const Iterate& at) {
  if (!at.bolts.empty() || at.problem->dilates || !at.matrix.solver().is_direct()) return false;
  if (!InteriorFriction::serves(at)) return false;
  for (std::size_t k = 0; k < at.contacts.size(); ++k)
    if (has_other_answers(at.contacts.element(k), at.contacts[k])) return false;
  return true;
}

bool InteriorPasses::begin(Iterate& at) {
  friction_.begin(at);
  list_rows(at);
  start_at_rest(at);
  const double product = start_products(at);
  if (!(product > 0)) return false;
  measure(at);
  passes_left_ = std::min(most_passes, at.problem->max_passes);
  short_steps_ = 0;
  return true;
}

bool InteriorPasses::approach(Iterate& at, double share_off) {
  while (off_answers(at) > share_off) {
    if (passes_left_-- == 0 || short_steps_ == most_short_steps) return false;
    ++at.costs.counters.open_close_iterations;
    const double share = find_step(at);
    if (!(share > shortest_step) || !std::isfinite(share)) return false;
    short_steps_ = share < short_step ? short_steps_ + 1 : 0;
    move(share);
    measure(at);
  }
  at.increment = increment_;
  for (std::size_t k = 0; k < at.contacts.size(); ++k) at.contacts.measure(k, at.increment);
  if (friction_.follows()) std::ignore = at.contacts.follow_capacities();
  at.matrix.outdate();
  return true;
}

// Predicts and corrects; returns the share of the step that stays inside. 0: none.
double InteriorPasses::find_step(Iterate& at) {
  if (factorize(at) != Status::ok) return 0;
  friction_.couple(at, beds_, rows_);
  const double product = mean_product(0);
  if (solve(at, 0, false) != Status::ok) return 0;
  const double left = mean_product(longest_step()) / product;
  if (solve(at, left * left * left * product, true) != Status::ok) return 0;
  const double share = std::min(1.0, kept_inside * longest_step());
  if (!(share < short_step)) return share;
  // Some product is far below the others.
  return solve(at, product, false) == Status::ok ? std::min(1.0, kept_inside * longest_step()) : 0;
}

// Infinite where the balance is not a number.
double InteriorPasses::off_answers(const Iterate& at) const {
  double off = imbalance_, largest = 0;
  for (const InteriorRow& row : rows_) {
    largest = std::max(largest, row.force);
    if (row.on_bed) continue;
    const double stuck = row.stiffness * gaps_[row.contact](row.row);
    const double answer = row.is_normal() ? std::max(0.0, -stuck) : std::clamp(stuck, -row.capacity, row.capacity);
    off = std::max(off, std::abs(answer - row.force));
  }
  off = std::max(off, beds_off_answers(at));
  return largest > 0 && std::isfinite(imbalance_) ? off / largest : std::numeric_limits<double>::infinity();
}

// Linear rows keep their places in forces_, all others are listed.
void InteriorPasses::list_rows(const Iterate& at) {
  rows_.clear();
  for (std::size_t k = 0; k < at.contacts.size(); ++k) {
    const InterfaceTrial& trial = at.contacts[k];
    const InterfaceSprings& springs = at.contacts.element(k);
    const bool on_bed = press_together(springs, trial.broken);
    const auto list_normal = [&](int end) {
      rows_.push_back(
          {.contact = k, .row = 2 * end, .stiffness = springs.stiffness(2 * end), .capacity = -1, .on_bed = on_bed});
    };
    if (on_bed)
      for (const int end : {0, 1}) list_normal(end);
    for (int end = 0; end < ends_of(springs); ++end) {
      const auto e = static_cast<std::size_t>(end);
      if (!trial.broken[e]) continue;
      if (!on_bed) list_normal(end);
      if (!std::isfinite(trial.capacity[e])) continue;
      rows_.push_back({.contact = k,
                       .row = 2 * end + 1,
                       .stiffness = springs.stiffness(2 * end + 1),
                       .capacity = trial.capacity[e]});
    }
  }
  list_beds();
}

// At rest, but for held blocks that move.
void InteriorPasses::start_at_rest(const Iterate& at) {
  increment_.setZero(at.increment.size());
  if (!at.problem->held.empty()) at.problem->held.put(increment_);
  gaps_.resize(at.contacts.size());
  forces_.resize(at.contacts.size());
  for (std::size_t k = 0; k < at.contacts.size(); ++k)
    gaps_[k] = at.contacts.state(k).gap + gap_increment(at.contacts.element(k), increment_);
}

// Products of the size of the energies that the step is about: what the springs store at its start, and what the loads
// of the step do where all that touches stays together.
double InteriorPasses::start_products(Iterate& at) {
  const double stored = take_answers(at);
  measure(at);
  if (factorize(at) != Status::ok) return 0;
  at.matrix.solver().precondition(rhs_, step_);
  at.problem->held.clear(step_);
  double product = std::max(stored, std::abs(rhs_.dot(step_))) / static_cast<double>(rows_.size());
  if (!beds_.empty()) product *= farther_inside;
  for (InteriorRow& row : rows_)
    if (row.is_normal() && !row.on_bed) move_inside(product, gaps_[row.contact](row.row), row);
  move_beds_inside(at, product);
  take_forces_of_rows(at);
  for (InteriorRow& row : rows_)
    if (!row.is_normal()) move_inside(product, gaps_[row.contact](row.row), row);
  std::erase_if(rows_, [](const InteriorRow& row) { return row.capacity == 0; });
  list_beds();
  return product;
}

// What ends answer to their gaps, and what the normal ones store of it, twice over.
double InteriorPasses::take_answers(const Iterate& at) {
  double stored = 0;
  for (InteriorBed& ends : beds_) stored += take_answer_of_bed(at.contacts.element(rows_[ends.first].contact), ends);
  for (InteriorRow& row : rows_) {
    if (row.on_bed || !row.is_normal()) continue;
    row.force = std::max(0.0, -row.stiffness * gaps_[row.contact](row.row));
    row.share = row.force == 0 ? 0.0 : 1.0;
    stored += row.force * row.force / row.stiffness;
  }
  take_forces_of_rows(at);
  for (InteriorRow& row : rows_) {
    if (row.is_normal()) continue;
    row.force = std::clamp(row.stiffness * gaps_[row.contact](row.row), -row.capacity, row.capacity);
    row.share = row.capacity == 0 ? 0.0 : 1.0;
  }
  return stored;
}

// Partners and lengths that have this product: of a normal row those that fit its gap.
void InteriorPasses::move_inside(double product, double gap, InteriorRow& row) {
  if (row.is_normal()) {
    const double root = std::sqrt(gap * gap + 4 * product / row.stiffness);
    row.force = gap < 0 ? row.stiffness * (root - gap) / 2 : 2 * product / (root + gap);
    row.partner[0] = row.force;
    row.length[0] = product / row.force;
  } else if (row.capacity > 0) {
    const double share = std::clamp(row.force / row.capacity, -0.5, 0.5);
    row.partner = {1 - share, 1 + share};
    row.length = {product / row.capacity / row.partner[0], product / row.capacity / row.partner[1]};
  }
}

// Forces of normal rows and then, as shares of the capacities that may follow these, of tangential ones.
void InteriorPasses::take_forces_of_rows(const Iterate& at) {
  for (const InteriorRow& row : rows_)
    if (row.is_normal()) forces_[row.contact](row.row) = -row.force;
  take_forces_of_beds(at);
  friction_.take_capacities(at, forces_, mean_product(0), rows_);
  for (InteriorRow& row : rows_) {
    if (row.is_normal()) continue;
    if (row.length[0] > 0) row.force = row.capacity * row.share_of_capacity();
    forces_[row.contact](row.row) = row.force;
  }
}

void InteriorPasses::measure(const Iterate& at) {
  const PhaseScope scope(Phase::judging);
  for (std::size_t k = 0; k < at.contacts.size(); ++k) {
    const InterfaceTrial& trial = at.contacts[k];
    const InterfaceElement& element = at.contacts.element(k);
    gaps_[k] = at.contacts.state(k).gap + gap_increment(element, increment_);
    forces_[k] = element.stiffness.cwiseProduct(gaps_[k]);
    for (int end = 0; end < ends_of(element); ++end) {
      const auto e = static_cast<std::size_t>(end);
      if (!trial.broken[e]) continue;
      forces_[k](2 * end) = 0;
      if (std::isfinite(trial.capacity[e])) forces_[k](2 * end + 1) = 0;
    }
  }
  take_forces_of_rows(at);
  rhs_ = at.problem->rhs;
  image_.resize(rhs_.size());
  step_.resize(rhs_.size());
  at.problem->base.multiply(increment_, image_);
  rhs_ -= image_;
  for (std::size_t k = 0; k < at.contacts.size(); ++k)
    add_interface_force(at.contacts.element(k), at.problem->factor * (at.contacts.state(k).force - forces_[k]),
                        Vec4::Zero(), rhs_);
  at.problem->held.clear(rhs_);
  imbalance_ = 0;
  for (std::size_t i = 0; i < at.problem->areas.size(); ++i)
    imbalance_ = std::max(imbalance_, largest_entry(rhs_, i, at.problem->areas[i]));
}

// Mean product of force and length after this share of the step.
double InteriorPasses::mean_product(double share) const {
  double sum = 0;
  int count = 0;
  for (const InteriorRow& row : rows_) {
    for (int i = 0; i < row.products(); ++i, ++count) {
      const auto n = static_cast<std::size_t>(i);
      const double partner = row.partner[n] + (share > 0 ? share * row.partner_step(i) : 0);
      const double unit = row.unit() + share * row.capacity_step;
      sum += unit * partner * (row.length[n] + share * row.length_step[n]);
    }
  }
  return count > 0 ? sum / count : 0;
}

Status InteriorPasses::factorize(Iterate& at) {
  active_.assign(at.contacts.size(), {});
  for (std::size_t k = 0; k < at.contacts.size(); ++k) {
    const InterfaceTrial& trial = at.contacts[k];
    for (const int end : {0, 1})
      if (trial.broken[static_cast<std::size_t>(end)] && std::isfinite(trial.capacity[static_cast<std::size_t>(end)]))
        active_[k].active.segment<2>(2 * end).setZero();
  }
  take_shares(at);
  for (const InteriorRow& row : rows_)
    if (!row.on_bed) active_[row.contact].active(row.row) = row.share;
  take_rows_of_beds();
  at.matrix.assemble(at.problem->held, [&](BlockMatrix& values) {
    values.set_values(at.problem->base);
    for (std::size_t k = 0; k < active_.size(); ++k)
      add_contact(at.problem->factor, at.contacts.element(k), active_[k], true, true, values);
  });
  return at.matrix.factorize();
}

void InteriorPasses::take_shares(const Iterate& at) {
  for (InteriorRow& row : rows_) {
    if (row.length[0] == 0 || row.on_bed) continue;  // before there are products
    double softness = 1 / row.stiffness;
    if (row.is_normal()) softness += row.length[0] / row.partner[0];
    if (!row.is_normal()) softness += row.slip_by_force(0) + row.slip_by_force(1);
    row.share = 1 / (row.stiffness * softness);
  }
  take_stiffness_of_beds(at);
}

// With all products going to `product`. A step that `corrects` takes in what the last one left of its products.
Status InteriorPasses::solve(Iterate& at, double product, bool corrects) {
  const PhaseScope scope(Phase::solution);
  ++at.costs.counters.solves;
  image_ = rhs_;
  eliminate_beds(at, product, corrects);
  for (InteriorRow& row : rows_)
    if (!row.on_bed) eliminate_lengths(gaps_[row.contact](row.row), product, corrects, row);
  friction_.eliminate(at, beds_, rows_);
  for (const InteriorRow& row : rows_) {
    if (row.on_bed) continue;
    const double outwards = row.is_normal() ? -row.constant : row.constant;
    Vec4 force = Vec4::Zero();
    force(row.row) = -at.problem->factor * outwards;
    add_interface_force(at.contacts.element(row.contact), force, Vec4::Zero(), image_);
  }
  at.problem->held.clear(image_);
  const Status status = friction_.solve(at, image_, corrects, step_);
  at.problem->held.clear(step_);
  follow_beds(at);
  const auto follow_gaps = [&](bool normal) {
    for (InteriorRow& row : rows_) {
      if (row.on_bed || row.is_normal() != normal) continue;
      const double moved = gap_increment(at.contacts.element(row.contact), step_)(row.row);
      follow(row.share * row.stiffness * moved, row);
    }
  };
  follow_gaps(true);
  friction_.follow(at, beds_, rows_);
  follow_gaps(false);
  return status;
}

// Leaves in `constant` what the change of the force is off share * k * change of gap (of an end on a bed what its
// opening is off), and in `length_step` by how much lengths change where the force does not.
void InteriorPasses::eliminate_lengths(double gap, double product, bool corrects, InteriorRow& row) {
  for (int i = 0; i < row.products(); ++i) {
    const auto n = static_cast<std::size_t>(i);
    const double second = corrects ? row.second_order(i) : 0;
    row.length_step[n] = (product / row.unit() - row.partner[n] * row.length[n] - second) / row.partner[n];
  }
  if (row.is_normal()) {
    const double depth = row.on_bed ? row.depth : row.force / row.stiffness;
    const double off = row.length[0] + row.length_step[0] - gap - depth;
    row.constant = row.on_bed ? off : row.share * row.stiffness * off;
    return;
  }
  const double slip = row.length[0] + row.length_step[0] - row.length[1] - row.length_step[1];
  row.constant = row.share * row.stiffness * (gap - row.force / row.stiffness - slip);
}

// The force of a row follows its gap by `along`, N per m of thickness.
void InteriorPasses::follow(double along, InteriorRow& row) {
  row.force_step = row.constant + (row.is_normal() ? -along : along);
  for (int i = 0; i < row.products(); ++i) {
    const auto n = static_cast<std::size_t>(i);
    row.length_step[n] -= row.length[n] * (row.partner_step(i) / row.partner[n] + row.capacity_step / row.unit());
  }
}

// As a share of the step, to where the first force or length vanishes.
double InteriorPasses::longest_step() const {
  double longest = 1 / kept_inside;
  const auto limit = [&](double value, double change) {
    if (change < 0) longest = std::min(longest, -value / change);
  };
  for (const InteriorRow& row : rows_) {
    for (int i = 0; i < row.products(); ++i) {
      const auto n = static_cast<std::size_t>(i);
      limit(row.length[n], row.length_step[n]);
      limit(row.partner[n], row.partner_step(i));
    }
  }
  return longest;
}

void InteriorPasses::move(double share) {
  increment_ += share * step_;
  for (InteriorRow& row : rows_) {
    if (row.is_normal()) row.force += share * row.force_step;
    const std::array<double, 2> partner_steps{row.partner_step(0), row.partner_step(1)};
    for (std::size_t n = 0; n < static_cast<std::size_t>(row.products()); ++n) {
      row.partner[n] += share * partner_steps[n];
      row.length[n] += share * row.length_step[n];
    }
  }
}

}  // namespace dda
