#include "engine/builder/generators.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "engine/core/error.h"

namespace dda {
namespace {

void require_positive(const char* field, double value) {
  if (value > 0 && std::isfinite(value)) return;
  throw InputError("", field, fmt::format("{}", value), "a positive number");
}

void require_buildable(const char* field, double blocks) {
  if (blocks <= most_generated_blocks) return;
  throw InputError("", field, fmt::format("asking for {:.3g} blocks", blocks),
                   fmt::format("at most {} blocks", most_generated_blocks));
}

void append_block(Model& model, const BlockGroup& group, std::string name, Ring corners) {
  Block block;
  block.name = std::move(name);
  block.shape.outer = std::move(corners);
  block.material = group.material;
  block.initial_stress = group.initial_stress;
  block.initial_velocity = group.initial_velocity;
  block.initial_spin = group.initial_spin;
  model.blocks.push_back(std::move(block));
}

void append_rectangle(Model& model, const BlockGroup& group, std::string name, const Vec2& lower, const Vec2& upper) {
  append_block(model, group, std::move(name), {lower, {upper.x(), lower.y()}, upper, {lower.x(), upper.y()}});
}

int bar_block_count(const BarSpec& spec) {
  const double blocks = spec.length / spec.block_length;
  const double whole = std::round(blocks);
  require_buildable("block_length", blocks);
  if (whole >= 1 && std::abs(blocks - whole) <= 1e-6) return static_cast<int>(whole);
  throw InputError(
      "", "block_length", fmt::format("{} m", spec.block_length),
      fmt::format("a whole number of blocks in the length of {} m (these would be {:.6g})", spec.length, blocks));
}

// Distance of the left side of a block from the origin in half widths. A shifted row has one more block, half
// blocks at its ends.
int half_widths_left_of(int column, int columns, bool shifted) {
  if (!shifted) return 2 * column;
  return std::min(std::max(2 * column - 1, 0), 2 * columns);
}

void append_row(Model& model, const GridSpec& spec, int row) {
  const bool shifted = spec.pattern == GridPattern::running_bond && row % 2 == 1;
  const double below = spec.origin.y() + row * spec.block_height;
  const double above = spec.origin.y() + (row + 1) * spec.block_height;
  const auto side = [&](int column) {
    return spec.origin.x() + half_widths_left_of(column, spec.columns, shifted) * (spec.block_width / 2);
  };
  for (int column = 0; column < spec.columns + (shifted ? 1 : 0); ++column) {
    append_rectangle(model, spec.group, fmt::format("{} {}.{}", spec.group.name, row + 1, column + 1),
                     {side(column), below}, {side(column + 1), above});
  }
}

void check(const RingsSpec& spec) {
  if (spec.sectors < 3) throw InputError("", "sectors", fmt::format("{}", spec.sectors), "at least 3");
  if (spec.radii.size() < 2) throw InputError("", "radii", fmt::format("{} radii", spec.radii.size()), "at least 2");
  for (std::size_t i = 0; i < spec.radii.size(); ++i) {
    require_positive("radii", spec.radii[i]);
    if (i == 0 || spec.radii[i] > spec.radii[i - 1]) continue;
    throw InputError("", "radii", fmt::format("{} m after {} m", spec.radii[i], spec.radii[i - 1]), "increasing radii");
  }
  require_buildable("sectors times rings", static_cast<double>(spec.sectors) * static_cast<double>(spec.radii.size()));
}

}  // namespace

int append_bar(Model& model, const BarSpec& spec) {
  require_positive("length", spec.length);
  require_positive("height", spec.height);
  require_positive("block_length", spec.block_length);
  const int count = bar_block_count(spec);
  const int first = static_cast<int>(model.blocks.size());
  const auto side = [&](int i) { return spec.origin.x() + spec.length * (static_cast<double>(i) / count); };
  for (int i = 0; i < count; ++i) {
    append_rectangle(model, spec.group, fmt::format("{} {}", spec.group.name, i + 1), {side(i), spec.origin.y()},
                     {side(i + 1), spec.origin.y() + spec.height});
  }
  return first;
}

int append_grid(Model& model, const GridSpec& spec) {
  require_positive("columns", spec.columns);
  require_positive("rows", spec.rows);
  require_positive("block_width", spec.block_width);
  require_positive("block_height", spec.block_height);
  require_buildable("columns times rows", static_cast<double>(spec.columns) * spec.rows);
  const int first = static_cast<int>(model.blocks.size());
  for (int row = 0; row < spec.rows; ++row) append_row(model, spec, row);
  return first;
}

int append_rings(Model& model, const RingsSpec& spec) {
  check(spec);
  const int first = static_cast<int>(model.blocks.size());
  const auto corner = [&spec](double radius, int joint) -> Vec2 {
    const double angle = spec.first_corner + 2 * std::numbers::pi * (joint % spec.sectors) / spec.sectors;
    return spec.centre + radius * Vec2(std::cos(angle), std::sin(angle));
  };
  for (std::size_t ring = 1; ring < spec.radii.size(); ++ring) {
    const double inner = spec.radii[ring - 1];
    const double outer = spec.radii[ring];
    for (int sector = 0; sector < spec.sectors; ++sector) {
      append_block(
          model, spec.group, fmt::format("{} {}.{}", spec.group.name, ring, sector + 1),
          {corner(inner, sector), corner(outer, sector), corner(outer, sector + 1), corner(inner, sector + 1)});
    }
  }
  return first;
}

}  // namespace dda
