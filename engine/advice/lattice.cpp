#include "engine/advice/lattice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/joint_stiffness.h"
#include "engine/contact/make_contacts.h"
#include "engine/model/moving_stages.h"
#include "engine/simulation/linear_operators.h"
#include "engine/terms/load.h"

namespace dda {
namespace {

constexpr double relative_tolerance = 1e-6;  // of lengths, over those of the block

// An interface as one of its blocks has it.
struct Side {
  std::size_t interface = 0;
  int other = 0;
};

std::vector<std::vector<Side>> sides_of_blocks(const Model& model, const ContactSet& contacts) {
  std::vector<std::vector<Side>> sides(model.blocks.size());
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    const Interface& interface = contacts.interfaces[i];
    if (interface.length == 0) continue;
    sides[static_cast<std::size_t>(interface.block_a)].push_back({i, interface.block_b});
    sides[static_cast<std::size_t>(interface.block_b)].push_back({i, interface.block_a});
  }
  return sides;
}

// True when `b` is `a` moved by `offset`, whichever vertex it begins with.
bool is_copy(const Ring& a, const Ring& b, const Vec2& offset, double tolerance) {
  if (a.size() != b.size()) return false;
  for (std::size_t shift = 0; shift < a.size(); ++shift) {
    bool same = true;
    for (std::size_t i = 0; same && i < a.size(); ++i)
      same = (a[i] + offset - b[(i + shift) % b.size()]).norm() < tolerance;
    if (same) return true;
  }
  return false;
}

bool is_row(const std::vector<std::vector<Side>>& sides, const ContactSet& contacts) {
  for (const auto& of_block : sides) {
    if (of_block.size() > 2) return false;
    for (const Side& side : of_block) {
      const Vec2& normal = contacts.interfaces[side.interface].normal;
      if (std::abs(normal.dot(contacts.interfaces[sides.front().front().interface].normal)) < 1 - 1e-9) return false;
    }
  }
  return true;
}

// False where a neighbour has none opposite. What a block has on one side its copy has on the other, so that opposite
// neighbours get the same joint.
bool pair_up(Lattice& lattice, double tolerance) {
  for (std::size_t i = 0; i < lattice.offsets.size(); ++i) {
    const auto opposite = std::find_if(lattice.offsets.begin(), lattice.offsets.end(),
                                       [&](const Vec2& o) { return (o + lattice.offsets[i]).norm() < tolerance; });
    if (opposite == lattice.offsets.end()) return false;
    const auto j = static_cast<std::size_t>(opposite - lattice.offsets.begin());
    if (j < i) lattice.joints[i] = lattice.joints[j];
  }
  return true;
}

bool all_parallel(const std::vector<Vec2>& offsets) {
  return std::all_of(offsets.begin(), offsets.end(), [&](const Vec2& o) {
    return std::abs(o.x() * offsets[0].y() - o.y() * offsets[0].x()) <
           relative_tolerance * o.norm() * offsets[0].norm();
  });
}

// The joint as it acts in the scene: a law that can be used here, springs of their final stiffness.
JointMaterial acting_joint(const Model& model, const ContactSet& contacts, std::size_t index) {
  const Interface& interface = contacts.interfaces[index];
  JointMaterial joint = model.joints[static_cast<std::size_t>(interface.joint)];
  joint.law = has_finite_kinematics(model) && is_springs_where_blocks_move(joint)
                  ? InterfaceLaw::classical
                  : contacts.elements.but_for_blocks(index).law;
  joint.bonded = true;
  joint.contact_damping = 0;
  if (joint.law != InterfaceLaw::classical || joint.normal_stiffness > 0) return joint;
  const Springs springs = springs_of(model, interface);
  joint.normal_spring = springs.normal;
  joint.shear_to_normal = springs.shear / springs.normal;
  joint.automatic_stiffness = false;
  return joint;
}

class Search {
 public:
  Search(const Model& model, const ContactSet& contacts, int material)
      : model_(model),
        contacts_(contacts),
        material_(material),
        sides_(sides_of_blocks(model, contacts)),
        row_(!contacts.interfaces.empty() && touches_something() && is_row_of_all()) {}

  [[nodiscard]] std::optional<Lattice> run() const {
    std::vector<std::size_t> blocks;
    for (std::size_t i = 0; i < model_.blocks.size(); ++i)
      if (model_.blocks[i].material == material_ && !sides_[i].empty()) blocks.push_back(i);
    if (blocks.empty()) return std::nullopt;
    std::stable_sort(blocks.begin(), blocks.end(),
                     [&](std::size_t a, std::size_t b) { return area(a) > (1 + relative_tolerance) * area(b); });
    for (const std::size_t block : blocks)
      if (auto lattice = around(block)) return lattice;
    return assumed(blocks);
  }

 private:
  [[nodiscard]] bool touches_something() const {
    return std::any_of(sides_.begin(), sides_.end(), [](const auto& sides) { return !sides.empty(); });
  }
  [[nodiscard]] bool is_row_of_all() const {
    return std::all_of(sides_.begin(), sides_.end(), [](const auto& sides) { return !sides.empty(); }) &&
           is_row(sides_, contacts_);
  }
  [[nodiscard]] double area(std::size_t block) const { return model_.blocks[block].moments.area; }

  [[nodiscard]] std::optional<Lattice> around(std::size_t index) const {
    const Block& block = model_.blocks[index];
    const double tolerance = relative_tolerance * std::sqrt(block.moments.area);
    Lattice lattice = empty();
    if (!block.shape.holes.empty()) return std::nullopt;
    for (const Side& side : sides_[index]) {
      const Block& other = model_.blocks[static_cast<std::size_t>(side.other)];
      const Vec2 offset = other.moments.centroid - block.moments.centroid;
      if (other.material != material_ || !is_copy(block.shape.outer, other.shape.outer, offset, tolerance))
        return std::nullopt;
      lattice.offsets.push_back(offset);
      lattice.joints.push_back(acting_joint(model_, contacts_, side.interface));
    }
    if (!pair_up(lattice, tolerance)) return std::nullopt;
    if (all_parallel(lattice.offsets) != row_) return std::nullopt;
    lattice.ring = block.shape.outer;
    lattice.normal = contacts_.interfaces[sides_[index].front().interface].normal;
    lattice.origin = fmt::format("blocks like \"{}\" and its neighbours, everywhere", block.name);
    return lattice;
  }

  [[nodiscard]] Lattice empty() const {
    Lattice lattice;
    lattice.material = model_.materials[static_cast<std::size_t>(material_)];
    lattice.row = row_;
    return lattice;
  }

  // As large as the largest of the material's blocks across an interface between two of them.
  [[nodiscard]] std::optional<Lattice> assumed(const std::vector<std::size_t>& blocks) const {
    double size = 0;
    std::size_t widest = 0;
    for (const std::size_t index : blocks) {
      for (const Side& side : sides_[index]) {
        const Interface& interface = contacts_.interfaces[side.interface];
        if (model_.blocks[static_cast<std::size_t>(side.other)].material != material_) continue;
        const Vec2 depth = (interface.from + interface.to) / 2 - model_.blocks[index].moments.centroid;
        const double across = 2 * std::abs(depth.dot(interface.normal));
        if (across > (1 + relative_tolerance) * size) {
          size = across;
          widest = side.interface;
        }
      }
    }
    if (size == 0) return std::nullopt;
    return rectangles(size, contacts_.interfaces[widest], widest);
  }

  [[nodiscard]] Lattice rectangles(double size, const Interface& interface, std::size_t index) const {
    Lattice lattice = empty();
    const Vec2 along = size * interface.normal;
    const Vec2 unit(-interface.normal.y(), interface.normal.x());
    const Vec2 across = (row_ ? interface.length : size) * unit;
    lattice.ring = {Vec2::Zero(), along, along + across, across};
    lattice.offsets = {along, -along};
    if (!row_) lattice.offsets.insert(lattice.offsets.end(), {across, -across});
    lattice.joints.assign(lattice.offsets.size(), acting_joint(model_, contacts_, index));
    lattice.normal = interface.normal;
    lattice.assumed = true;
    lattice.origin =
        fmt::format("assumed: {} of {:.4g} m, the largest size across a joint (its blocks are not all alike)",
                    row_ ? "a row of blocks" : "square blocks", size);
    return lattice;
  }

  const Model& model_;
  const ContactSet& contacts_;
  int material_;
  std::vector<std::vector<Side>> sides_;
  bool row_;
};

bool have_same_stiffness(const JointMaterial& a, const JointMaterial& b) {
  return a.law == b.law && a.penalty == b.penalty && a.stabilisation == b.stabilisation &&
         a.normal_spring == b.normal_spring && a.spring_over_young == b.spring_over_young &&
         a.shear_to_normal == b.shear_to_normal && a.normal_stiffness == b.normal_stiffness &&
         a.shear_stiffness == b.shear_stiffness;
}

Ring moved(Ring ring, const Vec2& offset) {
  for (Vec2& vertex : ring) vertex += offset;
  return ring;
}

// Where neighbours of the neighbours that are present have blocks, but for these and the block itself: what hangs at it
// alone bears no moment past it (row_bending.h), as neighbours in the rock do. Nothing is where `present` leaves out
// one side of the block.
std::vector<Vec2> second_ring(const Lattice& lattice, const std::vector<bool>& present) {
  const auto is_missing = [&](std::size_t i) -> bool { return !present.empty() && !present[i]; };
  Vec2 missing = Vec2::Zero();
  for (std::size_t i = 0; i < lattice.offsets.size(); ++i)
    if (is_missing(i)) missing += lattice.offsets[i];
  const double near = 1e-6 * lattice.offsets.front().norm();
  std::vector<Vec2> known = lattice.offsets;
  known.emplace_back(Vec2::Zero());
  for (std::size_t i = 0; i < lattice.offsets.size(); ++i)
    for (const Vec2& further : lattice.offsets) {
      const Vec2 offset = lattice.offsets[i] + further;
      const auto is_here = [&](const Vec2& other) { return (offset - other).norm() < near; };
      if (is_missing(i) || offset.dot(missing) > near || std::ranges::any_of(known, is_here)) continue;
      known.push_back(offset);
    }
  known.erase(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(lattice.offsets.size()) + 1);
  return known;
}

// The block, its neighbours and theirs as a scene of their own; the block is number 0.
Model patch(const Lattice& lattice, const Stage& stage, const std::vector<bool>& present) {
  Model model;
  model.materials = {lattice.material};
  model.joints = {lattice.joints.front()};
  model.blocks.emplace_back().shape.outer = lattice.ring;
  for (std::size_t i = 0; i < lattice.offsets.size(); ++i) {
    if (!present.empty() && !present[i]) continue;
    model.joint_of_block_pair[{0, static_cast<int>(model.blocks.size())}] = static_cast<int>(model.joints.size());
    model.joints.push_back(lattice.joints[i]);
    model.blocks.emplace_back().shape.outer = moved(lattice.ring, lattice.offsets[i]);
  }
  for (const Vec2& offset : second_ring(lattice, present))
    model.blocks.emplace_back().shape.outer = moved(lattice.ring, offset);
  for (std::size_t i = 0; i < model.joints.size(); ++i) model.joints[i].name = fmt::format("joint {}", i);
  for (std::size_t i = 0; i < model.blocks.size(); ++i) model.blocks[i].name = fmt::format("block {}", i);
  model.stages = {stage};
  model.stages.front().removal = {};  // of the scene's blocks
  model.stages.front().rock = {};     // the same, and of all its materials and joints
  model.stages.front().duration = stage.dt;
  model.stages.front().kinematics = Kinematics::small;
  finish_model(model);
  return model;
}

// Tractions of an interface that the block (here) and its neighbour (there) make by moving alone.
void set_tractions(const Model& model, const Interface& interface, const InterfaceElement& element,
                   LatticeCoupling& coupling) {
  const Mat3 elasticity = elasticity_matrix(model.materials.front());
  const auto traction = [&](const Vec6& here, const Vec6& there) {
    return mean_traction(
        model, interface, element,
        linear_state(element, Vec4::Zero(), here, there, elasticity * here.tail<3>(), elasticity * there.tail<3>()));
  };
  for (int i = 0; i < 6; ++i) {
    coupling.traction_here.col(i) = traction(Vec6::Unit(i), Vec6::Zero());
    coupling.traction_there.col(i) = traction(Vec6::Zero(), Vec6::Unit(i));
  }
}

}  // namespace

std::vector<Vec2> Lattice::face_normals() const {
  Stage stage;
  stage.dt = 1;  // enters no geometry
  const LatticeMatrices matrices = lattice_matrices(*this, stage);
  std::vector<Vec2> normals;
  for (const LatticeCoupling& coupling : matrices.couplings) {
    const bool known = std::any_of(normals.begin(), normals.end(),
                                   [&](const Vec2& n) { return std::abs(n.dot(coupling.normal)) > 1 - 1e-6; });
    if (!known) normals.push_back(coupling.normal);
  }
  for (Vec2& n : normals) {
    const bool backwards = n.x() < -relative_tolerance || (n.x() < relative_tolerance && n.y() < 0);
    n = (backwards ? Vec2(-n) : n) + Vec2::Zero();  // and no negative zeros
  }
  return normals;
}

bool looks_the_same(const Lattice& lattice, const Vec2& from, const Vec2& to) {
  Mat2 turn;
  turn << from.dot(to), from.y() * to.x() - from.x() * to.y(), from.x() * to.y() - from.y() * to.x(), from.dot(to);
  const double tolerance = relative_tolerance * lattice.offsets.front().norm();
  Ring turned = lattice.ring;
  for (Vec2& vertex : turned) vertex = turn * vertex;
  const auto middle = [](const Ring& ring) { return area_moments(Polygon{ring, {}}).centroid; };
  if (!is_copy(turned, lattice.ring, middle(lattice.ring) - middle(turned), tolerance)) return false;
  for (std::size_t i = 0; i < lattice.offsets.size(); ++i) {
    bool found = false;
    for (std::size_t j = 0; j < lattice.offsets.size() && !found; ++j)
      found = (turn * lattice.offsets[i] - lattice.offsets[j]).norm() < tolerance &&
              have_same_stiffness(lattice.joints[i], lattice.joints[j]);
    if (!found) return false;
  }
  return true;
}

std::optional<Lattice> find_lattice(const Model& model, const ContactSet& contacts, int material) {
  return Search(model, contacts, material).run();
}

Lattice scaled(const Lattice& lattice, double factor) {
  Lattice result = lattice;
  Mat2 map = factor * Mat2::Identity();
  if (lattice.row) map = Mat2::Identity() + (factor - 1) * lattice.normal * lattice.normal.transpose();
  for (Vec2& vertex : result.ring) vertex = map * vertex;
  for (Vec2& offset : result.offsets) offset = map * offset;
  return result;
}

Lattice with_consistent_joints(const Lattice& lattice) {
  Lattice result = lattice;
  const JointMaterial standard;
  for (JointMaterial& joint : result.joints) {
    joint.law = InterfaceLaw::consistent;
    joint.penalty = standard.penalty;
    joint.stabilisation = standard.stabilisation;
  }
  return result;
}

Vec6 LatticeMatrices::load(const Vec2& offset, const Vec2& force) const {
  return point_load(offset, force) + waves.lever_correction(0, offset, force);
}

LatticeMatrices lattice_matrices(const Lattice& lattice, const Stage& stage, const std::vector<bool>& present) {
  const Model model = patch(lattice, stage, present);
  const ContactSet contacts = make_contacts(model);
  const BlockTerms terms = make_block_terms(model, stage);
  const WaveCorrections waves(model, model.stages.front(), contacts);
  const LinearOperators operators(model, terms, contacts, {}, waves);
  LatticeMatrices matrices{operators.stiffness.block(0, 0), operators.inertia.block(0, 0), {}, waves};
  const Vec2& centroid = model.blocks.front().moments.centroid;
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    const Interface& interface = contacts.interfaces[i];
    if (interface.block_a != 0 || interface.length == 0) continue;
    LatticeCoupling coupling;
    coupling.offset = model.blocks[static_cast<std::size_t>(interface.block_b)].moments.centroid - centroid;
    coupling.stiffness = operators.stiffness.block(0, interface.block_b);
    coupling.inertia = operators.inertia.block(0, interface.block_b);
    coupling.normal = interface.normal;
    coupling.middle = (interface.from + interface.to) / 2 - centroid;
    coupling.length = interface.length;
    set_tractions(model, interface, contacts.elements[i], coupling);
    matrices.couplings.push_back(coupling);
  }
  return matrices;
}

}  // namespace dda
