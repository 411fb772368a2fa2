// From how many contacts on work on them is shared by threads (engine/core/parallel.h).
#pragma once

#include <cstddef>

namespace dda {

// What is done to each contact, some 0.1 us and more, is worth telling another thread from twice as many on.
inline constexpr std::size_t contacts_worth_sharing = 256;

// Sums over fewer than twice as many are those of a plain loop, with the bits that results have always had.
inline constexpr std::size_t contacts_of_plain_sum = 4096;

}  // namespace dda
