#include "engine/simulation/contact_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "engine/contact/closure.h"
#include "engine/contact/interface_frame.h"
#include "engine/geometry/box.h"
#include "engine/geometry/box_pairs.h"
#include "engine/geometry/overlap.h"
#include "engine/model/current_outline.h"
#include "engine/simulation/block_extent.h"

namespace dda {
namespace {

constexpr double skin = 0.01;               // of the least thickness
constexpr double overlap_tolerance = 1e-3;  // of the thinner block's thickness

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// By which a block's sides have come nearer to each other, or corners have moved that neighbours of one strain each
// share with it: so much of a block is in its neighbour across a corner where rock is bonded.
double strain_of(const Mat2& deformation) {
  return (deformation.transpose() * deformation - Mat2::Identity()).norm() / 2;
}

double slide_limit(const Model& model, const Interface& interface) {
  if (interface.length > 0) return interface.length;
  double nearest = std::numeric_limits<double>::infinity();
  const auto visit = [&](const Ring& ring) {
    for (const Vec2& corner : ring) nearest = std::min(nearest, (corner - interface.from).norm());
  };
  const Polygon& shape = model.blocks[at(interface.block_a)].shape;
  visit(shape.outer);
  for (const Ring& hole : shape.holes) visit(hole);
  return nearest;
}

std::string sentence(const Model& model, int block_a, int block_b, const char* what) {
  return fmt::format("blocks \"{}\" and \"{}\" {}: contacts other than those of the start are not followed yet",
                     model.blocks[at(block_a)].name, model.blocks[at(block_b)].name, what);
}

}  // namespace

ContactRange::ContactRange(const Model& model, const std::vector<Interface>& interfaces)
    : least_thickness_(std::numeric_limits<double>::infinity()),
      checked_displacement_(model.blocks.size(), Vec2::Zero()),
      checked_deformation_(model.blocks.size(), Mat2::Identity()) {
  for (const Block& block : model.blocks) {
    radius_.push_back(radius_of(block));
    thickness_.push_back(thickness_of(block, radius_.back()));
    least_thickness_ = std::min(least_thickness_, thickness_.back());
  }
  list(model, interfaces);
}

void ContactRange::leave_out(const std::vector<bool>& absent, const Model& model,
                             const std::vector<Interface>& interfaces) {
  if (thickness_.empty()) return;
  absent_ = absent;
  list(model, interfaces);
}

void ContactRange::list(const Model& model, const std::vector<Interface>& interfaces) {
  slide_limit_.clear();
  of_pair_.clear();
  for (const Interface& interface : interfaces) {
    slide_limit_.push_back(slide_limit(model, interface));
    of_pair_.emplace_back(std::minmax(interface.block_a, interface.block_b), static_cast<int>(of_pair_.size()));
  }
  std::sort(of_pair_.begin(), of_pair_.end());
}

std::string ContactRange::problem(const Model& model, const State& state, const ContactSet& contacts) {
  if (!moved_beyond_skin(state)) return "";
  for (std::size_t i = 0; i < checked_displacement_.size(); ++i) {
    checked_displacement_[i] = state.displacement[i].head<2>();
    checked_deformation_[i] = state.deformation[i];
  }
  const std::string sliding = sliding_problem(model, state, contacts);
  return sliding.empty() ? overlap_problem(model, state, contacts) : sliding;
}

bool ContactRange::moved_beyond_skin(const State& state) const {
  for (std::size_t i = 0; i < checked_displacement_.size(); ++i) {
    const double moved = (state.displacement[i].head<2>() - checked_displacement_[i]).norm() +
                         (state.deformation[i] - checked_deformation_[i]).norm() * radius_[i];
    if (moved > skin * least_thickness_) return true;
  }
  return false;
}

std::string ContactRange::sliding_problem(const Model& model, const State& state, const ContactSet& contacts) const {
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    if (is_open(contacts.elements.but_for_blocks(i), contacts.states[i])) continue;
    const Interface& interface = contacts.interfaces[i];
    const InterfaceFrame frame = current_frame(model, state, interface);
    const Vec2 apart = (frame.from_b + frame.to_b - frame.from_a - frame.to_a) / 2;
    const double slide = std::abs(frame.normal.x() * apart.y() - frame.normal.y() * apart.x());
    if (slide > slide_limit_[i])
      return sentence(model, interface.block_a, interface.block_b, "have slid off their common edge");
  }
  return "";
}

std::string ContactRange::overlap_problem(const Model& model, const State& state, const ContactSet& contacts) const {
  const std::vector<Polygon> outlines = current_outlines(model, state);
  std::vector<Box> boxes;
  for (std::size_t block = 0; block < outlines.size(); ++block) {
    // Half the least tolerance: blocks that overlap by a whole one still have boxes in common, most that touch do not.
    const bool is_absent = !absent_.empty() && absent_[block];
    boxes.push_back(is_absent ? Box{}
                              : expanded(bounding_box(outlines[block]), -overlap_tolerance * least_thickness_ / 2));
  }
  for (const auto& [a, b] : overlapping_pairs(boxes)) {
    if (holds_together(a, b, contacts)) continue;
    const double strains = strain_of(state.deformation[at(a)]) + strain_of(state.deformation[at(b)]);
    const double tolerance = (overlap_tolerance + strains) * std::min(thickness_[at(a)], thickness_[at(b)]);
    if (interiors_overlap(outlines[at(a)], outlines[at(b)], tolerance))
      return sentence(model, a, b, "have run into each other where they did not touch at the start");
  }
  return "";
}

// True while some interface of the two blocks is not open: their overlap is then that of a closed contact.
bool ContactRange::holds_together(int block_a, int block_b, const ContactSet& contacts) const {
  const std::pair<int, int> pair = std::minmax(block_a, block_b);
  for (auto found = std::lower_bound(of_pair_.begin(), of_pair_.end(), std::pair{pair, 0});
       found != of_pair_.end() && found->first == pair; ++found) {
    const std::size_t i = at(found->second);
    if (!is_open(contacts.elements.but_for_blocks(i), contacts.states[i])) return true;
  }
  return false;
}

}  // namespace dda
