#include "engine/contact/acting_frame.h"

#include <cmath>
#include <cstddef>

#include "engine/contact/interface_frame.h"
#include "engine/geometry/segment.h"

namespace dda {
namespace {

// Places and directions are the same when they differ by less than this share of an edge, or this angle: far more than
// round-off, and far less than what turns a result.
constexpr double same = 1e-9;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

struct PointAndNormal {
  Vec2 point;   // m
  Vec2 normal;  // unit, out of the edge's block
};

Vec2 vertex_in(const Model& model, const State& acting, const Outlines& outlines, int block, int vertex) {
  return local_position(model, acting, block,
                        model.blocks[at(block)].moments.centroid + outlines.reference[at(vertex)]);
}

Vec2 normal_in(const State& acting, const Outlines& outlines, int block, int edge) {
  const Vec2 drawn = outlines.reference[at(outlines.next[at(edge)])] - outlines.reference[at(edge)];
  const Vec2 along = acting.deformation[at(block)] * drawn;
  return Vec2(along.y(), -along.x()).normalized();
}

// The end of the contact's edge above which its vertex is, or -1.
int corner_at(const Outlines& outlines, const VertexContact& contact) {
  const Vec2 along = outlines.along(contact.edge);
  const double place = (outlines.current[at(contact.vertex)] - outlines.current[at(contact.edge)]).dot(along);
  const double near = same * along.squaredNorm();
  if (std::abs(place) <= near) return contact.edge;
  return std::abs(place - along.squaredNorm()) <= near ? outlines.next[at(contact.edge)] : -1;
}

bool lie_on_each_other(const Vec2& along, const Vec2& other) {
  return std::abs(cross(along, other)) <= same * along.norm() * other.norm();
}

PointAndNormal acting_at(const Model& model, const State& acting, const Outlines& outlines,
                         const VertexContact& contact) {
  PointAndNormal own{vertex_in(model, acting, outlines, contact.vertex_block, contact.vertex),
                     normal_in(acting, outlines, contact.edge_block, contact.edge)};
  const int corner = corner_at(outlines, contact);
  if (corner < 0) return own;
  const int facing = facing_edge(outlines, contact);
  if (!lie_on_each_other(outlines.along(contact.edge), outlines.along(facing))) return own;
  const Vec2 point = vertex_in(model, acting, outlines, contact.edge_block, corner);
  const Vec2 normal = -normal_in(acting, outlines, contact.vertex_block, facing);
  return {(own.point + point) / 2, (own.normal + normal).normalized()};
}

}  // namespace

InterfaceFrame acting_frame(const Model& model, const State& acting, const Outlines& outlines,
                            const VertexContact& contact) {
  const auto [point, normal] = acting_at(model, acting, outlines, contact);
  return {point,
          point,
          point,
          point,
          normal,
          local_centroid(model, acting, contact.edge_block),
          local_centroid(model, acting, contact.vertex_block)};
}

}  // namespace dda
