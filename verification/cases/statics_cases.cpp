#include "verification/cases/statics_cases.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/simulation/simulation.h"
#include "verification/cases/bar_case.h"
#include "verification/exact/wave_speeds.h"
#include "verification/harness/histories.h"
#include "verification/harness/recorded_run.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

using dda::InterfaceLaw;
using dda::Vec2;

constexpr double young = 5e9;
constexpr double density = 2600;

// A column of blocks 1 m wide that stands on y = 0.
dda::Model column(int blocks, double height, InterfaceLaw law, const dda::Material& rock) {
  dda::Model model;
  model.materials = {rock};
  dda::JointMaterial joint;
  joint.law = law;
  joint.bonded = true;
  model.joints = {joint};
  for (int i = 0; i < blocks; ++i) {
    const double bottom = height * i / blocks;
    const double top = height * (i + 1) / blocks;
    model.blocks.emplace_back().shape.outer = {{0, bottom}, {1, bottom}, {1, top}, {0, top}};
  }
  dda::Stage stage;
  stage.integrator = dda::static_integrator();
  stage.kinematics = dda::Kinematics::small;
  stage.dt = 10;  // inertia is then 1e-8 of the stiffness: what a static step leaves out of balance
  stage.duration = 40 * stage.dt;
  stage.solver = dda::SolverRequest::cholesky;
  model.stages = {stage};
  return model;
}

struct Settled {
  dda::Model model;
  dda::State state;
};

// Throws if it does not come to rest.
Settled settle(dda::Model model, dda::Counters& counters) {
  dda::finish_model(model);
  dda::Simulation simulation(model);
  advance_to_end(simulation);
  counters += simulation.counters();
  if (!(simulation.out_of_balance() < 1e-9))
    throw std::runtime_error(fmt::format("out of balance by {:g}, not below 1e-9", simulation.out_of_balance()));
  return {std::move(model), simulation.state()};
}

constexpr double pressure = 1e6;  // Pa

// Compressed between two equal pressures, held nowhere.
dda::Model compressed(int blocks, double height, InterfaceLaw law, const dda::Material& rock) {
  dda::Model model = column(blocks, height, law, rock);
  model.edge_loads = {{blocks - 1, {1, height}, {0, height}, {0, -pressure}, {}},
                      {0, {0, 0}, {1, 0}, {0, pressure}, {}}};
  return model;
}

constexpr double static_error = 1e-8;
constexpr auto static_reason = "statics to 1e-9 (out of balance) and a solve of condition 1e4";

// The assertion of largest error among several of one quantity.
class Worst {
 public:
  explicit Worst(Assertion first) : worst_(std::move(first)) {}
  void add(double value, double reference, double error) {
    if (std::isnan(worst_.error) || std::abs(error) <= std::abs(worst_.error)) return;
    worst_.value = value;
    worst_.reference = reference;
    worst_.error = error;
  }
  [[nodiscard]] const Assertion& assertion() const { return worst_; }

 private:
  Assertion worst_;
};

// Largest errors over all blocks of the runs with one block and with four.
struct CompressionErrors {
  double ratio = 0, axial = 0, lateral = 0;  // lateral: stress over the axial one
};

double lateral_ratio(const Settled& settled, std::size_t block) {
  const dda::Vec6& displacement = settled.state.displacement[block];
  return -displacement(3) / displacement(4);
}

void compress(InterfaceLaw law, double poisson, dda::PlaneState plane, CompressionErrors& largest, Outcome& outcome) {
  const bool stress = plane == dda::PlaneState::stress;
  const double expected =
      stress ? exact::lateral_ratio_plane_stress(poisson) : exact::lateral_ratio_plane_strain(poisson);
  double ratio = 0;
  for (const int blocks : {1, 4}) {
    const Settled settled =
        settle(compressed(blocks, 4, law, {"rock", density, young, poisson, plane}), outcome.counters);
    for (std::size_t i = 0; i < settled.state.stress.size(); ++i) {
      ratio = lateral_ratio(settled, i);
      keep_largest(largest.ratio, ratio - expected);
      keep_largest(largest.axial, relative_error(settled.state.stress[i](1), -pressure));
      keep_largest(largest.lateral, settled.state.stress[i](0) / pressure);
    }
  }
  outcome.assertions.push_back(expect(fmt::format("lateral ratio of the last of 4 blocks, nu = {}, plane {}", poisson,
                                                  stress ? "stress" : "strain"),
                                      "")
                                   .is(ratio)
                                   .against(expected, stress ? "nu" : "nu/(1 - nu)")
                                   .within(static_error, static_reason));
}

Outcome uniaxial_compression(InterfaceLaw law) {
  Outcome outcome;
  CompressionErrors largest;
  for (const double poisson : {0.1, 0.25, 0.4})
    for (const dda::PlaneState plane : {dda::PlaneState::stress, dda::PlaneState::strain})
      compress(law, poisson, plane, largest, outcome);
  const auto add = [&](const char* quantity, double error, const char* source) {
    outcome.assertions.push_back(
        expect(quantity, "").is(error).against(0, source).absolutely().within(static_error, static_reason));
  };
  add("lateral ratio of every block, largest error", largest.ratio, "nu, nu/(1 - nu)");
  add("axial stress of every block, largest relative error", largest.axial, "the load");
  add("lateral stress of every block over the axial, largest", largest.lateral, "no load sideways");
  return outcome;
}

double shortening(const Settled& settled, double height) {
  const int last = static_cast<int>(settled.model.blocks.size()) - 1;
  return dda::point_displacement(settled.model, settled.state, 0, {0.5, 0}).y() -
         dda::point_displacement(settled.model, settled.state, last, {0.5, height}).y();
}

Outcome stack_stiffness() {
  constexpr double height = 6;
  Outcome outcome;
  for (const double spring : {1.0, 10.0, 100.0}) {
    for (const int blocks : {1, 2, 6, 12}) {
      dda::Model model =
          compressed(blocks, height, InterfaceLaw::classical, {"rock", density, young, 0.25, dda::PlaneState::stress});
      model.joints[0].spring_over_young = spring;
      const double modulus = pressure * height / shortening(settle(std::move(model), outcome.counters), height);
      const double expected = exact::stack_modulus(young, height / blocks, 1, 2 * spring * young, blocks);
      outcome.assertions.push_back(expect(fmt::format("modulus, n = {} blocks, springs of {} E", blocks, spring), "Pa")
                                       .is(modulus)
                                       .against(expected, "E/(1 + E A (n - 1)/(k L n)), k of both springs")
                                       .within(static_error, static_reason));
    }
  }
  for (const InterfaceLaw law : {InterfaceLaw::consistent, InterfaceLaw::cubic}) {
    const Settled settled =
        settle(compressed(6, height, law, {"rock", density, young, 0.25, dda::PlaneState::stress}), outcome.counters);
    const double modulus = pressure * height / shortening(settled, height);
    outcome.assertions.push_back(expect(fmt::format("modulus, 6 blocks, {} joints", name_of(law)), "Pa")
                                     .is(modulus)
                                     .against(young, "E: such joints add no compliance")
                                     .within(static_error, static_reason));
  }
  return outcome;
}

constexpr double column_height = 8;
constexpr double base_stiffness = 4e12;  // N/m, both corners together

dda::Model standing(int blocks, InterfaceLaw law, double poisson) {
  dda::Model model = column(blocks, column_height, law, {"rock", density, young, poisson, dda::PlaneState::stress});
  model.gravity = {0, -9.81};
  model.supports = {{0, {0, 0}, false, true, base_stiffness / 2, Vec2::Zero(), {}},
                    {0, {1, 0}, false, true, base_stiffness / 2, Vec2::Zero(), {}},
                    {0, {0.5, 0}, true, false, base_stiffness, Vec2::Zero(), {}}};
  return model;
}

double top_settlement(const Settled& settled) {
  const int last = static_cast<int>(settled.model.blocks.size()) - 1;
  return -dda::point_displacement(settled.model, settled.state, last, {0.5, column_height}).y();
}

const double whole_weight = exact::self_weight_pressure(density, 9.81, column_height, 0);  // Pa, at the base

double exact_pressure(const Settled& settled, std::size_t block) {
  return exact::self_weight_pressure(density, 9.81, column_height, settled.model.blocks[block].moments.centroid.y());
}

Assertion stress_at_centroids(InterfaceLaw law, double poisson, dda::Counters& counters) {
  // A classical block's stress is the mean of the forces on its ends: exact. With Nitsche's method and lateral
  // contraction the jumps of the lateral strain leave gaps of their own, below a hundredth of a block's weight.
  const bool exactly = law == InterfaceLaw::classical || poisson == 0;
  const Settled settled = settle(standing(8, law, poisson), counters);
  double largest = 0;
  for (std::size_t i = 0; i < 8; ++i)
    keep_largest(largest, (settled.state.stress[i](1) + exact_pressure(settled, i)) / whole_weight);
  return expect(fmt::format("stress at the centroids, largest error, of the stress at the base, {}, nu = {}",
                            name_of(law), poisson),
                "")
      .is(largest)
      .against(0, "-rho g (H - y)")
      .absolutely()
      .within(exactly ? static_error : 0.01 / 8,
              exactly ? static_reason : "jumps of the lateral strain: below 1 % of the weight of one block in 8");
}

// The outer halves of the end blocks are straight lines whose weight acts in their middle: the stress of the end blocks
// is off by part of a block's weight, and the error dies out from block to block. The chain answers a strain at its end
// with sqrt(2)/6 of a half block's stiffness, the half block itself with the share of its strain (chain_end.h).
void add_cubic_column(Outcome& outcome) {
  const Settled settled = settle(standing(12, InterfaceLaw::cubic, 0.25), outcome.counters);
  const auto end_error = [&](std::size_t block, double share) {
    const double measured =
        std::abs(settled.state.stress[block](1) + exact_pressure(settled, block)) / (whole_weight / 12);
    const double expected = (share - 0.5) / (share + std::numbers::sqrt2 / 6) / 2;
    outcome.assertions.push_back(
        expect(fmt::format("stress of the {} block of a cubic column, off by this part of a block's weight",
                           block == 0 ? "lowest" : "highest"),
               "")
            .is(measured)
            .against(expected, "(s - 1/2)/(2 s + sqrt(2)/3), s = 1 where held, else (10 - sqrt(2))/12")
            .within(1e-7, "other end twelve blocks away: 6e-10; round-off: measured 3e-9"));
  };
  end_error(0, 1);
  end_error(11, (10 - std::numbers::sqrt2) / 12);
  const double first = std::abs(settled.state.stress[0](1) + exact_pressure(settled, 0));
  double largest_ratio = 0;
  double previous = first;
  for (std::size_t i = 1; i < 6; ++i) {
    const double error = std::abs(settled.state.stress[i](1) + exact_pressure(settled, i));
    keep_largest(largest_ratio, error / previous);
    previous = error;
  }
  outcome.assertions.push_back(expect("that of the lowest from block to block, largest ratio", "")
                                   .is(largest_ratio)
                                   .against(0, "-rho g (H - y)")
                                   .absolutely()
                                   .within(0.2, "dies out by a factor of 6; measured"));
}

Outcome column_stress() {
  Outcome outcome;
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent})
    for (const double poisson : {0.0, 0.25})
      outcome.assertions.push_back(stress_at_centroids(law, poisson, outcome.counters));
  add_cubic_column(outcome);
  return outcome;
}

Outcome column_settlement() {
  Outcome outcome;
  const double continuum = exact::self_weight_shortening(young, density, 9.81, column_height);
  const double base = whole_weight / base_stiffness;
  for (const int blocks : {1, 4, 8, 16}) {
    const double length = column_height / blocks;
    const double springs = exact::block_column_shortening(young, density, 9.81, length, 1, blocks, 20 * young, false);
    for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent}) {
      const bool classical = law == InterfaceLaw::classical;
      const double expected = base + (classical ? springs : continuum);
      const double settlement = top_settlement(settle(standing(blocks, law, 0), outcome.counters));
      outcome.assertions.push_back(
          expect(
              fmt::format("settlement of the top (error of rho g H^2/(2E)), n = {} blocks, {}", blocks, name_of(law)),
              "m")
              .is(settlement)
              .against(expected,
                       classical ? "rho g H^2/(2E) and the springs' shares, on the sprung base"
                                 : "rho g H^2/(2E) on the sprung base: blocks with the exact stress at their centroids")
              .off_by((settlement - expected) / continuum)
              .within(static_error, static_reason));
    }
  }
  return outcome;
}

// Largest error of the displacement, against rho g (H y - y^2/2)/E of the continuum on its sprung base, at the middles
// and ends of the blocks.
double displacement_error(int blocks, dda::Counters& counters) {
  const Settled settled = settle(standing(blocks, InterfaceLaw::consistent, 0), counters);
  double worst = 0;
  for (int i = 0; i < blocks; ++i) {
    for (const double part : {0.0, 0.5, 1.0}) {
      const double y = column_height * (i + part) / blocks;
      const double expected =
          density * 9.81 * ((column_height * y - y * y / 2) / young + column_height / base_stiffness);
      const double actual = -dda::point_displacement(settled.model, settled.state, i, {0.5, y}).y();
      keep_largest(worst, actual - expected);
    }
  }
  return worst;
}

Outcome column_displacement() {
  Outcome outcome;
  const double coarse = displacement_error(8, outcome.counters);
  const double fine = displacement_error(16, outcome.counters);
  const double expected = density * 9.81 * 0.25 / (8 * young);
  outcome.assertions = {{"largest error of the displacement, 16 blocks", "m", fine, expected,
                         "a straight line through a parabola, and nothing else: rho g L^2/(8 E)",
                         relative_error(fine, expected), 1e-3,
                         "the displacement is good to 1e-8 and 2000 times as large: 2e-5, with margin",
                         Order{order(coarse, fine), 2, 1e-3}}};
  return outcome;
}

}  // namespace

std::vector<Case> statics_cases() {
  std::vector<Case> cases;
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent, InterfaceLaw::cubic})
    cases.push_back({"uniaxial-compression-" + name_of(law),
                     "Blocks under pressure from both sides, " + name_of(law) + " joints",
                     {24},
                     CaseLabel::fast,
                     [law] { return uniaxial_compression(law); }});
  cases.push_back(
      {"stack-stiffness", "Stiffness of stacks of one to twelve blocks", {25}, CaseLabel::fast, stack_stiffness});
  cases.push_back(
      {"self-weight-stress", "Stress in a column under its own weight", {26}, CaseLabel::fast, column_stress});
  cases.push_back({"self-weight-settlement",
                   "Settlement of a column under its own weight",
                   {26},
                   CaseLabel::fast,
                   column_settlement});
  cases.push_back({"self-weight-displacement",
                   "Displacement inside the blocks of a column under its own weight",
                   {26},
                   CaseLabel::fast,
                   column_displacement});
  return cases;
}

}  // namespace verify
