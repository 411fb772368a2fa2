// What cutting the rock of a scene did that its author may not have meant.
#pragma once

#include <string>
#include <vector>

#include "engine/scene/read_rock.h"

namespace dda {

// Blocks whose extents differ by more than this factor are called slender: joints around them see next to nothing of
// their width, and steps are short for them.
inline constexpr double slender_aspect = 10;

// "3 x dangling end trimmed, 1 x sliver merged"; empty where nothing was cleaned.
std::string cleaned_in_words(const std::vector<const CutRock*>& rocks);

// Sentences, without a full stop: what was cleaned, how much was dropped, how many blocks are slender and where the
// most slender one is, and what the drawing and the cutting remarked themselves.
std::vector<std::string> cut_remarks(const Rock& rock, const CutRock& cut);

}  // namespace dda
