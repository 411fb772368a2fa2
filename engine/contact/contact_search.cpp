#include "engine/contact/contact_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/geometry/box_pairs.h"

namespace dda {
namespace {

constexpr double growth = 0.1;      // of a block's size, on every side of its box
constexpr double deepest = 0.1;     // of the smaller size: a vertex further inside has not come in through this edge
constexpr double round_off = 1e-9;  // of the smaller size: gaps and places on edges nearer than this are the same

bool contains(const Box& outer, const Box& inner) {
  return (inner.lower.array() >= outer.lower.array()).all() && (inner.upper.array() <= outer.upper.array()).all();
}

}  // namespace

ContactSearch::ContactSearch(const Model& model, const State& state) : outlines_(make_outlines(model, state)) {
  for (const Block& block : model.blocks) sizes_.push_back(std::sqrt(block.moments.area));
  list_pairs();
}

void ContactSearch::list_pairs() {
  grown_.resize(outlines_.boxes.size());
  for (std::size_t i = 0; i < grown_.size(); ++i) grown_[i] = expanded(outlines_.boxes[i], growth * sizes_[i] + lift_);
  pairs_ = overlapping_pairs(grown_);
}

bool ContactSearch::update(const Model& model, const State& state, double lift) {
  lift_ = lift;
  update_outlines(model, state, outlines_);
  for (std::size_t i = 0; i < grown_.size(); ++i) {
    if (contains(grown_[i], expanded(outlines_.boxes[i], reach * sizes_[i] + lift_))) continue;
    list_pairs();
    return true;
  }
  return false;
}

std::vector<VertexContact> ContactSearch::find(const std::vector<std::pair<int, int>>& bonded) const {
  std::vector<VertexContact> found;
  for (const auto& pair : pairs_) {
    if (std::binary_search(bonded.begin(), bonded.end(), pair)) continue;
    const double smaller = std::min(size_of(pair.first), size_of(pair.second));
    find_vertex_contacts(outlines_, pair.first, pair.second, reach * smaller + lift_, deepest * smaller,
                         round_off * smaller, found);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace dda
