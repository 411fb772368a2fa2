// Ends of dilating joints that have slid back and have not come down by it yet (contact/rising_end.h).
#pragma once

namespace dda {

struct BlockSystem;

// Whether some closed end is to come down by so much that forces change by more than a static stage leaves out of
// balance. Until it has, the stage is not over, though all is in balance.
bool owes_height(const BlockSystem& system);

}  // namespace dda
