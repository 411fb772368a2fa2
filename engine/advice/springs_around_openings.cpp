#include "engine/advice/springs_around_openings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>

#include "engine/advice/projected_offer.h"
#include "engine/contact/contact_set.h"
#include "engine/contact/joint_stiffness.h"
#include "engine/contact/make_contacts.h"
#include "engine/geometry/segment.h"
#include "engine/model/moving_stages.h"

namespace dda {
namespace {

constexpr double softest = 0.5;    // compliance of springs over that of blocks, beyond which they lock little
constexpr double parallel = 0.05;  // sine of the angle between faces that count as one direction

std::size_t at(int index) { return static_cast<std::size_t>(index); }

std::vector<bool> blocks_that_stay_and_strain(const Model& model) {
  std::vector<bool> found(model.blocks.size(), true);
  for (const HeldBlock& held : model.held_blocks) found[at(held.block)] = false;
  for (const Stage& stage : model.stages)
    for (const int block : stage.removal.blocks) found[at(block)] = false;
  return found;
}

bool has_springs(const Model& model, const Interface& interface, const InterfaceElement& element) {
  const JointMaterial& joint = model.joints[at(interface.joint)];
  return element.law == InterfaceLaw::classical ||
         (has_finite_kinematics(model) && is_springs_where_blocks_move(joint));
}

// Faces that springs tie, between blocks that stay and have a strain.
std::vector<Interface> faces_with_springs(const Model& model) {
  const ContactSet drawn = make_contacts(model);
  const std::vector<bool> strains = blocks_that_stay_and_strain(model);
  std::vector<Interface> tied;
  for (std::size_t i = 0; i < drawn.interfaces.size(); ++i) {
    const Interface& interface = drawn.interfaces[i];
    if (interface.length == 0 || !strains[at(interface.block_a)] || !strains[at(interface.block_b)]) continue;
    if (model.joints[at(interface.joint)].bonded) continue;
    if (has_springs(model, interface, drawn.elements.but_for_blocks(i))) tied.push_back(interface);
  }
  return tied;
}

// A joint is judged by the blocks beside it that its springs are softest for: the small ones, which lie where strain
// changes most.
std::vector<Interface> tied_faces(const Model& model) {
  std::vector<Interface> tied = faces_with_springs(model);
  std::vector<double> compliance(model.joints.size(), 0);
  for (const Interface& face : tied)
    compliance[at(face.joint)] = std::max(compliance[at(face.joint)], stiffness_errors(model, face).compliance);
  std::erase_if(tied, [&](const Interface& face) { return compliance[at(face.joint)] >= softest; });
  return tied;
}

// Joints of faces of blocks that are tied along two directions.
std::set<int> locking_joints(const Model& model) {
  const std::vector<Interface> tied = tied_faces(model);
  std::vector<std::optional<Vec2>> first(model.blocks.size());
  std::vector<bool> is_locked(model.blocks.size(), false);
  for (const Interface& face : tied) {
    for (const int block : {face.block_a, face.block_b}) {
      if (!first[at(block)]) first[at(block)] = face.normal;
      if (std::abs(cross(*first[at(block)], face.normal)) > parallel) is_locked[at(block)] = true;
    }
  }
  std::set<int> joints;
  for (const Interface& face : tied)
    if (is_locked[at(face.block_a)] || is_locked[at(face.block_b)]) joints.insert(face.joint);
  return joints;
}

// What lies or acts along the outline of each block.
class Outline {
 public:
  explicit Outline(const Model& model) : model_(model), covered_(model.blocks.size()), held_(model.blocks.size()) {
    for (const Interface& interface : find_interfaces(model))
      for (const int block : {interface.block_a, interface.block_b}) cover(block, interface.from, interface.to);
    for (const EdgeLoad& load : model.edge_loads)
      if (load.stages.has(0)) cover(load.block, load.from, load.to);
    for (const ViscousEdge& edge : model.viscous_edges) cover(edge.block, edge.from, edge.to);
    for (const PointSupport& support : model.supports)
      if (!support.partner) held_[at(support.block)].push_back(support.point);
  }

  // Whether the initial stress of the block acts on a face of it that nothing holds back.
  [[nodiscard]] bool lets_stress_go(int block) const {
    const Block& each = model_.blocks[at(block)];
    if (each.initial_stress.isZero(0) || model_.is_held(block)) return false;
    if (ring_lets_stress_go(block, each.shape.outer)) return true;
    return std::ranges::any_of(each.shape.holes, [&](const Ring& hole) { return ring_lets_stress_go(block, hole); });
  }

 private:
  void cover(int block, const Vec2& from, const Vec2& to) { covered_[at(block)].push_back({from, to}); }

  [[nodiscard]] bool ring_lets_stress_go(int block, const Ring& ring) const {
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (edge_lets_stress_go(block, {ring[i], ring[(i + 1) % ring.size()]})) return true;
    return false;
  }

  [[nodiscard]] bool edge_lets_stress_go(int block, const Segment& edge) const {
    constexpr double share = 1e-6;  // of traction and length, below which there is none
    const Vec3& stress = model_.blocks[at(block)].initial_stress;
    const Vec2 along = (edge.end - edge.start).normalized();
    const Vec2 normal(along.y(), -along.x());
    const Vec2 traction(stress[0] * normal.x() + stress[2] * normal.y(),
                        stress[2] * normal.x() + stress[1] * normal.y());
    const double length = (edge.end - edge.start).norm();
    if (traction.norm() <= share * stress.norm() || is_held(block, edge)) return false;
    return length - covered_length(block, edge, along) > std::max(share * length, 2 * model_.length_tolerance);
  }

  [[nodiscard]] bool is_on(const Vec2& point, const Segment& edge) const {
    return distance(edge, point) <= 10 * model_.length_tolerance;
  }

  [[nodiscard]] bool is_held(int block, const Segment& edge) const {
    return std::ranges::any_of(held_[at(block)], [&](const Vec2& point) { return is_on(point, edge); });
  }

  [[nodiscard]] double covered_length(int block, const Segment& edge, const Vec2& along) const {
    double length = 0;
    for (const Segment& piece : covered_[at(block)])
      if (is_on(piece.start, edge) && is_on(piece.end, edge)) length += std::abs(along.dot(piece.end - piece.start));
    return length;
  }

  const Model& model_;
  std::vector<std::vector<Segment>> covered_;
  std::vector<std::vector<Vec2>> held_;
};

bool lays_walls_free(const Model& model) {
  if (model.removes_blocks() || model.adds_blocks()) return true;
  const auto is_stressed = [](const Block& block) { return !block.initial_stress.isZero(0); };
  if (std::ranges::none_of(model.blocks, is_stressed)) return false;
  const Outline outline(model);
  for (std::size_t block = 0; block < model.blocks.size(); ++block)
    if (outline.lets_stress_go(static_cast<int>(block))) return true;
  return false;
}

std::string remedy(const Model& model, const std::set<int>& joints) {
  const auto could = [&](int joint) { return could_be_projected(model, model.joints[at(joint)]); };
  if (std::ranges::all_of(joints, could)) return "with \"law\": \"projected\" for them by 1 %";
  return "smaller blocks lock less, and so do joints of the law \"projected\", where what else the scene asks for can "
         "be "
         "had with them";
}

}  // namespace

std::vector<std::string> springs_around_openings(const Model& model) {
  if (!lays_walls_free(model)) return {};
  const std::set<int> joints = locking_joints(model);
  if (joints.empty()) return {};
  std::vector<std::string> names;
  for (const int joint : joints) names.push_back(fmt::format("\"{}\"", model.joints[at(joint)].name));
  return {fmt::format(
      "springs at the ends of closed joints ({}) lock blocks where strain changes from one to the next: walls that are "
      "laid free may come in too little (a round hole in rings of 24 blocks by 47 %, of 48 by 18 %, with "
      "\"normal_stiffness\": \"auto\" by 84 and 55 %); {}",
      fmt::join(names, ", "), remedy(model, joints))};
}

}  // namespace dda
