// A vertex of one block at an edge of another. Which of them count narrow_phase.h says.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "engine/contact/outlines.h"
#include "engine/core/types.h"

namespace dda {

struct VertexContact {
  int edge_block = 0;
  int vertex_block = 0;
  int edge = 0;    // number of the edge's first vertex in Outlines
  int vertex = 0;  // number in Outlines
  Vec2 normal;     // unit, out of the edge's block
  double gap = 0;  // m, distance of the vertex from the edge's line, negative inside the edge's block

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [edge_block, vertex_block, edge, vertex, normal, gap] = self;
    archive.blocks(edge_block, vertex_block);
    archive.vertices(edge, vertex);
    archive(normal, gap);
  }

  // Orders contacts by what they are from step to step.
  [[nodiscard]] bool operator<(const VertexContact& other) const {
    return edge != other.edge ? edge < other.edge : vertex < other.vertex;
  }
};

// What finds a contact by its name in a sorted list.
inline VertexContact contact_named(int edge, int vertex) {
  VertexContact contact;
  contact.edge = edge;
  contact.vertex = vertex;
  return contact;
}

// The two blocks, the smaller index first.
inline std::pair<int, int> blocks_of(const VertexContact& contact) {
  return std::minmax(contact.edge_block, contact.vertex_block);
}

// Takes out those that `out` marks, one entry for each, without a change of order.
void take_out(const std::vector<char>& out, std::vector<VertexContact>& contacts);

// Cosine between normals that are the same from step to step, or from block to block in line: far more than a step
// turns a block.
inline constexpr double same_direction = 0.99;

// Returns which of the vertex' two edges lies more along the contact's edge: the number of that edge's first vertex.
int facing_edge(const Outlines& outlines, const VertexContact& contact);

// The end of the contact's edge that its vertex is nearer to.
int nearer_end(const Outlines& outlines, const VertexContact& contact);

// Length (m) along which the contact's edge and the facing one are beside each other; 0 where blocks meet in corners.
double common_length(const Outlines& outlines, const VertexContact& contact);

}  // namespace dda
