// Stress and motion at the start as functions of place: tables of what blocks have at their centroids.
#include <fmt/format.h>

#include <array>
#include <numeric>

#include "engine/core/error.h"
#include "engine/model/tolerance.h"
#include "engine/scene/block_sets.h"
#include "engine/scene/place_table.h"
#include "engine/scene/sections.h"

namespace dda {
namespace {

struct InitialQuantity {
  const char* key;
  Dimension dimension;
  double& (*of)(Block& block);
};

constexpr std::array<InitialQuantity, 9> initial_quantities{{
    {"stress_xx", Dimension::stress, [](Block& b) -> double& { return b.initial_stress(0); }},
    {"stress_yy", Dimension::stress, [](Block& b) -> double& { return b.initial_stress(1); }},
    {"stress_xy", Dimension::stress, [](Block& b) -> double& { return b.initial_stress(2); }},
    {"velocity_x", Dimension::velocity, [](Block& b) -> double& { return b.initial_velocity(0); }},
    {"velocity_y", Dimension::velocity, [](Block& b) -> double& { return b.initial_velocity(1); }},
    {"spin", Dimension::angular_velocity, [](Block& b) -> double& { return b.initial_spin; }},
    {"strain_rate_xx", Dimension::rate, [](Block& b) -> double& { return b.initial_strain_rate(0); }},
    {"strain_rate_yy", Dimension::rate, [](Block& b) -> double& { return b.initial_strain_rate(1); }},
    {"strain_rate_xy", Dimension::rate, [](Block& b) -> double& { return b.initial_strain_rate(2); }},
}};

[[noreturn]] void fail_outside(const Field& field, const Block& block) {
  throw InputError("", field.path(),
                   fmt::format("a grid without block \"{}\", whose centroid is at [{:.6g}, {:.6g}]", block.name,
                               block.moments.centroid.x(), block.moments.centroid.y()),
                   "x and y that reach around the centroids of all its blocks; a single x or y stands for all of them");
}

void read_initial_field(const Field& field, const std::vector<int>& blocks, Model& model) {
  const GridAxis x(field.at("x"));
  const GridAxis y(field.at("y"));
  const double slack = point_tolerance(model);  // a grid of the centroids themselves is theirs up to rounding
  bool given = false;
  for (const InitialQuantity& quantity : initial_quantities) {
    const auto values = field.find(quantity.key);
    if (!values) continue;
    given = true;
    const PlaceTable table(*values, x, y, quantity.dimension);
    for (const int index : blocks) {
      Block& block = model.blocks[static_cast<std::size_t>(index)];
      const auto column = x.find(block.moments.centroid.x(), slack);
      const auto row = y.find(block.moments.centroid.y(), slack);
      if (!column || !row) fail_outside(field, block);
      quantity.of(block) = table.at(*column, *row);
    }
  }
  if (!given) throw InputError("", field.path(), "without values", "one of stress_xx, velocity_x, spin, ...");
}

bool gives_stress(const Field& field) {
  return field.has("stress_xx") || field.has("stress_yy") || field.has("stress_xy");
}

}  // namespace

std::vector<int> read_initial_fields(const Field& scene, const std::vector<std::string>& groups, Model& model) {
  const auto fields = scene.find("initial_fields");
  std::vector<int> stressed;
  if (!fields) return stressed;
  const BlockSets sets(model, groups);
  std::vector<int> all(model.blocks.size());
  std::iota(all.begin(), all.end(), 0);
  for (const Field& field : fields->items()) {
    const auto group = field.find("group");
    const std::vector<int> blocks = group ? sets.members(*group) : all;
    read_initial_field(field, blocks, model);
    if (gives_stress(field)) stressed.insert(stressed.end(), blocks.begin(), blocks.end());
  }
  return stressed;
}

}  // namespace dda
