// The explicit step of a scene in which nothing can change, by central differences (ADR 49): one product with the
// constant stiffness, and accelerations block by block. It is stable while dt is below 2 over the largest frequency
// (stability_limit.h), which is asked before anything is run.
//
// With M a + C v + Fint(u) = F at both ends of a step,
//   d = dt v0 + dt^2/2 a0,   v1 = v0 + dt/2 (a0 + a1),   (M + dt/2 C) a1 = F1 - Fint(u0 + d) - C (v0 + dt/2 a0).
// C, of viscous edges and of damping in proportion to mass, has no part between blocks.
//
// The kinetic energy that goes with this is v- M v+/2 of the velocities half a step before and after the moment, which
// is (v M v - dt^2/4 a M a)/2: with it, and not with v M v/2, loads and dampers account for every change of energy to
// round-off.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "engine/core/status.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/inertia_solver.h"
#include "engine/simulation/linear_forces.h"
#include "engine/simulation/linear_states.h"
#include "engine/simulation/step.h"

namespace dda {

// What a step sums up over the blocks, J per m of thickness. Twice, where it says so.
struct ExplicitStepSums {
  double twice_kinetic = 0;  // v M v
  double acceleration = 0;   // a M a, W per s and m
  double strain = 0;         // of the blocks' stresses
  double elastic = 0;        // u . (K u/2 + forces at rest)
  double twice_loads = 0;    // d . (F0 + F1), and so on of what else acts
  double weight = 0;
  double twice_inertia = 0;
  double twice_radiated = 0;
  double twice_damping = 0;

  ExplicitStepSums& operator+=(const ExplicitStepSums& other);
};

class ExplicitStep : public Step {
 public:
  explicit ExplicitStep(BlockSystem& system) : system_(system), linear_(system) {}

  void set_up(BlockMatrix pattern) override;
  void begin() override;
  [[nodiscard]] Status advance(double dt, Taken taken) override;
  void end() override;
  void hand_over() override;
  void take_over() override { keep_gaps_at_rest(system_); }
  [[nodiscard]] StoredEnergy stored_energy() const override;
  [[nodiscard]] const std::string& message() const override { return message_; }

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [system, linear, solver, dashpots, place, mass_damping, dashpot_force, mass_damping_force, rhs, acceleration,
           next_acceleration, before, message] = self;
    archive(linear, dashpot_force);
    archive.of_blocks(mass_damping_force, 6);
    // The others follow from the system, or are written before they are read.
  }

 private:
  // A block with a dashpot.
  struct Dashpot {
    std::size_t block;
    Mat6 matrix;  // C
  };

  // What a step changes before it is known whether it can be taken, and that cannot be counted back.
  struct Before {
    std::vector<SupportElement> supports;
    EnergyAudit audit;
    Eigen::VectorXd dashpot_force, mass_damping_force;
  };

  [[nodiscard]] BlockMatrix inertia_in_step() const;
  void find_dashpots();
  void move();
  void move_block(std::size_t i);
  [[nodiscard]] Status solve_coupled();
  void remember();
  Status take_back(double time, Status status);
  void take_back_block(std::size_t i);
  [[nodiscard]] ExplicitStepSums balance();
  void balance_block(std::size_t i, ExplicitStepSums& sums);
  [[nodiscard]] Vec6 unbalanced_force(std::size_t i) const;
  void add_stored(std::size_t i, const Vec6& d, ExplicitStepSums& sums) const;
  [[nodiscard]] Vec6 dampers_at_half_step(std::size_t i) const;
  void take_off_dashpot(std::size_t i, const Vec6& d, Vec6& force, ExplicitStepSums& sums);
  [[nodiscard]] Vec6 take_off_mass_damping(std::size_t i, const Vec6& d, Vec6& force, ExplicitStepSums& sums);
  [[nodiscard]] bool has_dashpot(std::size_t i) const { return !place_.empty() && place_[i] >= 0; }
  void finish(const ExplicitStepSums& sums);
  void damp(ExplicitStepSums& sums);

  BlockSystem& system_;
  LinearForces linear_;
  InertiaSolver solver_;  // M + dt/2 C
  std::vector<Dashpot> dashpots_;
  std::vector<int> place_;               // of every block among them, -1 for others; empty where there are none
  double mass_damping_ = 0;              // 1/s, a of C = a M
  Eigen::VectorXd dashpot_force_;        // C v as the last balance had it, 6 entries for each of dashpots_
  Eigen::VectorXd mass_damping_force_;   // a M v as the last balance had it; empty without
  Eigen::VectorXd rhs_, acceleration_;   // of the solve where inertia couples blocks
  std::vector<Vec6> next_acceleration_;  // at the end of the step
  Before before_;
  std::string message_;
};

}  // namespace dda
