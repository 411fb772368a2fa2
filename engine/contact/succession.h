// Which known contact a contact that the search has found goes on with, from one search to the next.
//
// A contact that is not known by its name may be so under another: a vertex went over to the next edge in line, of its
// own block or of another one, or of two corners above each other the other one now is the vertex. (Exchanging the
// blocks turns normal and gap both, so the state stays as it is.)
//
// A corner that slides from one block on to the next leaves the first one's corner behind it, above its own edge. Where
// contacts are springs of their own the load goes on with the corner that moves, or it would stay behind with springs
// that soon have nothing to carry, and the block would sink deeper at every joint. Where they share the stiffness of a
// face, the one that stays behind goes on with its share.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "engine/contact/interface_state.h"
#include "engine/contact/outlines.h"
#include "engine/contact/vertex_contact.h"

namespace dda {

class Succession {
 public:
  // `known`: sorted. `of_faces`: of each that was found, whether it has a share of the stiffness of a face.
  Succession(const std::vector<VertexContact>& known, const std::vector<VertexContact>& found,
             const std::vector<bool>& of_faces, const Outlines& outlines);

  // Says for each that was found the index of the known one that it continues, or -1. Each is continued once.
  [[nodiscard]] const std::vector<std::ptrdiff_t>& earlier() const { return earlier_; }

  // Two corners that face each other can be two contacts: the vertex of one on the edge of the other, and the other way
  // round. Where one of them has ended, returns its index among the known ones for the one that goes on; -1: there is
  // none. Each is given once.
  [[nodiscard]] std::ptrdiff_t ended_beside(const VertexContact& contact);

  // Returns the known contact nearest to a new one of those in line with it, at its face or the facing one; -1 where
  // there is none. Of several in one place one between the same blocks, else the one that presses least
  // in `states`, those of the known contacts.
  [[nodiscard]] std::ptrdiff_t beside(const VertexContact& contact, std::span<const InterfaceState> states);

 private:
  using Rule = std::ptrdiff_t (Succession::*)(const VertexContact&);

  void continue_by(Rule rule, const std::vector<VertexContact>& found);
  std::ptrdiff_t same(const VertexContact& contact);
  std::ptrdiff_t next_edge(const VertexContact& contact);
  std::ptrdiff_t exchanged(const VertexContact& contact);
  [[nodiscard]] bool has_left(const VertexContact& known) const;
  std::ptrdiff_t gone_over_a_joint(const VertexContact& contact);
  std::ptrdiff_t over_a_joint(const VertexContact& contact);
  std::ptrdiff_t back_over_a_joint(const VertexContact& contact);
  // Takes the first of the same vertex, in the same direction, that meets the condition.
  template <typename Condition>
  std::ptrdiff_t of_vertex(const VertexContact& contact, Condition condition);
  template <typename Act>
  void for_each_at(int vertex, Act act);
  template <typename Act>
  void for_each_on(int edge, Act act) const;
  void list_by_vertex();
  // A known contact in line with a new one.
  struct InLine {
    std::size_t index;
    double distance;  // m
    bool same_blocks;
  };
  [[nodiscard]] std::vector<InLine> in_line_with(const VertexContact& contact);
  std::ptrdiff_t take(int edge, int vertex, const Vec2& normal);
  std::ptrdiff_t take(std::vector<VertexContact>::const_iterator place, const Vec2& normal);

  const std::vector<VertexContact>& known_;
  const Outlines& outlines_;
  std::vector<bool> taken_;
  bool some_have_ended_ = false;
  std::vector<std::ptrdiff_t> earlier_;
  std::vector<std::pair<int, std::size_t>> by_vertex_;  // vertex and index of the known contacts, when asked for
};

}  // namespace dda
