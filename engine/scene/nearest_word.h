// The known word that a misspelt one was meant to be.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace dda {

// The word of `known` nearest to `word` by insertions, deletions, replacements and swaps of neighbours, if it is near
// enough to be meant (a third of the letters of the longer one, so that names of one or two letters are meant only as
// they are but for capitals); else empty.
std::string nearest_word(std::string_view word, std::span<const std::string> known);

}  // namespace dda
