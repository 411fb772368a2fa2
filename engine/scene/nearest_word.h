// The known word that a misspelt one was meant to be.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace dda {

// The word of `known` nearest to `word` by insertions, deletions, replacements and swaps of neighbours, if it is near
// enough to be meant (a third of its letters); else empty.
std::string nearest_word(std::string_view word, std::span<const std::string> known);

}  // namespace dda
