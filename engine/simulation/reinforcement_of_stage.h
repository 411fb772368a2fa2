// Bolts and linings that a stage begins with and without.
#pragma once

namespace dda {

struct BlockSystem;
class GeneralStep;

// Those whose last stage is over give up what they exerted, at once or as a load that fades. What they had stored goes
// with who takes them out.
void take_out_reinforcement(BlockSystem& system);

// Those of the stage that begins. Who tensions bolts does work; linings carry nothing yet.
void put_in_reinforcement(const GeneralStep& general, BlockSystem& system);

}  // namespace dda
