// Which stretches vertex contacts take the place of.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/contact/held_faces.h"
#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

class EndingStretches {
 public:
  explicit EndingStretches(const Model& model);

  // One entry for each of the first `stretches` contacts, 1 where it ends: dry ones and lone vertices at the start
  // (`dry_ones`), later those broken at both ends; projected ones when they have parted. The stretches of a pair end
  // together, since no vertex contacts are looked for between blocks that have one; but for those of blocks that can
  // touch elsewhere, beside whose faces contacts are looked for.
  [[nodiscard]] std::vector<char> find(const Model& model, const State& state, const ContactSet& contacts,
                                       std::size_t stretches, bool dry_ones) const;

  // The faces of stretches that stay by themselves, between whose blocks other contacts are looked for.
  [[nodiscard]] std::vector<HeldFace> held_faces(const Model& model, const ContactSet& contacts,
                                                 std::size_t stretches) const;

 private:
  // What a stretch says of its pair of blocks; a firm one decides alone.
  struct Hold {
    bool firm = false;    // a bond, not broken at both ends
    bool closed = false;  // of the projected law, and its blocks have not parted
    bool parted = false;  // of the projected law, and they have
  };

  [[nodiscard]] Hold hold_of(const Model& model, const State& state, const ContactSet& contacts, std::size_t stretch,
                             bool dry_ones) const;
  [[nodiscard]] bool touch_there_alone(const Model& model, const Interface& interface) const;
  [[nodiscard]] std::vector<char> decide(const Model& model, const ContactSet& contacts,
                                         const std::vector<Hold>& holds) const;

  std::vector<char> is_convex_;  // blocks, as drawn
};

}  // namespace dda
