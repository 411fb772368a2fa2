// Follows which blocks can touch while they move.
//
// Broad phase: boxes grown by a tenth of each block's size; the list of pairs holds until some block leaves its grown
// box (a Verlet list). Narrow phase: vertex-edge contacts of the listed pairs, see vertex_contact.h.
#pragma once

#include <utility>
#include <vector>

#include "engine/contact/outlines.h"
#include "engine/contact/vertex_contact.h"
#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

class ContactSearch {
 public:
  ContactSearch(const Model& model, const State& state);

  // Follows the blocks. Contacts are found from further away by `lift` (m), the most by which dilation holds some open.
  // Returns true when the list of pairs was made anew.
  bool update(const Model& model, const State& state, double lift = 0);

  // Contacts now, sorted by edge and vertex. `bonded` (sorted pairs) are left out.
  [[nodiscard]] std::vector<VertexContact> find(const std::vector<std::pair<int, int>>& bonded) const;

  [[nodiscard]] const std::vector<std::pair<int, int>>& pairs() const { return pairs_; }
  [[nodiscard]] const Outlines& outlines() const { return outlines_; }

  // Sizes of blocks, m: the side of the square with the area of each.
  [[nodiscard]] const std::vector<double>& sizes() const { return sizes_; }
  [[nodiscard]] double size_of(int block) const { return sizes_[static_cast<std::size_t>(block)]; }

  // A contact is found while its gap is below this share of the smaller block's size, so no point may move by more than
  // half of that in one step.
  static constexpr double reach = 0.02;

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [outlines, sizes, lift, grown, pairs] = self;
    archive.each(grown);
    archive(pairs);  // sizes are the drawing's; outlines and lift are brought up to date before they are read
  }

 private:
  void list_pairs();

  Outlines outlines_;
  std::vector<double> sizes_;
  double lift_ = 0;
  std::vector<Box> grown_;  // boxes of the broad phase
  std::vector<std::pair<int, int>> pairs_;
};

}  // namespace dda
