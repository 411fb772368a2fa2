// Runs a model: scene facts in, states out.
//
//   Simulation simulation(model);
//   while (!simulation.finished() && simulation.step() == Status::ok) use(simulation.state());
//
// A simulation says which stage is under way and which dt is next: a step that does not converge is retried in halves.
// What a step does is GeneralStep's, LinearStep's or ExplicitStep's; the state only ever holds converged steps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/core/counters.h"
#include "engine/core/status.h"
#include "engine/model/energy.h"
#include "engine/model/model.h"
#include "engine/model/state.h"
#include "engine/simulation/acceleration_memory.h"
#include "engine/simulation/bolt_set.h"
#include "engine/simulation/lining_set.h"
#include "engine/simulation/penetration.h"
#include "engine/simulation/settling_pace.h"
#include "engine/simulation/stage_results.h"
#include "engine/simulation/step_plan.h"
#include "engine/simulation/support_set.h"

namespace dda {

struct BlockSystem;
class ExplicitStep;
class GeneralStep;
class LinearStep;
class Step;

class Simulation {
 public:
  // The model must be finished (finish_model). Throws InputError (without a file) where it has no stage, or explicit
  // steps are longer than is stable.
  explicit Simulation(Model model);
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;
  ~Simulation();

  // Advances by one time step of the current stage, and on to the next stage after the last step of one. Anything but
  // ok leaves the state at the last converged moment; message() says why. When finished() it does nothing and returns
  // Status::finished.
  [[nodiscard]] Status step();

  [[nodiscard]] bool finished() const;
  [[nodiscard]] const std::string& message() const { return message_; }

  [[nodiscard]] const Model& model() const;
  [[nodiscard]] const State& state() const;
  [[nodiscard]] const ContactSet& contacts() const;
  // True where contacts are looked for anew as blocks move: their list then changes from step to step.
  [[nodiscard]] bool follows_contacts() const;
  // The state of one interface now. (In a linear scene it is not kept from step to step but computed here.)
  [[nodiscard]] InterfaceState interface_state(std::size_t index) const;
  // The columns beside free-field sides, stepped along; nullptr where there are none.
  [[nodiscard]] const Simulation* free_field_columns() const;
  // Says of every block whether it is absent now, removed or not added yet; empty while none is.
  [[nodiscard]] const std::vector<bool>& absent() const;
  [[nodiscard]] const BoltSet& bolts() const;
  [[nodiscard]] const StepPlan& plan() const;
  [[nodiscard]] const EnergyLedger& energy() const;
  [[nodiscard]] Counters counters() const;
  // The deepest of steps with contacts that can change; of stages that pace themselves of their ends.
  [[nodiscard]] const Penetration& deepest_penetration() const;

  // The longest dt with which a stage of explicit steps is stable, s; 0 for other stages.
  [[nodiscard]] double stability_limit(std::size_t stage) const;

  // Largest unbalanced force of any unknown in the last step, internal against external without inertia, divided by the
  // largest load, weight or in-situ force on an interface: what is left on the way to static equilibrium.
  [[nodiscard]] double out_of_balance() const;

  // What the stages that are over have left.
  [[nodiscard]] const StageResults& results() const { return results_; }

  // Says whom to call at the end of stages.
  [[nodiscard]] StageWatch& watch() { return watch_; }

  // True within a static stage that paces itself: its steps take no time, and its state means nothing before its end.
  [[nodiscard]] bool is_settling() const;

  // The whole system, for what reads forces from it.
  [[nodiscard]] const BlockSystem& system() const { return *system_; }

  // See snapshot.h, whose functions call these.
  [[nodiscard]] std::vector<std::byte> save() const;
  void restore(State state, std::span<const std::byte> snapshot);

  // See branch.h, whose functions call this.
  void go_on_from(const Simulation& settled);

 private:
  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive);

  [[nodiscard]] Step& stage_step();
  void begin_stage();
  [[nodiscard]] Status advance(double dt, int reductions_left);
  [[nodiscard]] bool is_over();
  [[nodiscard]] Status end_stage();

  std::unique_ptr<BlockSystem> system_;
  std::unique_ptr<GeneralStep> general_;
  std::unique_ptr<LinearStep> linear_;
  std::unique_ptr<ExplicitStep> explicit_;
  std::string message_;
  SettlingPace pace_;  // of a stage that paces itself
  StageResults results_;
  std::vector<double> stability_limits_;  // s, one a stage, 0 where steps are implicit
  double in_situ_force_ = 0;              // N per m of thickness, the largest on an interface
  AccelerationMemory memory_;             // within a step that is cut
  StageWatch watch_;
};

}  // namespace dda
