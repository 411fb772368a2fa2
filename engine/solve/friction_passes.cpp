#include "engine/solve/friction_passes.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "engine/contact/contact_sharing.h"
#include "engine/contact/open_close.h"
#include "engine/contact/projected_law.h"
#include "engine/contact/rising_end.h"
#include "engine/core/parallel.h"
#include "engine/core/parallel_scatter.h"
#include "engine/core/phase_clock.h"
#include "engine/solve/largest_entry.h"
#include "engine/solve/live_contacts.h"

namespace dda {
namespace {

// An end may be off what it answers by this many times as much. (Once is too strict: where blocks just touch, ends hop
// at that level, and walls of 10,000 bricks take two thirds more passes. A hundred times saves nothing.)
constexpr double piece_tolerance = 10;

// What a local pass costs beside its part of one over all blocks.
constexpr double local_overhead = 0.05;

// When the balance has not come nearer for this many passes but is near (this share of the largest force), every other
// pass goes half its way: a few ends that drive each other in a circle fall out of step. Farther away half steps lead
// astray.
constexpr int full_passes = 3;
constexpr double near_balance = 1e-3;

// Where that does not help either, and no more contacts than these change, they do so one by one, the one that was
// pressed deepest when that began first: the others keep their pieces for the pass. That ends circles of contacts that
// change together (Murty's rule of the least index, 1974, which is sure where the problem has one solution whatever the
// load, and for any order that stays). Such a pass is allowed as much work as several: it needs as many as there are
// contacts in the circle.
constexpr int passes_before_one_by_one = 6;
constexpr int most_one_by_one = 8;
constexpr double share_of_work_one_by_one = 0.25;

// A pass is nearer to the balance than another by more than round-off, which would have its say on when those that go
// in a circle are ended, and how.
constexpr double clearly_less = 1 - 1e-6;

// Passes in which ends may open or close as they like. From then on those that keep hopping are made to slide first.
constexpr int free_passes = 4;

// A step is solved for to this share of what is out of balance, or as far as the end of the iteration needs: all the
// way when the pass before changed no piece. (1e-1 takes four times as many passes, 1e-2 a quarter more.)
constexpr double step_tolerance = 1e-3;
constexpr double last_step_margin = 0.1;

// To this share where a problem asks for one way. (In 60 dry rocks that settle, two linear solvers found answers more
// than 1e-6 of the motion apart in 19 at 1e-3, in 4 at 1e-6 and in 1 at 1e-10.)
constexpr double step_tolerance_on_one_way = 1e-10;

// Passes for what is little beside the contacts' forces, on blocks that may be light, and how well they solve. (More of
// them are for the next step of a stage that asks for balance.)
constexpr int most_passes_for_more = 5;
constexpr double all_digits = 1e-8;

// Ends of a light block's contacts are off what they answer by this many times what is asked for at most: 5 % of its
// weight where a thousandth of it is asked for.
constexpr double piece_tolerance_of_asked = 100;

constexpr int most_iterations = 400;

// Not a number where an entry is none.
double largest_imbalance(const Iterate& at, const Eigen::VectorXd& forces) {
  return largest_of_blocks(forces, at.problem->areas) + 0 * forces.sum();
}

// Takes note of what of a contact's force does not depend on the unknowns; returns its largest entry.
double note_constant(const Iterate& at, const LiveContact& contact, Vec4& constant) {
  constant = at.contacts.constant_force(contact.trial, contact.springs);
  return at.contacts[contact.trial].force.cwiseAbs().maxCoeff();
}

// Contacts of blocks that are asked for more than the others, as they are so light, are asked for more as well.
PieceRule rule_of(const LiveContact& contact, const PieceRule& rule, const Iterate& at, double largest_asked) {
  const std::span<const double> asked = at.problem->asked_balance;
  const double of_blocks =
      std::min(asked[static_cast<std::size_t>(contact.block_a)], asked[static_cast<std::size_t>(contact.block_b)]);
  if (of_blocks >= largest_asked) return rule;
  return {.strict = rule.strict,
          .negligible_force = std::min(rule.negligible_force, piece_tolerance_of_asked * of_blocks)};
}

}  // namespace

void FrictionPasses::resize(Eigen::Index unknowns) {
  if (residual_.size() == unknowns) return;
  for (Eigen::VectorXd* vector : {&residual_, &step_, &image_, &correction_}) vector->setZero(unknowns);
  gradients_.resize(unknowns);
  gmres_.resize(unknowns);
}

void FrictionPasses::take_all() {
  is_local_ = false;
  taken_.resize(live_.size());
  std::iota(taken_.begin(), taken_.end(), std::size_t{0});
}

void FrictionPasses::take_part() {
  is_local_ = true;
  taken_.clear();
  for (std::size_t k = 0; k < live_.size(); ++k)
    if (part_.contains(live_[k].block_a) || part_.contains(live_[k].block_b)) taken_.push_back(k);
}

bool FrictionPasses::has_something_to_settle(const Iterate& at) {
  const PhaseScope scope(Phase::judging);
  live_.reserve(at.contacts.size());
  constants_.reserve(at.contacts.size());
  left_.pieces.reserve(at.contacts.size());
  couplings_.reserve(at.contacts.size());
  taken_.reserve(at.contacts.size());
  list_live(at.contacts, taken_, live_);
  constants_.resize(live_.size());
  between_pieces_ = false;
  live_ones_.some_lie = std::ranges::any_of(live_, [&at](const LiveContact& contact) {
    return press_together(contact.springs, at.contacts[contact.trial].broken);
  });
  take_all();
  return !live_.empty() || !at.bolts.empty();
}

bool FrictionPasses::find_balance(Iterate& at, const Patience& most) {
  resize(at.increment.size());
  const int most_passes = std::min(most.passes, at.problem->max_passes);
  bool changed = false;
  // The whole matrix is brought up to date first: what a step does depends on the state, not on earlier round-off.
  if (at.bring_matrix_up_to_date(changed) != Status::ok) return false;
  form_residual(at);
  const std::span<const double> asked = at.problem->asked_balance;
  largest_asked_ = asked.empty() ? 0 : std::ranges::max(asked);
  nearest_.begin(imbalance_, 0);
  live_ones_.have_depths = false;
  const double rough = at.problem->goes_one_way ? step_tolerance_on_one_way : step_tolerance;
  int for_more = 0;
  for (int pass = 0; !is_balanced(at) || (for_more++ < most_passes_for_more && is_asked_for_more(at)); ++pass) {
    if (!std::isfinite(imbalance_) || pass == most_passes || nearest_.work > most.in_vain) break;
    if (pass > 0 && prepare_pass(at, changed) != Status::ok) break;
    ++at.costs.counters.open_close_iterations;
    const double enough =
        is_balanced(at) ? all_digits : last_step_margin * std::min(1.0, negligible_imbalance(at) / imbalance_);
    if (solve_newton_step(at, changed ? std::max(enough, rough) : enough) != Status::ok) break;
    const bool one_by_one = changes_one_by_one(pass - nearest_.pass);
    if (!one_by_one && goes_in_circles(pass - nearest_.pass)) step_ /= 2;
    take_step(at, {pass >= free_passes, one_by_one});
    nearest_.work += work_of_pass(at) * (one_by_one ? share_of_work_one_by_one : 1);
    if (!(imbalance_ >= clearly_less * nearest_.imbalance)) nearest_.begin(imbalance_, pass);
  }
  if (!is_balanced(at)) return false;  // one that is and was asked for more stays what it is
  if (live_.size() == at.contacts.size()) return true;
  for (std::size_t k = 0; k < at.contacts.size(); ++k)
    if (at.contacts.is_whole(k)) at.contacts.measure(k, at.increment);
  return true;
}

bool FrictionPasses::goes_in_circles(int stalled_passes) const {
  const bool is_near = imbalance_ <= near_balance * largest_force_;
  return is_near && stalled_passes > full_passes && stalled_passes % 2 == 0;
}

bool FrictionPasses::changes_one_by_one(int stalled_passes) const {
  if (stalled_passes <= passes_before_one_by_one) return false;
  return std::ranges::count_if(taken_, [this](std::size_t k) { return live_[k].changes; }) <= most_one_by_one;
}

double FrictionPasses::work_of_pass(const Iterate& at) const {
  return is_local_ ? local_overhead + part_.size() / static_cast<double>(at.problem->areas.size()) : 1;
}

bool FrictionPasses::is_balanced(const Iterate& at) const {
  return !between_pieces_ && imbalance_ <= negligible_imbalance(at);
}

// Where rock is at rest a step may begin in balance as far as its contacts' forces tell.
bool FrictionPasses::is_asked_for_more(const Iterate& at) const {
  const std::span<const double> asked = at.problem->asked_balance;
  for (std::size_t i = 0; i < asked.size(); ++i)
    if (largest_entry(residual_, i, at.problem->areas[i]) > asked[i]) return true;
  return false;
}

double FrictionPasses::negligible_imbalance(const Iterate& at) const { return at.negligible_force(largest_force_); }

// What the balance leaves at the increments reached. Where interfaces are linear the matrix gives their forces.
void FrictionPasses::form_residual(const Iterate& at) {
  const auto note_constants = [&](std::size_t first, std::size_t last) {
    double largest = 0;
    for (std::size_t i = first; i < last; ++i) largest = larger(largest, note_constant(at, live_[i], constants_[i]));
    return largest;
  };
  largest_force_ =
      larger(at.bolts.largest_force(), parallel_reduce(live_.size(), contacts_worth_sharing, larger, note_constants));
  sum_residual(at);
}

// The same where the constant forces of the contacts, and the largest force, are known.
void FrictionPasses::sum_residual(const Iterate& at) {
  residual_ = at.problem->rhs;
  const auto blocks_of_contact = [this](std::size_t i) { return std::pair(live_[i].block_a, live_[i].block_b); };
  parallel_scatter(live_.size(), at.problem->areas.size(), contacts_worth_sharing, blocks_of_contact,
                   [&](std::size_t i, bool on_a, bool on_b) {
                     if (!constants_[i].isZero(0))
                       live_[i].add_force(-at.problem->factor * constants_[i], residual_, on_a, on_b);
                   });
  at.bolts.add_rhs(at.problem->factor, residual_);
  at.matrix.couplings().move_to_right(at.problem->held, residual_);
  if (!at.increment.isZero(0)) {  // as it is where most steps begin
    at.matrix.values().multiply(at.increment, image_);
    residual_ -= image_;
  }
  at.problem->held.clear(residual_);
  imbalance_ = largest_imbalance(at, residual_);
}

// Once more for what round-off left, where that is more than what is to be left. What is not finite the imbalance
// tells.
void FrictionPasses::solve_with_factor(const Iterate& at, double relative) {
  at.matrix.solver().precondition(residual_, step_);
  multiply_in_pass(at, step_, image_);
  image_ = residual_ - image_;
  if (largest_imbalance(at, image_) <= relative * imbalance_) return;
  at.matrix.solver().precondition(image_, correction_);
  step_ += correction_;
}

Status FrictionPasses::solve_newton_step(Iterate& at, double relative) {
  const PhaseScope scope(Phase::solution);
  list_couplings(at);
  ++at.costs.counters.solves;
  const auto precondition = [&at](const Eigen::VectorXd& r, Eigen::VectorXd& z) {
    return at.matrix.solver().precondition(r, z);
  };
  KrylovResult result;
  step_.setZero();
  const bool is_symmetric = couplings_.empty() && riding_.empty();
  if (is_symmetric && at.matrix.has_its_factor()) {
    solve_with_factor(at, relative);
  } else if (is_symmetric) {
    const auto multiply = [&](const Eigen::VectorXd& v, Eigen::VectorXd& w) { multiply_in_pass(at, v, w); };
    result = gradients_.solve(multiply, precondition, residual_, relative, most_iterations, step_);
  } else {
    const auto multiply = [&](const Eigen::VectorXd& v, Eigen::VectorXd& w) { multiply_coupled(at, v, w); };
    const int most = at.problem->goes_one_way ? most_iterations : basis;
    result = gmres_.solve(multiply, precondition, residual_, relative, most, step_);
  }
  at.costs.counters.solver_iterations += result.iterations;
  // What an iteration did not reach the next pass may.
  return result.status == Status::not_converged ? Status::ok : result.status;
}

void FrictionPasses::list_couplings(const Iterate& at) {
  couplings_.clear();
  riding_.clear();
  for (const std::size_t k : taken_) {
    const LiveContact& contact = live_[k];
    if (!at.problem->dilates && std::ranges::none_of(contact.pieces, slides)) continue;
    Mat2 slopes = shear_by_normal_gap(contact.springs, at.contacts.strength(contact.trial), at.contacts[contact.trial],
                                      contact.pieces);
    if (at.problem->dilates) list_riding(at, contact, slopes);
    if (!slopes.isZero(0)) couplings_.push_back({&contact, slopes});
  }
}

// Takes ends that ride up, which have slopes of their own, out of those that friction makes of the others.
void FrictionPasses::list_riding(const Iterate& at, const LiveContact& contact, Mat2& shear_by_gap) {
  const EndStrength& strength = at.contacts.strength(contact.trial);
  const InterfaceTrial& trial = at.contacts[contact.trial];
  Riding riding{&contact, {Mat2::Zero(), Mat2::Zero()}};
  bool rides = false;
  for (int end = 0; end < ends_of(contact.springs); ++end) {
    const auto e = static_cast<std::size_t>(end);
    const ContactPiece piece = contact.pieces[e];
    const bool rises_stuck = piece == ContactPiece::stuck && trial.has_ridden(e);  // where means conserve energy
    if ((!slides(piece) && !rises_stuck) || !rides_up(contact.springs, strength, trial, end)) continue;
    riding.slopes[e] = slopes_beyond_rows(contact.springs, strength, trial, end, direction_of(piece));
    shear_by_gap.row(end).setZero();
    rides = true;
  }
  if (rides) riding_.push_back(riding);
}

void FrictionPasses::multiply_in_pass(const Iterate& at, const Eigen::VectorXd& v, Eigen::VectorXd& w) const {
  if (is_local_) {
    at.matrix.values().multiply(part_, v, w);
  } else {
    at.matrix.values().multiply(v, w);
  }
}

void FrictionPasses::multiply_coupled(const Iterate& at, const Eigen::VectorXd& v, Eigen::VectorXd& w) const {
  multiply_in_pass(at, v, w);
  for (const auto& [contact, slopes] : couplings_) {
    const Vec4 opening = contact->gap(v);
    const Vec2 shear = slopes * Vec2(opening(0), opening(2));
    contact->add_force(at.problem->factor * Vec4(0, shear(0), 0, shear(1)), w);
  }
  for (const auto& [contact, slopes] : riding_) {
    const Vec4 opening = contact->gap(v);
    Vec4 force;
    force << slopes[0] * opening.head<2>(), slopes[1] * opening.tail<2>();
    contact->add_force(at.problem->factor * force, w);
  }
  at.problem->held.clear(w);
}

// The order is that of depths in the scene, so that it does not depend on the numbering.
void FrictionPasses::order_by_depth(const Iterate& at) {
  if (!std::exchange(live_ones_.have_depths, true)) note_depths(at.contacts, live_);
  std::ranges::sort(taken_, {}, [this](std::size_t k) { return live_[k].depth; });
}

void FrictionPasses::take_whole_step(Iterate& at, const JudgedBy& judged_by) {
  const PhaseScope scope(Phase::judging);
  at.increment += step_;
  if (largest_force_ == 0) largest_force_ = largest_elastic_force(live_, at.increment);
  const PieceRule rule{.strict = judged_by.strictly, .negligible_force = piece_tolerance * negligible_imbalance(at)};
  if (judged_by.one_by_one) order_by_depth(at);
  if (is_local_) {
    multiply_in_pass(at, step_, image_);
    residual_ -= image_;
  }
  bool one_changes = false;
  std::atomic<bool> between = false;
  const bool all_are_asked_alike = at.problem->asked_balance.empty();
  const auto move_contacts = [&](std::size_t first, std::size_t last) {
    double largest = 0;
    for (std::size_t i = first; i < last; ++i) {
      LiveContact& contact = live_[taken_[i]];
      const EndStrength& strength = at.contacts.strength(contact.trial);
      InterfaceTrial& trial = at.contacts[contact.trial];
      const PieceRule own_rule = all_are_asked_alike ? rule : rule_of(contact, rule, at, largest_asked_);
      const Vec4 force_before = trial.force;
      const ContactPieces pieces_before = contact.pieces;
      // By the increments, as the balance is: what steps that went far leave of round-off in the increments, a sum of
      // gaps would have once more, and otherwise. (A stiff needle's forces were off the balance by 1e-4.)
      trial.gap = trial.start + contact.gap(at.increment);
      respond_with_friction(contact.springs, strength, trial);
      contact.between = keep_to_bordering_pieces(contact.springs, strength, own_rule, trial, contact.pieces);
      contact.changes = contact.pieces != pieces_before;
      if (judged_by.one_by_one && contact.changes && std::exchange(one_changes, true)) {
        contact.pieces = pieces_before;
        contact.between = stay_on_pieces(contact.springs, strength, own_rule, trial, contact.pieces);
      }
      if (contact.between) between.store(true, std::memory_order_relaxed);
      if (is_local_) follow_residual(at, contact, force_before);
      if (!is_local_) largest = larger(largest, note_constant(at, contact, constants_[taken_[i]]));
    }
    return largest;
  };
  // Blocks share their residual in a local pass, and contacts who may change where one does.
  const bool by_one_thread = is_local_ || judged_by.one_by_one;
  const double largest = by_one_thread ? move_contacts(0, taken_.size())
                                       : parallel_reduce(taken_.size(), contacts_worth_sharing, larger, move_contacts);
  between_pieces_ = between;
  at.bolts.aim(step_);
  at.bolts.follow(1);
  if (!is_local_) {
    largest_force_ = larger(at.bolts.largest_force(), largest);
    return sum_residual(at);
  }
  at.problem->held.clear(residual_);
  imbalance_ = largest_imbalance(at, residual_);
  if (is_balanced(at)) form_residual(at);  // what was followed is only believed while it is not the end
}

}  // namespace dda
