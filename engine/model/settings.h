// How a stage of a run is stepped: time integration, kinematics, solver.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/first_steps.h"
#include "engine/model/rock_of_stage.h"
#include "engine/model/time_function.h"

namespace dda {

// General Newmark / generalized-alpha: M a(n+1-am) + C v(n+1-af) + Fint(n+1-af) = F(n+1-af), x(n+1-a) = (1-a) x1 + a
// x0, d = dt v0 + dt^2 ((1/2 - beta) a0 + beta a1), v1 = v0 + dt ((1 - gamma) a0 + gamma a1).
struct Integrator {
  std::string name = "trapezoidal";
  double beta = 0.25;
  double gamma = 0.5;
  double alpha_m = 0;
  double alpha_f = 0;
  bool is_static = false;  // velocities are zeroed at the start of every step (Shi's static mode)

  // beta = 0: the motion of a step follows from what acts at its start, with no system to solve (ADR 49).
  [[nodiscard]] bool is_explicit() const { return beta == 0; }

  // Contacts that open or close within a step do as much work as their springs store or give back, whatever the step.
  bool conserves_contact_energy = false;
};

Integrator thesis_integrator();           // Eq. 5 of the thesis: beta = 1/2, gamma = 1, first-order numerical damping
Integrator trapezoidal_integrator();      // beta = 1/4, gamma = 1/2: second order, no damping
Integrator hht_integrator(double alpha);  // Hilber, Hughes & Taylor 1977, 0 <= alpha <= 1/3
Integrator generalized_alpha_integrator(double rho_inf);  // Chung & Hulbert 1993, 0 <= rho_inf <= 1
// The implicit midpoint rule with contact forces that conserve energy: elastic impacts give back what they took.
Integrator energy_conserving_integrator();
// Central differences, beta = 0, gamma = 1/2: second order, no damping, stable up to 2 over the largest frequency. For
// stages in which nothing can change (Model::stays_linear).
Integrator central_difference_integrator();
Integrator static_integrator();  // Eq. 5 with velocities zeroed

// What an integrator is where contacts open, close and slide. The trapezoidal rule moves as the midpoint rule does but
// carries the accelerations of earlier contact forces on: it becomes that rule, and as both damp nothing, contacts
// conserve energy. Integrators that damp stay what they are (ADR 30).
Integrator with_contacts(const Integrator& integrator);

enum class Kinematics {
  small,   // geometry stays as drawn: matrices are built once (waves in bonded rock)
  finite,  // blocks move and rotate, geometry follows
};

enum class SolverRequest { automatic, cholesky, pcg, dense, petsc };

// What becomes of a run when a static stage that asks for equilibrium ends with blocks that have none.
enum class OnUnbalanced {
  automatic,  // blocks that nothing holds end it where no stage follows, forces out of balance always
  carry_on,   // neither does
  stop,       // both do, in any stage
};

// What is excavated: blocks that are absent from the start of a stage on.
struct Removal {
  std::vector<int> blocks;
  // Factor, over the time since the start of the stage, on what these blocks exerted on the others until then, which
  // goes on acting as a load. None: that goes with the blocks, at once.
  std::optional<TimeFunction> relaxation;
};

// Rayleigh's: forces -(mass M + stiffness K) v.
struct MaterialDamping {
  double mass = 0;       // 1/s
  double stiffness = 0;  // s

  [[nodiscard]] bool acts() const { return mass != 0 || stiffness != 0; }
  // Share of critical damping of a vibration of this frequency (Hz), of angular frequency w: mass/(2 w) + stiffness
  // w/2.
  [[nodiscard]] double ratio_at(double frequency) const;
};

// Whether finish_model chooses the time step of a stage, see step_choice.h.
struct ChosenDt {
  bool automatic = false;
  std::string reason;  // why it chose that, one phrase
  FirstSteps first_steps;
};

// Whether the engine chooses between the integrator of a stage and explicit steps, see simulation/integrator_choice.h.
struct ChosenIntegrator {
  bool automatic = false;
  std::string reason;  // why it chose that, one phrase; empty where explicit steps are out of the question
};

struct ChosenByEngine {
  ChosenDt dt;
  ChosenIntegrator integrator;
};

// How much is tried before a step is given up.
struct StepEffort {
  int open_close_iterations = 200;
  int step_reductions = 6;  // halvings of dt tried when the open-close iteration does not converge
};

struct Stage {
  std::string name = "run";
  double dt = 0;        // s; 0: a static stage that finds its own steps, see paces_itself()
  double duration = 0;  // s; may be 0 where the stage paces itself
  Integrator integrator;
  ChosenByEngine chosen;
  Kinematics kinematics = Kinematics::finite;
  SolverRequest solver = SolverRequest::automatic;

  double velocity_factor = 1;  // k01: velocities are multiplied by it at the end of every step (depends on dt!)
  double damping_rate = 0;     // 1/s: velocities are multiplied by exp(-damping_rate dt) at the ends of steps

  MaterialDamping material_damping;  // in dynamic stages of scenes in which nothing can change

  // Factor on the inertia of the strains. 1 is consistent (exact) inertia; 2 averages consistent and lumped inertia,
  // which removes the leading dispersion of a chain of bonded blocks and leaves rigid motion exact.
  double strain_inertia = 1;

  // Inertia between neighbours that consistent joints hold, which makes up for the blocks' size (ADR 24). See
  // Model::with_acting_corrections() for where it acts.
  bool correct_block_dispersion = false;

  // Lowers the inertia between neighbours by what the integrator's period error adds at this dt, so that waves keep
  // their speed to fourth order in dt (ADR 6, 24). Acts where the other does.
  bool correct_time_dispersion = false;

  // False: the blocks of cubic chains contract sideways without inertia, as in the elementary theory of bars (waves of
  // every length then run at sqrt(E/rho)). True: with it, as a strip of finite width does (Love's bar).
  bool lateral_inertia = true;

  // Static stages: the stage has done its work, and ends, when the forces out of balance are below this share of the
  // largest force that acts (simulation/equilibrium.h); 0 runs all of its steps and does not ask.
  double equilibrium = 0;
  OnUnbalanced on_unbalanced = OnUnbalanced::automatic;

  // Contacts that are closed do not slide and joints do not break: for turning on gravity. What exceeds the friction
  // when such a stage ends slides then.
  bool unlimited_strength = false;

  Removal removal;
  RockOfStage rock;

  StepEffort limits;

  // A static stage without dt takes as many steps, and as long ones, as equilibrium needs. Loads and prescribed motions
  // are those of its end from its first step on; the clock goes there when it is over.
  [[nodiscard]] bool paces_itself() const { return dt == 0; }
  // How many steps there are; 0 where that is not known before.
  [[nodiscard]] std::int64_t steps() const;
  // The length of a step (counted from 0) of a stage that does not pace itself, and how long after the start of the
  // stage it begins, in s.
  [[nodiscard]] double dt_of(std::int64_t step) const;
  [[nodiscard]] double time_of(std::int64_t step) const;
  // By how much the clock goes on in the stage, s: its duration, rounded to whole steps.
  [[nodiscard]] double length() const { return paces_itself() ? duration : time_of(steps()); }
  [[nodiscard]] double shortest_dt() const { return chosen.dt.first_steps.grow() ? chosen.dt.first_steps.dt : dt; }
};

}  // namespace dda
