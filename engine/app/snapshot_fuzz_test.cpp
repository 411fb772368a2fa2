// Checkpoints that are damaged behind their checksum: what a simulation keeps is taken over and gone on with, or
// refused in one sentence.
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/fuzz_support.h"
#include "engine/scene/scene.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/snapshot.h"

namespace dda {
namespace {

// What is taken over is gone on with in one of so many inputs: steps take four times as long as taking over.
constexpr std::size_t gone_on_with = 8;
constexpr int steps_after = 3;

// A pile in which joints break, slide and open, a lining and a bolt hold, and one stone is taken out.
constexpr auto moving = R"({"dda": 1, "gravity": 9.81,
  "materials": {"rock": {"density": 2600, "young": "1 GPa", "poisson": 0.2}},
  "joints": {"default": {"friction_angle": "30 deg"},
             "mortar": {"friction_angle": "30 deg", "cohesion": "2 kPa", "tensile_strength": "1 kPa",
                        "residual_friction_angle": "25 deg", "dilation_angle": "5 deg"}},
  "joint_pairs": [{"between": ["left", "middle"], "joint": "mortar"}],
  "blocks": [{"polygon": {"name": "left", "vertices": [[0, 0], [1, 0], [1, 1], [0, 1]]}},
             {"polygon": {"name": "middle", "vertices": [[1, 0], [2, 0], [2, 1], [1, 1]]}},
             {"polygon": {"name": "right", "vertices": [[2, 0], [3, 0], [3, 1], [2, 1]]}},
             {"polygon": {"name": "low", "vertices": [[0.8, -0.5], [2.1, -0.5], [2.1, 0], [0.8, 0]]}},
             {"polygon": {"name": "stone", "vertices": [[1.2, 1.01], [2.2, 1.1], [1.9, 1.8]], "initial_velocity": [1, 0]}}],
  "fixed": ["left"],
  "supports": [{"point": [3, 0.5], "block": "right", "displacement": [1e-4, 0], "history": {"sine": {"frequency": 10}}}],
  "bolts": [{"from": [0.5, 0.9], "to": [1.5, 0.9], "stiffness": "10 MN/m", "yield_force": "1 kN"}],
  "linings": [{"name": "shotcrete", "along": [[1, 1], [3, 1]], "thickness": "10 cm", "young": "15 GPa",
               "compressive_strength": "20 MPa", "tensile_strength": "2 MPa"}],
  "steps": [{"name": "a", "integrator": "static", "dt": "10 ms", "duration": "0.1 s"},
            {"name": "b", "dt": "1 ms", "duration": "0.1 s", "remove": ["low"]}]})";

// Small motion of bonded and projected joints between absorbing edges.
constexpr auto small = R"({"dda": 1,
  "materials": {"rock": {"density": 2600, "young": "10 GPa", "poisson": 0.2}},
  "joints": {"default": {"bonded": true}, "joint": {"law": "projected", "friction_angle": "20 deg"}},
  "joint_pairs": [{"between": ["upper", "lower"], "joint": "joint"}],
  "blocks": [{"grid": {"name": "lower", "origin": [0, 0], "columns": 3, "rows": 2, "block_width": 1, "block_height": 1,
                       "initial_stress": {"xx": "-1 MPa", "yy": "-1 MPa"}}},
             {"grid": {"name": "upper", "origin": [0, 2], "columns": 3, "rows": 2, "block_width": 1, "block_height": 1,
                       "initial_stress": {"xx": "-1 MPa", "yy": "-1 MPa"}}}],
  "viscous_boundaries": [{"edge": "bottom"}],
  "loads": [{"edge": "top", "traction": [0, "-1 MPa"], "history": {"sine": {"frequency": "500 Hz"}}}],
  "steps": {"dt": "50 us", "duration": "5 ms", "kinematics": "small"}})";

std::vector<std::byte> state_of(const Simulation& simulation) {
  std::vector<std::byte> bytes;
  visit_memory(simulation.state(), [&](const void* memory, std::size_t count) {
    const auto* first = static_cast<const std::byte*>(memory);
    bytes.insert(bytes.end(), first, first + count);
  });
  return bytes;
}

// All that a checkpoint holds, as text for the mutator: the state, and what a snapshot keeps behind it.
class Saved {
 public:
  Saved(const char* scene, int steps) : model_(parse_scene(scene, "scene.json")) {
    Simulation simulation(model_);
    for (int i = 0; i < steps; ++i) EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
    const std::vector<std::byte> state = state_of(simulation), snapshot = save(simulation);
    state_bytes_ = state.size();
    bytes_.assign(reinterpret_cast<const char*>(state.data()), state.size());
    bytes_.append(reinterpret_cast<const char*>(snapshot.data()), snapshot.size());
  }

  void read(Mutator& mutator) const {
    const std::string bytes = mutator.memory(bytes_);
    if (bytes.size() < state_bytes_) throw InputError("", "checkpoint", "cut off", "a whole state");
    Simulation simulation(model_);
    State state = simulation.state();
    std::size_t offset = 0;
    visit_memory(state, [&](void* to, std::size_t count) {
      if (count > 0) std::memcpy(to, bytes.data() + offset, count);
      offset += count;
    });
    restore(simulation, std::move(state), std::as_bytes(std::span(bytes)).subspan(offset));
    if (!mutator.one_in(gone_on_with)) return;
    for (int i = 0; i < steps_after && !simulation.finished(); ++i)
      if (simulation.step() != Status::ok) break;
  }

 private:
  Model model_;
  std::size_t state_bytes_ = 0;
  std::string bytes_;
};

TEST(SnapshotFuzz, OfBlocksThatMove) {
  for (const int steps : {5, 15, 40}) {
    const Saved saved(moving, steps);
    expect_both(fuzz({.inputs = 600}, [&](Mutator& mutator) { saved.read(mutator); }));
  }
}

TEST(SnapshotFuzz, OfSmallMotion) {
  const Saved saved(small, 30);
  expect_both(fuzz({.inputs = 600}, [&](Mutator& mutator) { saved.read(mutator); }));
}

}  // namespace
}  // namespace dda
