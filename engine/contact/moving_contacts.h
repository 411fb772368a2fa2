// Keeps a ContactSet in step with blocks that move: dry contacts are vertex-edge contacts found anew as geometry
// changes, with their history; joints with strength stay the stretches they were found as until both ends of all
// between their two blocks are broken, and those of the projected law until their blocks have parted. Where blocks can
// touch elsewhere these stay beside vertex contacts of the same blocks (held_faces.h).
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "engine/contact/contact_search.h"
#include "engine/contact/contact_set.h"
#include "engine/contact/covered_corners.h"
#include "engine/contact/ending_stretches.h"
#include "engine/contact/join_blocks.h"
#include "engine/contact/lost_ends.h"
#include "engine/contact/succession.h"
#include "engine/contact/surface_joints.h"
#include "engine/contact/vertex_contact.h"
#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

class MovingContacts {
 public:
  // Takes dry stretches and lone vertices out of `contacts` and finds the vertex-edge contacts of the start.
  MovingContacts(const Model& model, const State& state, ContactSet& contacts);

  // Brings `contacts` to the current geometry. Known contacts keep status, shear and slip; normal gaps are measured.
  // Arms and directions of forces are those in `acting`, where the blocks are when the forces act. `ahead` (s) is how
  // far the motion is foreseen, for which contacts at corners are chosen. Returns true when the list of pairs that can
  // touch changed.
  bool follow(const Model& model, const State& state, const State& acting, double ahead, ContactSet& contacts);
  bool follow(const Model& model, const State& state, ContactSet& contacts) {
    return follow(model, state, state, 0, contacts);
  }

  // Ends the stretches of the projected law whose blocks have parted, which takes some of the blocks' stresses
  // (projected_stretch.h). To be called before `follow`, which has the contacts that take their place, and ends no
  // stretches itself where there are some of that law.
  void let_part(const Model& model, State& state, ContactSet& contacts);

  // How many there are that have not gone over to contacts of vertices.
  [[nodiscard]] std::size_t stretches() const { return stretches_; }

  // Takes out the contacts of blocks that are absent, which touch nothing from now on.
  void leave_out(const std::vector<bool>& absent, ContactSet& contacts);

  // Blocks come in, whose contacts begin without force. Joints with strength hold them, and dry ones of the projected
  // law are stretches, where their neighbours are still near what was drawn; elsewhere they count as broken.
  void bring_in(const Model& model, const State& state, const ComingBlocks& blocks, ContactSet& contacts);

  // True when increments `d` from `state` close contacts that lay further away than was looked for, or move blocks into
  // each other at corners that a third block covered: the next `follow` looks far enough and has those.
  bool widen(const Model& model, const State& state, const ContactSet& contacts, const Eigen::VectorXd& d);

  // Pairs of blocks that can touch before the next change of the list.
  [[nodiscard]] const std::vector<std::pair<int, int>>& pairs() const { return search_.pairs(); }

  // How many contacts it knows, in the order of the ContactSet.
  [[nodiscard]] std::size_t known_contacts() const { return stretches_ + known_.size(); }

  [[nodiscard]] double size_of(int block) const { return search_.size_of(block); }

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [search, surfaces, ending, lost_ends, stretches, known, stiffness_before, states_before, covered,
           of_stretches, uncovered] = self;
    // Surfaces and shapes are the drawing's; no end is lost between steps; what springs and states were is asked within
    // a search.
    archive(search, stretches, known, covered);
    archive.pairs_of_blocks(of_stretches);
    archive.pairs_of_blocks(uncovered);
  }

 private:
  void keep_ends(const Model& model, const State& state, const ContactSet& contacts, bool dry_ones,
                 const std::vector<char>& ends);
  void drop_stretches(const std::vector<char>& ends, ContactSet& contacts);
  void end_stretches(const Model& model, const State& state, bool dry_ones, ContactSet& contacts);
  // Vertex contacts that a search has found.
  struct FoundContacts {
    std::vector<VertexContact> contacts;
    std::vector<double> shares;  // of the faces that they are ends of, m
    std::vector<bool> of_faces;  // those with a share of the stiffness of a face
  };
  // What one of them goes on with: indices among the known contacts, or -1, and what ends of stretches leave to it, or
  // null.
  struct Heritage {
    std::ptrdiff_t earlier = -1, beside = -1;
    const InterfaceState* from_stretch = nullptr;
  };

  void refresh(const Model& model, const State& state, const State& acting, ContactSet& contacts);
  void begin_anew(const Model& model, const std::vector<bool>& comes_in, ContactSet& contacts) const;
  void look_beside(const Model& model, const ContactSet& contacts);
  std::vector<Carrier> follow_stretches(const Model& model, const State& state, const State& acting,
                                        ContactSet& contacts) const;
  [[nodiscard]] FoundContacts with_shares(const Model& model, std::vector<VertexContact> found) const;
  [[nodiscard]] std::vector<Heritage> heritage_of(const FoundContacts& all,
                                                  const std::vector<std::optional<InterfaceState>>& left,
                                                  const ContactSet& contacts, Succession& succession) const;
  void take_in(const Model& model, const State& acting, const FoundContacts& all, const std::vector<Heritage>& heritage,
               ContactSet& contacts);
  [[nodiscard]] InterfaceState state_of(const JointMaterial& joint, const InterfaceElement& element,
                                        const VertexContact& contact, const Heritage& heritage) const;
  void forget_corners_apart(const std::vector<VertexContact>& found);
  [[nodiscard]] Interface interface_of(const Model& model, const VertexContact& contact, double share) const;
  [[nodiscard]] std::vector<std::optional<InterfaceState>> left_by_stretches(
      const Model& model, const std::vector<VertexContact>& found, const std::vector<std::ptrdiff_t>& earlier) const;

  ContactSearch search_;
  SurfaceJoints surfaces_;
  EndingStretches ending_;
  LostEnds lost_ends_;                             // between the loss of a stretch and the next search
  std::size_t stretches_ = 0;                      // leading entries of the ContactSet that are joints with strength
  std::vector<VertexContact> known_;               // the others, in the same order
  std::vector<Vec2> stiffness_before_;             // of their springs at the search before, normal and shear
  std::vector<InterfaceState> states_before_;      // theirs at the search before
  std::vector<VertexContact> covered_;             // what the last search has taken out
  std::vector<std::pair<int, int>> of_stretches_;  // the last search's, between which it looked for nothing else
  std::vector<std::pair<int, int>> uncovered_;  // blocks whose corners are contacts all the same; smaller first, sorted
};

}  // namespace dda
