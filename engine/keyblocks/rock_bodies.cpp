#include "engine/keyblocks/rock_bodies.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "engine/contact/interface.h"
#include "engine/core/disjoint_sets.h"
#include "engine/geometry/segment.h"
#include "engine/model/tolerance.h"

namespace dda {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

std::vector<bool> held_blocks(const Model& model) {
  std::vector<bool> held(model.blocks.size(), false);
  for (const HeldBlock& block : model.held_blocks) held[at(block.block)] = true;
  for (const ViscousEdge& edge : model.viscous_edges) held[at(edge.block)] = true;
  for (const PointSupport& support : model.supports) {
    if (!support.partner) held[at(support.block)] = true;
  }
  return held;
}

JointFace face_of(const Interface& interface, bool first, const Model& model) {
  const JointMaterial& joint = model.joints[at(interface.joint)];
  JointFace face;
  face.block = first ? interface.block_a : interface.block_b;
  face.neighbour = first ? interface.block_b : interface.block_a;
  face.joint = interface.joint;
  face.from = first ? interface.from : interface.to;
  face.to = first ? interface.to : interface.from;
  face.outward = first ? interface.normal : Vec2(-interface.normal);
  face.tan_friction = std::tan(joint.friction_angle);
  face.cohesion_force = joint.cohesion * interface.length;
  return face;
}

// The parts of an edge, with its block on the left, along which none of `faces` runs.
void append_free_parts(const Segment& edge, int block, const std::vector<Segment>& faces, double tolerance,
                       std::vector<FreeFace>& found) {
  const double length = (edge.end - edge.start).norm();
  const Vec2 along = (edge.end - edge.start) / length;
  std::vector<std::pair<double, double>> covered{{length, length}};
  for (const Segment& face : faces) {
    if (const auto common = collinear_overlap(edge, face, tolerance))
      covered.emplace_back(along.dot(common->first - edge.start), along.dot(common->second - edge.start));
  }
  std::sort(covered.begin(), covered.end());
  double reached = 0;
  for (const auto& [from, to] : covered) {
    if (from - reached > tolerance)
      found.push_back({block, edge.start + reached * along, edge.start + from * along, {along.y(), -along.x()}});
    reached = std::max(reached, to);
  }
}

class Bodies {
 public:
  Bodies(const Model& model, const std::vector<bool>& is_void)
      : model_(model), is_void_(is_void), joined_(model.blocks.size()), faces_of_(model.blocks.size()) {
    for (const Interface& interface : find_interfaces(model)) {
      if (is_void[at(interface.block_a)] || is_void[at(interface.block_b)]) continue;
      interfaces_.push_back(interface);
      if (model.joints[at(interface.joint)].bonded) joined_.join(interface.block_a, interface.block_b);
    }
  }

  std::vector<RockBody> all() {
    gather_blocks();
    gather_joints();
    gather_free_faces();
    return std::move(bodies_);
  }

 private:
  void gather_blocks() {
    const std::vector<bool> held = held_blocks(model_);
    body_of_.assign(model_.blocks.size(), -1);
    for (int block = 0; block < static_cast<int>(model_.blocks.size()); ++block) {
      if (is_void_[at(block)]) continue;
      int& body = body_of_[at(joined_.root(block))];
      if (body < 0) {
        body = static_cast<int>(bodies_.size());
        bodies_.emplace_back();
      }
      body_of_[at(block)] = body;
      add_block(block, held[at(block)], bodies_[at(body)]);
    }
    for (RockBody& body : bodies_) body.centroid /= body.mass;
  }

  void add_block(int block, bool held, RockBody& body) const {
    const AreaMoments& moments = model_.blocks[at(block)].moments;
    body.blocks.push_back(block);
    body.surroundings = body.surroundings || held;
    body.area += moments.area;
    body.mass += model_.mass_of(block);
    body.centroid += model_.mass_of(block) * moments.centroid;  // divided by the mass when it is complete
  }

  void gather_joints() {
    for (const Interface& interface : interfaces_) {
      faces_of_[at(interface.block_a)].push_back({interface.from, interface.to});
      faces_of_[at(interface.block_b)].push_back({interface.from, interface.to});
      const int a = body_of_[at(interface.block_a)];
      const int b = body_of_[at(interface.block_b)];
      if (a == b) continue;
      bodies_[at(a)].joints.push_back(face_of(interface, true, model_));
      bodies_[at(b)].joints.push_back(face_of(interface, false, model_));
    }
  }

  void gather_free_faces() {
    const double tolerance = point_tolerance(model_);
    for (RockBody& body : bodies_) {
      for (const int block : body.blocks) {
        const Polygon& shape = model_.blocks[at(block)].shape;
        append_free_parts(shape.outer, block, tolerance, body.free_faces);
        for (const Ring& hole : shape.holes) append_free_parts(hole, block, tolerance, body.free_faces);
      }
    }
  }

  void append_free_parts(const Ring& ring, int block, double tolerance, std::vector<FreeFace>& found) const {
    for (std::size_t i = 0; i < ring.size(); ++i)
      dda::append_free_parts({ring[i], ring[(i + 1) % ring.size()]}, block, faces_of_[at(block)], tolerance, found);
  }

  const Model& model_;
  const std::vector<bool>& is_void_;
  DisjointSets joined_;                         // blocks that are one
  std::vector<Interface> interfaces_;           // without those of blocks that are taken out
  std::vector<std::vector<Segment>> faces_of_;  // where each block touches others
  std::vector<int> body_of_;
  std::vector<RockBody> bodies_;
};

}  // namespace

std::vector<RockBody> rock_bodies(const Model& model, const std::vector<bool>& is_void) {
  return Bodies(model, is_void).all();
}

}  // namespace dda
