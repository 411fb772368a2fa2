// Blocks that a stage takes away, and blocks that it brings.
//
// An absent block is held where it was, without mass, weight, stress and contacts, so that steps know of nothing new:
// the present blocks are what is left of the system. What it had stored, alone and in its contacts, leaves the ledger
// as `removed`. A block that comes in brings nothing into the ledger: it is at rest, free of stress, and its contacts
// begin without force (join_blocks.h).
#pragma once

#include <memory>

namespace dda {

struct BlockSystem;
class GeneralStep;

// Where blocks are absent, takes back that they are, to the first moment of a run, and begins to follow contacts anew:
// those of the drawing. A system that is to be at another stage has others absent than at its first one.
void draw_all(BlockSystem& system, std::unique_ptr<GeneralStep>& general);

// Takes the blocks that are absent in the stage under way out of a system of which they were a part until now.
void leave_out_absent(BlockSystem& system, GeneralStep& general);

// At the start of a stage: removes the blocks that it takes away. Where they are to let go slowly, what they exerted
// on the others goes on as a load that fades.
void excavate(BlockSystem& system, GeneralStep& general);

// At the start of a stage: what it adds comes in, as drawn.
void bring_in(BlockSystem& system, GeneralStep& general);

}  // namespace dda
