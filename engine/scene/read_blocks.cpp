#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "engine/builder/generators.h"
#include "engine/core/error.h"
#include "engine/scene/block_group.h"
#include "engine/scene/cut_remarks.h"
#include "engine/scene/read_rock.h"
#include "engine/scene/rock_values.h"
#include "engine/scene/sections.h"

namespace dda {
namespace {

Vec2 read_origin(const Field& field) {
  return value_or(field, "origin", Vec2(Vec2::Zero()), [](const Field& f) { return f.vector(Dimension::length); });
}

// Errors of the generators name their fields as the scene does, but not where in the scene they stand.
template <typename Append>
void append_at(const Field& field, Append append) {
  try {
    append();
  } catch (const InputError& error) {
    const auto key = field.find(error.field());
    throw InputError("", key ? key->path() : field.path() + " " + error.field(), error.value(), error.expected());
  }
}

void read_bar(const Field& field, Model& model) {
  BarSpec spec;
  spec.group = read_group(field, "bar", model);
  spec.origin = read_origin(field);
  spec.length = field.at("length").positive(Dimension::length);
  spec.height = field.at("height").positive(Dimension::length);
  spec.block_length = field.at("block_length").positive(Dimension::length);
  append_at(field, [&] { append_bar(model, spec); });
}

void read_grid(const Field& field, Model& model) {
  GridSpec spec;
  spec.group = read_group(field, "grid", model);
  spec.origin = read_origin(field);
  spec.columns = field.at("columns").whole_number();
  spec.rows = field.at("rows").whole_number();
  spec.block_width = field.at("block_width").positive(Dimension::length);
  spec.block_height = field.at("block_height").positive(Dimension::length);
  spec.pattern = value_or(field, "pattern", GridPattern::stack, [](const Field& f) {
    return f.choice({"stack", "running_bond"}) == 0 ? GridPattern::stack : GridPattern::running_bond;
  });
  append_at(field, [&] { append_grid(model, spec); });
}

void read_rings(const Field& field, Model& model) {
  RingsSpec spec;
  spec.group = read_group(field, "rings", model);
  spec.centre = value_or(field, "centre", spec.centre, [](const Field& f) { return f.vector(Dimension::length); });
  for (const Field& radius : field.at("radii").items()) spec.radii.push_back(radius.positive(Dimension::length));
  spec.sectors = field.at("sectors").whole_number();
  spec.first_corner = value_or(field, "first_corner", 0.0, read_direction);
  append_at(field, [&] { append_rings(model, spec); });
}

void read_polygon(const Field& field, Model& model) {
  const BlockGroup group = read_group(field, fmt::format("block {}", model.blocks.size() + 1), model);
  Block block = block_of(group, group.name);
  block.shape.outer = read_ring(field.at("vertices"));
  if (const auto holes = field.find("holes")) {
    for (const Field& hole : holes->items()) block.shape.holes.push_back(read_ring(hole));
  }
  if (const auto why = defect(block.shape)) field.fail(*why, "a simple polygon");
  model.blocks.push_back(std::move(block));
}

void read_rock_entry(const Field& field, const std::filesystem::path& folder, const std::vector<PlainLines>& lines,
                     Model& model, BlockFacts& facts) {
  const Rock rock = read_rock(field, folder, lines, model);
  const CutRock pieces = cut(rock);
  append_rock(rock, pieces, model, facts.groups);
  std::ranges::move(cut_remarks(rock, pieces), std::back_inserter(facts.remarks));
}

// Appends the blocks of the entry and the group of each.
void read_entry(const std::string& kind, const Field& field, Model& model, BlockFacts& facts) {
  if (kind == "bar") {
    read_bar(field, model);
  } else if (kind == "grid") {
    read_grid(field, model);
  } else if (kind == "rings") {
    read_rings(field, model);
  } else {
    read_polygon(field, model);
  }
  const bool is_polygon = kind == "polygon";
  const std::string name = is_polygon ? model.blocks.back().name : kind;
  facts.groups.resize(model.blocks.size(),
                      value_or(field, is_polygon ? "group" : "name", name, [](const Field& f) { return f.name(); }));
}

void append_given(const GivenBlocks& given, Model& model, BlockFacts& facts) {
  model.blocks.insert(model.blocks.end(), given.blocks.begin(), given.blocks.end());
  facts.groups.insert(facts.groups.end(), given.groups.begin(), given.groups.end());
}

}  // namespace

BlockFacts read_blocks(const Field& scene, const std::filesystem::path& folder, const std::vector<GivenBlocks>& given,
                       const std::vector<PlainLines>& lines, Model& model) {
  const Field blocks = scene.at("blocks");
  const std::vector<Field> entries = blocks.is_array() ? blocks.items() : std::vector<Field>{blocks};
  BlockFacts facts;
  auto next = given.begin();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto members = entries[i].members();
    const auto& [kind, field] = members.front();
    if (next != given.end() && next->entry == i)
      append_given(*next++, model, facts);
    else if (kind == "rock")
      read_rock_entry(field, folder, lines, model, facts);
    else
      read_entry(kind, field, model, facts);
    facts.own_stress.resize(model.blocks.size(), field.has("initial_stress"));
  }
  return facts;
}

void read_gravity(const Field& scene, Model& model) {
  const auto gravity = scene.find("gravity");
  if (!gravity) return;
  if (gravity->is_array()) {
    model.gravity = gravity->vector(Dimension::acceleration);
    return;
  }
  const double size = gravity->quantity(Dimension::acceleration);
  if (size < 0) gravity->fail("a size, zero or more, of the acceleration downwards, or [x, y]");
  model.gravity = {0, -size};
}

}  // namespace dda
