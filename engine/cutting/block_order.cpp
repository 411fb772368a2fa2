#include "engine/cutting/block_order.h"

#include <algorithm>
#include <tuple>

namespace dda {
namespace {

bool comes_first(const Vec2& a, const Vec2& b) { return std::tuple(a.x(), a.y()) < std::tuple(b.x(), b.y()); }

void start_at_leftmost(Ring& ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), comes_first), ring.end());
}

}  // namespace

void put_in_order(std::vector<CutBlock>& blocks) {
  for (CutBlock& block : blocks) {
    start_at_leftmost(block.shape.outer);
    for (Ring& hole : block.shape.holes) start_at_leftmost(hole);
    std::sort(block.shape.holes.begin(), block.shape.holes.end(),
              [](const Ring& a, const Ring& b) { return comes_first(a.front(), b.front()); });
  }
  std::sort(blocks.begin(), blocks.end(), [](const CutBlock& a, const CutBlock& b) {
    return std::lexicographical_compare(a.shape.outer.begin(), a.shape.outer.end(), b.shape.outer.begin(),
                                        b.shape.outer.end(), comes_first);
  });
}

}  // namespace dda
