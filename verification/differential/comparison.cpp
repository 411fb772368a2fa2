#include "verification/differential/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/parallel.h"
#include "engine/geometry/cut_pieces.h"
#include "engine/scene/scene.h"
#include "engine/simulation/snapshot.h"

namespace verify {
namespace {

using dda::Model;
using dda::Simulation;
using dda::SolverRequest;
using dda::Status;

constexpr double agreement = 1e-9;
constexpr double margin = 100;  // over what small changes do
constexpr double settled =
    1e-6;  // an open-close iteration that has settled has forces to 1e-9, and impacts multiply that

struct End {
  Status status = Status::ok;
  std::int64_t steps = 0;
  dda::State state;
};

Model with_solver(Model model, SolverRequest solver) {
  for (dda::Stage& stage : model.stages) stage.solver = solver;
  return model;
}

Model stiffer(Model model, double share) {
  for (dda::Material& material : model.materials) material.young *= 1 + share;
  return model;
}

// All that loads and weight put on the rock, N per m of thickness.
double all_loads(const Model& model) {
  double sum = 0;
  for (const dda::Block& block : model.blocks)
    sum +=
        model.gravity.norm() * model.materials[static_cast<std::size_t>(block.material)].density * block.moments.area;
  for (const dda::PointLoad& load : model.point_loads) sum += load.force.norm();
  for (const dda::EdgeLoad& load : model.edge_loads) sum += load.traction.norm() * (load.to - load.from).norm();
  return sum;
}

// With what conjugate gradients leave of a system that they have solved: this share of its loads on every block, in
// directions by lot.
Model pushed(Model model, double share, std::uint64_t seed) {
  dda::SeededNumbers random(seed);
  const double force = share * all_loads(model);
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const double direction = random.number(0, 2 * std::numbers::pi);
    const dda::Vec2 push = force * dda::Vec2(std::cos(direction), std::sin(direction));
    model.point_loads.push_back({static_cast<int>(i), model.blocks[i].moments.centroid, push, dda::Constant{}});
  }
  return model;
}

End go_on(Simulation& simulation) {
  End end;
  while (!simulation.finished() && end.status == Status::ok) end.status = simulation.step();
  end.steps = simulation.state().step;
  end.state = simulation.state();
  return end;
}

End run(const Model& model) {
  Simulation simulation(model);
  return go_on(simulation);
}

// Stops after `steps` steps and goes on in another simulation.
End run_with_a_stop(const Model& model, std::int64_t steps) {
  Simulation first(model);
  for (std::int64_t i = 0; i < steps && !first.finished(); ++i)
    if (first.step() != Status::ok) break;
  Simulation second(model);
  dda::restore(second, first.state(), dda::save(first));
  return go_on(second);
}

template <typename Values>
double largest(const Values& values) {
  double largest = std::numeric_limits<double>::min();
  for (const auto& value : values) largest = std::max(largest, value.norm());
  return largest;
}

template <typename Values>
double largest_difference(const Values& a, const Values& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (const double apart = (a[i] - b[i]).norm(); !(apart <= most)) most = apart;
  return most;
}

// Largest differences over largest values. Blocks that have come to rest still move by what a solver leaves of the way
// they went before: velocities are compared with that way over the time, where they are less.
double difference(const dda::State& a, const dda::State& b) {
  const double way = largest(a.displacement);
  return std::max({largest_difference(a.displacement, b.displacement) / way,
                   largest_difference(a.velocity, b.velocity) / std::max(largest(a.velocity), way / a.time),
                   largest_difference(a.stress, b.stress) / largest(a.stress)});
}

double difference(const End& a, const End& b) { return difference(a.state, b.state); }

bool ends_alike(const End& a, const End& b) { return a.status == b.status && a.steps == b.steps; }

template <typename Values>
bool same_bits(const Values& a, const Values& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(typename Values::value_type)) == 0);
}

bool same_bits(const End& a, const End& b) {
  return ends_alike(a, b) && same_bits(a.state.displacement, b.state.displacement) &&
         same_bits(a.state.velocity, b.state.velocity) && same_bits(a.state.stress, b.state.stress);
}

// How far runs of nearly the same rock end from each other; infinite where one of them ends in another way. The most of
// ten: of three it was short by a factor of up to two.
double sensitivity(const Model& model, const End& end) {
  double most = 0;
  for (const double share : {1e-13, -2e-13, 3e-13, -4e-13, 5e-13, -6e-13, 7e-13, -8e-13, 9e-13, -1e-12}) {
    const End other = run(stiffer(model, share));
    if (!ends_alike(other, end)) return std::numeric_limits<double>::infinity();
    most = std::max(most, difference(other, end));
  }
  return most;
}

// The same of a solver that iterates, where its balance is off by what it leaves. What is soft beside the rest follows
// that by far more than it changes with the stiffness of all rock.
double sensitivity_to_pushes(const Model& model, const End& end) {
  constexpr double left = 1e-11;  // of the loads: the true residual, see PcgSettings::relative_residual
  double most = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const End other = run(pushed(model, left, seed));
    if (ends_alike(other, end)) most = std::max(most, difference(other, end));
  }
  return most;
}

bool has_friction(const Model& model) {
  return std::ranges::any_of(model.joints,
                             [](const dda::JointMaterial& joint) { return !joint.bonded && joint.friction_angle > 0; });
}

// Open, sliding and sticking alike.
bool same_contacts(const Simulation& a, const Simulation& b) {
  return std::ranges::equal(a.contacts().states, b.contacts().states, [](const auto& state, const auto& other) {
    return std::ranges::equal(state.status, other.status);
  });
}

// The step in which the two part, as a sentence, where their iterations have gone different ways by then; else nothing.
std::string parting(const Model& a, const Model& b) {
  Simulation first(a), second(b);
  while (!first.finished() && !second.finished()) {
    const bool go_on = first.step() == Status::ok && second.step() == Status::ok;
    if (go_on && difference(first.state(), second.state()) <= agreement) continue;
    const auto first_passes = first.counters().open_close_iterations;
    const auto second_passes = second.counters().open_close_iterations;
    if (first_passes == second_passes && same_contacts(first, second)) return "";
    return fmt::format("they part in step {}, after {} and {} passes", first.state().step, first_passes, second_passes);
  }
  return "";
}

// Why another solver ends elsewhere.
Comparison explain(const Model& model, const End& end, const Model& other, const End& other_end,
                   const std::string& name) {
  const double apart =
      ends_alike(end, other_end) ? difference(end, other_end) : std::numeric_limits<double>::infinity();
  double explained = margin * std::max(sensitivity(model, end), sensitivity(other, other_end));
  if (name == "pcg" && apart > explained) explained = std::max(explained, margin * sensitivity_to_pushes(model, end));
  const std::string what =
      fmt::format("{} ends {} after {} steps, cholesky {} after {}, {:.2g} apart; round-off explains {:.2g}", name,
                  to_string(other_end.status), other_end.steps, to_string(end.status), end.steps, apart, explained);
  if (apart <= explained) return {Agreement::sensitive, what};
  const std::string way = has_friction(model) || apart <= settled ? parting(model, other) : "";
  if (!way.empty()) return {Agreement::other_way, what + "; " + way};
  return {Agreement::differs, what};
}

std::optional<Comparison> compare_solvers(const Model& model, const End& end) {
  for (const auto& [solver, name] : {std::pair{SolverRequest::pcg, "pcg"}, std::pair{SolverRequest::dense, "dense"}}) {
    const Model other = with_solver(model, solver);
    const End other_end = run(other);
    if (!ends_alike(end, other_end) || !(difference(end, other_end) <= agreement))
      return explain(model, end, other, other_end, name);
  }
  return std::nullopt;
}

Comparison compare(const Model& model) {
  const End end = run(model);
  const std::int64_t half = end.steps / 2;
  if (!same_bits(run_with_a_stop(model, half), end))
    return {Agreement::differs, fmt::format("another end after a stop at step {} of {}", half, end.steps)};
  {
    const dda::ThreadsInUse two(2);
    if (!same_bits(run(model), end)) return {Agreement::differs, "another end with two threads"};
  }
  if (const auto solvers = compare_solvers(model, end)) return *solvers;
  if (end.status != Status::ok && end.status != Status::finished)
    return {Agreement::stopped, std::string(to_string(end.status))};
  return {};
}

}  // namespace

std::string name_of(Agreement found) {
  switch (found) {
    case Agreement::agreed: return "agreed";
    case Agreement::stopped: return "stopped alike";
    case Agreement::refused: return "refused";
    case Agreement::sensitive: return "sensitive to round-off";
    case Agreement::other_way: return "went another way";
    case Agreement::differs: return "differs";
  }
  return "";
}

Comparison compare_runs(const nlohmann::ordered_json& scene) {
  try {
    return compare(with_solver(dda::parse_scene(scene.dump(), "scene.json"), SolverRequest::cholesky));
  } catch (const dda::InputError& error) {
    return {Agreement::refused, error.what()};
  }
}

}  // namespace verify
