// Narrow phase: which vertices of one block touch, or nearly touch, which edges of another.
//
// Edge-edge contact is two vertex-edge contacts, one at each end of the common stretch. A vertex enters through an edge
// when both its own edges leave that edge's line on the outer side (up to `entrance_slack`): a reflex corner never
// enters, and a corner that meets another corner enters through the edge that keeps both wedges apart. A vertex inside
// a block has come in through the edge nearest to it, or, in a notch, through both. Where two corners meet, only one
// contact is made: the one with the least penetration.
#pragma once

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

  // Identity from step to step.
  [[nodiscard]] bool operator<(const VertexContact& other) const {
    return edge != other.edge ? edge < other.edge : vertex < other.vertex;
  }
};

// Cosine between normals that are the same from step to step, or from block to block in line: far more than a step
// turns a block.
inline constexpr double same_direction = 0.99;

// Of the vertex' own two edges the one that lies more along the contact's edge: the number of its first vertex.
int facing_edge(const Outlines& outlines, const VertexContact& contact);

// Length (m) along which the contact's edge and the facing one are beside each other; 0 where blocks meet in corners.
double common_length(const Outlines& outlines, const VertexContact& contact);

// Sine of the angle by which a vertex' own edges may dip below the edge it rests on: contacts of blocks that lie flat
// on each other rock within it.
inline constexpr double entrance_slack = 0.05;

// Contacts between blocks `a` and `b` with gaps from -`depth` to `reach` (m). A vertex nearer than `corner` (m), along
// an edge, to the edge's end meets the corner there.
void find_vertex_contacts(const Outlines& outlines, int a, int b, double reach, double depth, double corner,
                          std::vector<VertexContact>& found);

}  // namespace dda
