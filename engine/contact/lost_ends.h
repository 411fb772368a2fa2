// What stretches of joints carry when vertex contacts take their place, and who of these goes on with it.
//
// An end goes to the contacts where it was, in equal parts where there are several (a vertex of both blocks in one
// place makes two). Within a face whose stiffness goes by length there may be none: such an end is divided between the
// contacts beside it on both sides by the lever rule. Where a joint bends by a few degrees the face that goes on with
// an end may be the other one, and the force keeps its direction in the plane. So force and moment on both blocks are
// as they were.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "engine/contact/interface.h"
#include "engine/contact/interface_state.h"
#include "engine/core/types.h"

namespace dda {

// An end of a stretch, in place of which there will be vertex contacts.
struct StretchEnd {
  int block_a = 0, block_b = 0;
  Vec2 place;            // m, as drawn
  Vec2 along;            // unit, of the stretch, as drawn
  Vec2 normal;           // unit, now, from a into b
  InterfaceState state;  // of its first end

  [[nodiscard]] std::pair<int, int> pair() const { return std::minmax(block_a, block_b); }
};

class LostEnds {
 public:
  void add(const StretchEnd& end) { ends_.push_back(end); }
  void clear() { ends_.clear(); }
  [[nodiscard]] bool empty() const { return ends_.empty(); }

  // The state that each of the vertex contacts `heirs` goes on with, none where no end comes to it. Points within
  // `tolerance` (m) are one.
  [[nodiscard]] std::vector<std::optional<InterfaceState>> shared_among(const std::vector<Interface>& heirs,
                                                                        double tolerance) const;

 private:
  std::vector<StretchEnd> ends_;
};

}  // namespace dda
