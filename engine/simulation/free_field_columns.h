// The columns beside free-field sides, as a model of their own: every block along a side once more, as a rectangle of
// the same height, material and initial stress, joined as along the side and standing on the same base. Both sides of
// each block are tied, so that a column deforms in one dimension: nothing in it depends on x.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/model/model.h"

namespace dda {

struct FreeFieldColumns {
  Model model;                    // finished; with the stages of the whole and without measurements
  std::vector<int> blocks;        // in it, of the viscous edges of all sides, one after the other
  std::vector<std::size_t> ties;  // and the first of the two supports that tie the sides of each
};

// `contacts` of the drawn model (make_contacts) say which joint lies between two blocks, and which law it has there.
// Cubic joints become consistent ones: the cubic law is that of a bar whose sides are free.
FreeFieldColumns make_free_field_columns(const Model& model, const ContactSet& contacts);

}  // namespace dda
