// How many bytes a block a run takes when it takes most, by what is allocated: with what the scene is read from,
// set-up, checkpoints and frames. Figures are those of the first run and a tenth more.
#include <fmt/format.h>

#include <string>
#include <string_view>

#include "engine/app/command_line_test_support.h"
#include "engine/core/allocation_counter.h"

namespace dda {
namespace {

constexpr int side = 70;

std::string bonded_rock(std::string_view blocks, std::string_view integrator, std::string_view dt) {
  return fmt::format(R"({{"dda": 1, "title": "rock",
 "materials": {{"rock": {{"density": 2650, "young": "50 GPa", "poisson": 0.25}}}},
 "joints": {{"default": {{"bonded": true}}}},
 "blocks": {},
 "loads": [{{"edge": "left", "force": ["1 MN", 0], "history": {{"sine": {{"frequency": "100 Hz"}}}}}}],
 "measurements": [{{"name": "stress", "quantity": "stress_xx", "point": [1.5, 0.5]}}],
 "steps": {{"dt": "{}", "duration": "{}", "kinematics": "small", "integrator": {}}}}})",
                     blocks, dt, dt, integrator);
}

std::string bonded_grid(std::string_view integrator) {
  const std::string blocks =
      fmt::format(R"({{"grid": {{"columns": {0}, "rows": {0}, "block_width": 1, "block_height": 1}}}})", side);
  return bonded_rock(blocks, integrator, "10 us");
}

class MemoryOfRuns : public CommandLine {
 protected:
  double most_bytes(const std::string& scene) {
    const long before = bytes_in_use();
    forget_most_bytes_in_use();
    const Outcome outcome = run_scene(scene, "results");
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    return static_cast<double>(most_bytes_in_use() - before);
  }
};

TEST_F(MemoryOfRuns, BondedGridInExplicitSteps) {
  EXPECT_LT(most_bytes(bonded_grid(R"("central_difference")")) / (side * side), 3600);
}

TEST_F(MemoryOfRuns, BondedGridInImplicitSteps) {
  EXPECT_LT(most_bytes(bonded_grid(R"({"generalized_alpha": 0.85})")) / (side * side), 4000);
}

}  // namespace
}  // namespace dda
