// Follows which blocks can touch while they move.
//
// Broad phase: boxes grown by a tenth of each block's size, or less where it is slender; the list of pairs holds until
// some block leaves its grown boxes (a Verlet list, block_bounds.h). Narrow phase: vertex-edge contacts of the listed
// pairs, see vertex_contact.h.
//
// Contacts are looked for from a share of the smaller block away. A step may move the blocks of a pair further against
// each other than that, and close a contact that it was solved without: `widen` looks for such, and from then on the
// search looks as far as that pair, or that block, needs.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "engine/contact/block_bounds.h"
#include "engine/contact/held_faces.h"
#include "engine/contact/outlines.h"
#include "engine/contact/pair_motion.h"
#include "engine/contact/vertex_contact.h"
#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

class NarrowPhase;

// What a step was solved with.
struct SeenContacts {
  std::span<const VertexContact> contacts;            // sorted
  std::span<const std::pair<int, int>> of_stretches;  // between which no others are looked for; smaller first, sorted
};

class ContactSearch {
 public:
  ContactSearch(const Model& model, const State& state);

  // Follows the blocks. Contacts are found from further away by `lift` (m), the most by which dilation holds some open.
  // Returns true when the list of pairs was made anew.
  bool update(const Model& model, const State& state, double lift = 0);

  // Contacts are chosen for what the velocities of `state` make of the next `time`, s.
  void foresee(const Model& model, const State& state, double time) { foresee_motion(model, state, time, outlines_); }

  // Blocks that are absent touch nothing from now on; `absent` says so of each.
  void leave_out(const std::vector<bool>& absent);
  // Some are no longer: they are looked for from the next update on.
  void bring_in(const std::vector<bool>& absent) {
    absent_ = absent;
    must_list_ = true;
  }

  // Vertices on these faces are no contacts from now on.
  void leave_to_stretches(HeldFaces faces) { held_ = std::move(faces); }

  // Contacts now, sorted by edge and vertex. `bonded` (sorted pairs) are left out.
  [[nodiscard]] std::vector<VertexContact> find(const std::vector<std::pair<int, int>>& bonded) const;

  // Appends the contacts of a listed pair (smaller first) as if the covers that `is_out` says so of were not there.
  void find_between(int a, int b, const std::function<bool(const VertexContact&)>& is_out,
                    std::vector<VertexContact>& found) const;

  [[nodiscard]] const std::vector<std::pair<int, int>>& pairs() const { return pairs_; }
  [[nodiscard]] const Outlines& outlines() const { return outlines_; }

  // Sizes of blocks, m: the side of the square with the area of each.
  [[nodiscard]] const std::vector<double>& sizes() const { return sizes_; }
  [[nodiscard]] double size_of(int block) const { return sizes_[static_cast<std::size_t>(block)]; }

  // A contact is found while its gap is below this share of the smaller block's size, or what `widen` made of that.
  static constexpr double reach = 0.02;

  [[nodiscard]] double smallest_size() const { return smallest_size_; }

  // At least the largest displacement (m) of any point that increments `d` make.
  [[nodiscard]] double largest_motion(const Eigen::VectorXd& d) const;

  // Looks at what increments `d` (6 a block) make of the geometry of `state`, which must be the one of the last update.
  // True when contacts that were not `seen` close in that motion: the next update and find then look far enough for it.
  bool widen(const Model& model, const State& state, const Eigen::VectorXd& d, const SeenContacts& seen);

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [outlines, sizes, growth, smallest_size, absent, lift, bounds, room, must_list, just_widened, pairs, wider,
           held] = self;
    archive(outlines, lift, bounds, held);
    archive.of_blocks(room);
    archive(must_list, just_widened);
    archive.pairs_of_blocks(pairs);
    archive(wider);
    archive.expect(wider.empty() || wider.size() == pairs.size());
    // Sizes are the drawing's; what is absent follows from the stage.
  }

 private:
  void list_pairs();
  // Appends the contacts of a listed pair; `is_out`, if any: as in find_between.
  template <typename... IsOut>
  void find_of_pair(std::size_t k, NarrowPhase& narrow, std::vector<VertexContact>& found,
                    const IsOut&... is_out) const;
  void forget_slowly();
  [[nodiscard]] bool closes(const VertexContact& contact, std::span<const MovingBox> blocks) const;
  [[nodiscard]] bool misses_contact(int a, int b, double relative, std::span<const MovingBox> blocks,
                                    const SeenContacts& seen) const;
  [[nodiscard]] bool meets_unlisted(int block, std::span<const MovingBox> blocks, std::span<const double> motion,
                                    const SeenContacts& seen) const;
  [[nodiscard]] double reach_of(std::size_t pair) const;
  [[nodiscard]] bool is_absent(std::size_t block) const { return !absent_.empty() && absent_[block]; }

  Outlines outlines_;
  std::vector<double> sizes_;
  std::vector<double> growth_;  // of the bounds of each block, m
  double smallest_size_ = 0;
  std::vector<bool> absent_;  // empty where no block is
  double lift_ = 0;
  BlockBounds bounds_;        // of the broad phase
  std::vector<double> room_;  // by how much more than usual each is grown for what moves far in a step, m
  bool must_list_ = false;    // some block needs more room than its bounds have
  bool just_widened_ = false;
  std::vector<std::pair<int, int>> pairs_;
  std::vector<double> wider_;  // of each pair: contacts are looked for from at least this far away, m
  HeldFaces held_;
};

}  // namespace dda
