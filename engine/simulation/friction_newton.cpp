// The quick passes of the open-close iteration: Newton's method on the balance of a step with Coulomb friction in it.
//
// The forces of the interfaces are piecewise linear in the increments. With the pieces of the point reached, a pass
// solves (A + C) step = residual, where A is the symmetric matrix of the active rows and C lets the shear force of ends
// that slide follow their normal force. C is not symmetric, so the solver is GMRES, with what is known of the inverse
// of A as its preconditioner, and a step is only solved for as well as its pieces are likely to hold. No potential
// falls with such a step, and nothing assures that the passes end: mostly they do after a few, and where they do not,
// settle_contacts goes the sure way.
#include "engine/simulation/friction_newton.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/open_close.h"
#include "engine/simulation/simulation.h"

namespace dda {
namespace {

// The balance holds when no block is out of it by more than this share of the largest contact force: far below what a
// stress or displacement is read to.
constexpr double balance_tolerance = 1e-10;

// An end may be off what it answers by this many times as much. (Once is too strict: where blocks just touch, ends hop
// at that level, and walls of 10,000 bricks take two thirds more passes. A hundred times saves nothing.)
constexpr double piece_tolerance = 10;

// Measured on walls of 1,600 to 10,000 bricks that gravity is switched on for: where passes settle they take 5 to 20,
// and up to 60 in the first step, when all contacts start without force. Hardly any step settles that has not come
// nearer to the balance with the work of ten passes over all blocks; a local pass does its part of that, and this much
// in any case.
constexpr double patience = 10;
constexpr double local_overhead = 0.05;

// When the balance has not come nearer for this many passes but is near (this share of the largest force), every other
// pass goes half its way: a few ends that drive each other in a circle fall out of step. Farther away half steps lead
// astray.
constexpr int full_passes = 3;
constexpr double near_balance = 1e-3;

// Passes in which ends may open or close as they like. From then on those that keep hopping are made to slide first.
constexpr int free_passes = 4;

// A step is solved for to this share of what is out of balance, or as far as the end of the iteration needs: all the
// way when the pass before changed no piece. (1e-1 takes four times as many passes, 1e-2 a quarter more.)
constexpr double step_tolerance = 1e-3;
constexpr double last_step_margin = 0.1;

constexpr int most_iterations = 400;

}  // namespace

bool Simulation::newton_finds_balance() {
  FrictionNewton& n = newton_;
  bool changed = false;
  // As a whole at first: what a step does is to depend on the state alone, and not on the round-off of steps before.
  if (bring_matrix_up_to_date(true, changed) != Status::ok) return false;
  form_residual();
  const int most = stage().max_open_close_iterations;
  double best = n.imbalance;
  int best_pass = 0;
  double work = 0;  // since then, in passes over all blocks
  for (int pass = 0; !is_balanced(); ++pass) {
    if (!std::isfinite(n.imbalance) || pass == most || work > patience) return false;
    if (pass > 0 && prepare_pass(changed) != Status::ok) return false;
    ++counters_.open_close_iterations;
    const double enough = last_step_margin * std::min(1.0, negligible_imbalance() / n.imbalance);
    if (solve_newton_step(changed ? std::max(enough, step_tolerance) : enough) != Status::ok) return false;
    if (goes_in_circles(pass - best_pass)) n.step /= 2;
    take_newton_step_with_friction(pass >= free_passes);
    work += work_of_pass();
    if (n.imbalance >= best) continue;
    best = n.imbalance;
    best_pass = pass;
    work = 0;
  }
  for (std::size_t i = 0; i < trial_.size(); ++i)
    if (is_whole(contacts_.elements[i], trial_[i])) follow_whole(i);
  return true;
}

bool Simulation::goes_in_circles(int stalled_passes) const {
  const bool is_near = newton_.imbalance <= near_balance * newton_.largest_force;
  return is_near && stalled_passes > full_passes && stalled_passes % 2 == 0;
}

double Simulation::work_of_pass() const {
  const FrictionNewton& n = newton_;
  return n.is_local ? local_overhead + n.part.size() / static_cast<double>(terms_.area.size()) : 1;
}

bool Simulation::is_balanced() const { return !newton_.between_pieces && newton_.imbalance <= negligible_imbalance(); }

double Simulation::negligible_imbalance() const {
  return std::max(balance_tolerance * newton_.largest_force, round_off_of_forces());
}

// False where every interface is linear, whatever comes: one solve is then all there is to do.
bool Simulation::has_something_to_settle() {
  if (!plan_.contacts_can_change) return false;
  list_live_interfaces();
  return !newton_.live.empty() || !bolts_.empty();
}

void Simulation::list_live_interfaces() {
  FrictionNewton& n = newton_;
  n.live.clear();
  n.between_pieces = false;
  n.live.reserve(trial_.size());
  n.couplings.reserve(trial_.size());
  n.taken.reserve(trial_.size());
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    const InterfaceElement& element = contacts_.elements[i];
    if (is_whole(element, trial_[i])) continue;
    const InterfaceSprings& springs = element;
    n.live.push_back(
        {i, element.block_a, element.block_b, pieces_of(trial_[i]), false, springs, PointKinematics(element)});
  }
  n.take_all();
}

// Held blocks go all their way at once; the others start from rest. (The increments of the step before would be no
// nearer to the answer where contacts change, and of several answers that friction may have favour those that move.)
void Simulation::move_held_blocks() {
  held_.put(increment_);
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    InterfaceTrial& trial = trial_[i];
    const Vec4 moved = gap_increment(contacts_.elements[i], increment_);
    if (is_whole(contacts_.elements[i], trial) || moved.isZero(0)) continue;
    trial.gap += moved;
    respond_with_friction(contacts_.elements[i], contacts_.strengths[i], trial);
  }
  bolts_.aim(increment_);
  bolts_.follow_trials(1);
}

// What the balance leaves at the increments reached. Where interfaces are linear the matrix gives their forces.
void Simulation::form_residual() {
  FrictionNewton& n = newton_;
  n.residual = constant_rhs_;
  n.largest_force = bolts_.largest_force();
  for (const FrictionNewton::LiveContact& contact : n.live) {
    const Vec4 constant = constant_force(contact.interface, contact.springs);
    if (!constant.isZero(0)) FrictionNewton::add_force(contact, -coefficients_.stiffness * constant, n.residual);
    n.largest_force = std::max(n.largest_force, trial_[contact.interface].force.cwiseAbs().maxCoeff());
  }
  bolts_.add_rhs(coefficients_.stiffness, n.residual);
  held_.move_to_right(n.residual);
  matrix_.multiply(increment_, n.image);
  n.residual -= n.image;
  held_.clear(n.residual);
  n.imbalance = largest_entry(n.residual);
}

// Forces, and moments as forces at the arm of the block's size.
double Simulation::largest_entry(const Eigen::VectorXd& force, std::size_t block) const {
  const auto own = force.segment<6>(static_cast<Eigen::Index>(6 * block));
  const double moments = own.tail<4>().cwiseAbs().maxCoeff() / std::sqrt(terms_.area[block]);
  return std::max(own.head<2>().cwiseAbs().maxCoeff(), moments);
}

// Not a number where an entry is none.
double Simulation::largest_entry(const Eigen::VectorXd& force) const {
  double largest = 0;
  for (std::size_t i = 0; i < terms_.area.size(); ++i) largest = std::max(largest, largest_entry(force, i));
  return largest + 0 * force.sum();
}

Status Simulation::solve_newton_step(double relative) {
  FrictionNewton& n = newton_;
  const PhaseTimer timer(phase_times_.solution);
  list_couplings();
  ++counters_.solves;
  const auto precondition = [this](const Eigen::VectorXd& r, Eigen::VectorXd& z) {
    return solver_->precondition(r, z);
  };
  KrylovResult result;
  n.step.setZero();
  if (n.couplings.empty()) {
    const auto multiply = [this](const Eigen::VectorXd& v, Eigen::VectorXd& w) { multiply_in_pass(v, w); };
    result = n.gradients.solve(multiply, precondition, n.residual, relative, most_iterations, n.step);
  } else {
    const auto multiply = [this](const Eigen::VectorXd& v, Eigen::VectorXd& w) { multiply_coupled(v, w); };
    result = n.gmres.solve(multiply, precondition, n.residual, relative, most_iterations, n.step);
  }
  counters_.solver_iterations += result.iterations;
  // What an iteration did not reach the next pass may.
  return result.status == Status::not_converged ? Status::ok : result.status;
}

void Simulation::list_couplings() {
  FrictionNewton& n = newton_;
  n.couplings.clear();
  for (const std::size_t k : n.taken) {
    const FrictionNewton::LiveContact& contact = n.live[k];
    const std::size_t i = contact.interface;
    const Vec4 slopes = shear_by_normal_gap(contact.springs, contacts_.strengths[i], trial_[i], contact.pieces);
    if (!slopes.isZero(0)) n.couplings.push_back({&contact, slopes});
  }
}

void Simulation::multiply_in_pass(const Eigen::VectorXd& v, Eigen::VectorXd& w) const {
  if (newton_.is_local) {
    matrix_.multiply(newton_.part, v, w);
  } else {
    matrix_.multiply(v, w);
  }
}

void Simulation::multiply_coupled(const Eigen::VectorXd& v, Eigen::VectorXd& w) const {
  multiply_in_pass(v, w);
  for (const auto& [contact, slopes] : newton_.couplings) {
    const Vec4 gap = FrictionNewton::gap(*contact, v);
    const Vec4 shear(0, slopes(1) * gap(0), 0, slopes(3) * gap(2));
    FrictionNewton::add_force(*contact, coefficients_.stiffness * shear, w);
  }
  held_.clear(w);
}

void Simulation::take_newton_step_with_friction(bool strictly) {
  FrictionNewton& n = newton_;
  const PieceRule rule{.strict = strictly, .negligible_force = piece_tolerance * negligible_imbalance()};
  increment_ += n.step;
  if (n.is_local) {
    multiply_in_pass(n.step, n.image);
    n.residual -= n.image;
  }
  n.between_pieces = false;
  for (const std::size_t k : n.taken) {
    FrictionNewton::LiveContact& contact = n.live[k];
    const std::size_t i = contact.interface;
    InterfaceTrial& trial = trial_[i];
    const Vec4 force_before = trial.force;
    const Vec4 moved = FrictionNewton::gap(contact, n.step);
    trial.gap += moved;
    respond_with_friction(contact.springs, contacts_.strengths[i], trial);
    contact.between = keep_to_bordering_pieces(contact.springs, contacts_.strengths[i], rule, trial, contact.pieces);
    n.between_pieces = n.between_pieces || contact.between;
    if (n.is_local) follow_residual(contact, moved, force_before);
  }
  bolts_.aim(n.step);
  bolts_.follow_trials(1);
  if (n.is_local) {
    held_.clear(n.residual);
    n.imbalance = largest_entry(n.residual);
  }
  if (!n.is_local || is_balanced()) form_residual();  // what was followed is only believed while it is not the end
}

}  // namespace dda
