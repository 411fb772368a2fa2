// Watches whether the interfaces of the start still cover all contacts of a scene with finite kinematics whose joints
// are all bonded. (Where some are not, MovingContacts finds contacts anew.)
//
// Bonded interfaces are found once, from the drawing. When blocks come to overlap elsewhere, or slide off an interface,
// the forces between them are no longer right, and the run must not go on as if nothing had happened.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/model/model.h"
#include "engine/model/state.h"
#include "engine/simulation/depth_in_thickness.h"

namespace dda {

class ContactRange {
 public:
  ContactRange() = default;  // of a scene in which nothing moves that far: it is never asked
  ContactRange(const Model& model, const std::vector<Interface>& interfaces);

  // Blocks that are absent, `absent` saying so of each, are left out from now on; `interfaces` are those of the others.
  void leave_out(const std::vector<bool>& absent, const Model& model, const std::vector<Interface>& interfaces);

  // A sentence naming the two blocks that have left their contacts, or empty. Looks closely only when some point has
  // moved farther than the skin (1 % of the least block thickness) since it last did; costs one pass over the blocks
  // otherwise. Reported are
  //   - overlap by more than 1e-3 of the thinner block's thickness, of blocks without an interface or with open ones;
  //   - an interface that is not open whose sides have slid by more than its length (a lone vertex: its distance from
  //     the corners of the edge it touches).
  [[nodiscard]] std::string problem(const Model& model, const State& state, const ContactSet& contacts);

  // As drawn.
  [[nodiscard]] LeastWidths least_widths() const { return {thickness_, least_thickness_}; }

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [radius, thickness, absent, slide_limit, of_pair, least_thickness, checked_displacement,
           checked_deformation] = self;
    archive.of_blocks(checked_displacement);
    archive.of_blocks(checked_deformation);  // the others are the drawing's
  }

 private:
  void list(const Model& model, const std::vector<Interface>& interfaces);
  [[nodiscard]] bool moved_beyond_skin(const State& state) const;
  [[nodiscard]] std::string sliding_problem(const Model& model, const State& state, const ContactSet& contacts) const;
  [[nodiscard]] std::string overlap_problem(const Model& model, const State& state, const ContactSet& contacts) const;
  [[nodiscard]] bool holds_together(int block_a, int block_b, const ContactSet& contacts) const;

  std::vector<double> radius_;       // m, farthest vertex from the centroid of each block
  std::vector<double> thickness_;    // m, area over diameter: at most the least width of a block
  std::vector<bool> absent_;         // empty where no block is
  std::vector<double> slide_limit_;  // m, of each interface
  std::vector<std::pair<std::pair<int, int>, int>> of_pair_;  // (smaller, larger block) -> interface, sorted
  double least_thickness_ = 0;
  std::vector<Vec2> checked_displacement_;  // of the centroids when last looked at
  std::vector<Mat2> checked_deformation_;
};

}  // namespace dda
