#include "engine/contact/block_bounds.h"

#include <cmath>

#include "engine/contact/interface_element.h"
#include "engine/geometry/box_pairs.h"

namespace dda {
namespace {

// A box along the block is worth its while where it has less than this share of the upright one's area.
constexpr double worthwhile_share = 0.5;

bool contains(const Box& outer, const Box& inner) {
  return (inner.lower.array() >= outer.lower.array()).all() && (inner.upper.array() <= outer.upper.array()).all();
}

double area(const Box& box) { return (box.upper - box.lower).prod(); }

Box box_along(const Outlines& outlines, int block, const Vec2& along) {
  Box box;
  const Mat2 axes = local_axes(along);
  const auto first = static_cast<std::size_t>(block);
  for (int i = outlines.starts[first]; i < outlines.starts[first + 1]; ++i)
    box = expanded(box, Vec2(axes * outlines.current[static_cast<std::size_t>(i)]));
  return box;
}

}  // namespace

SlantedBox slanted_box(const Outlines& outlines, int block) {
  double cosine = 0, sine = 0;  // of twice the angle, weighted with the lengths of the edges
  const auto first = static_cast<std::size_t>(block);
  for (int i = outlines.starts[first]; i < outlines.starts[first + 1]; ++i) {
    const Vec2 edge = outlines.along(i);
    if (edge.isZero(0)) continue;
    cosine += (edge.x() * edge.x() - edge.y() * edge.y()) / edge.norm();
    sine += 2 * edge.x() * edge.y() / edge.norm();
  }
  const double angle = std::atan2(sine, cosine) / 2;
  const Vec2 along(std::cos(angle), std::sin(angle));
  return {along, box_along(outlines, block, along)};
}

void BlockBounds::set(const Outlines& outlines, std::span<const double> margins) {
  upright_.resize(margins.size());
  slanted_.resize(margins.size());
  for (std::size_t i = 0; i < margins.size(); ++i) {
    slanted_[i] = {};
    if (margins[i] < 0) {
      upright_[i] = {};
      continue;
    }
    upright_[i] = expanded(outlines.boxes[i], margins[i]);
    SlantedBox aslant = slanted_box(outlines, static_cast<int>(i));
    aslant.box = expanded(aslant.box, margins[i]);
    if (area(aslant.box) < worthwhile_share * area(upright_[i])) slanted_[i] = aslant;
  }
}

bool BlockBounds::hold(const Outlines& outlines, int block, double margin) const {
  const auto i = static_cast<std::size_t>(block);
  if (!contains(upright_[i], expanded(outlines.boxes[i], margin))) return false;
  const SlantedBox& aslant = slanted_[i];
  if (aslant.along.isZero(0)) return true;
  return contains(aslant.box, expanded(box_along(outlines, block, aslant.along), margin));
}

std::vector<std::pair<int, int>> BlockBounds::overlapping() const {
  std::vector<std::pair<int, int>> pairs = overlapping_pairs(upright_);
  std::erase_if(pairs, [this](const std::pair<int, int>& pair) { return are_apart(pair.first, pair.second); });
  return pairs;
}

bool BlockBounds::are_apart(int a, int b) const {
  const auto lies_aslant = [this](int block) { return !slanted_[static_cast<std::size_t>(block)].along.isZero(0); };
  return (lies_aslant(a) && is_beside(slanted_[static_cast<std::size_t>(a)], b)) ||
         (lies_aslant(b) && is_beside(slanted_[static_cast<std::size_t>(b)], a));
}

bool BlockBounds::is_beside(const SlantedBox& one, int other) const {
  const SlantedBox& aslant = slanted_[static_cast<std::size_t>(other)];
  const bool is_upright = aslant.along.isZero(0);
  const Vec2 along = is_upright ? Vec2(1, 0) : aslant.along;
  const Box& box = is_upright ? upright_[static_cast<std::size_t>(other)] : aslant.box;
  const Mat2 turn = local_axes(one.along) * local_axes(along).transpose();  // from its axes to those of `one`
  const Vec2 middle = turn * (box.lower + box.upper) / 2;
  const Vec2 half = turn.cwiseAbs() * (box.upper - box.lower) / 2;
  return !overlap(one.box, {middle - half, middle + half});
}

}  // namespace dda
