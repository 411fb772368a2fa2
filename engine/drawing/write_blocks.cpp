#include "engine/drawing/write_blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "engine/drawing/dc_text.h"
#include "engine/drawing/dxf_text.h"
#include "engine/drawing/layers.h"

namespace dda {
namespace {

using nlohmann::json;

json position(const Vec2& point) { return {point.x(), point.y()}; }

json closed(const Ring& ring) {
  json positions = json::array();
  for (const Vec2& vertex : ring) positions.push_back(position(vertex));
  positions.push_back(position(ring.front()));
  return positions;
}

json feature(json properties, const char* type, json coordinates) {
  return {{"type", "Feature"},
          {"properties", std::move(properties)},
          {"geometry", {{"type", type}, {"coordinates", std::move(coordinates)}}}};
}

// One feature a line.
std::string geojson_text(const BlockDrawing& drawing) {
  std::string text = "{\"type\": \"FeatureCollection\", \"features\": [";
  const char* before = "\n";
  const auto add = [&](const json& each) { text += std::exchange(before, ",\n") + each.dump(); };
  for (const ExportedBlock& block : drawing.blocks) {
    json rings = json::array({closed(block.shape.outer)});
    for (const Ring& hole : block.shape.holes) rings.push_back(closed(hole));
    json properties = {{"layer", layer_for({LayerRole::block, block.group})}, {"name", block.name}};
    if (!block.material.empty()) properties["material"] = block.material;
    add(feature(std::move(properties), "Polygon", std::move(rings)));
  }
  for (const ExportedJoint& joint : drawing.joints)
    add(feature({{"layer", layer_for({LayerRole::rock, joint.joint})}}, "LineString",
                json::array({position(joint.from), position(joint.to)})));
  return text + "\n]}\n";
}

std::string dc_numbers(const BlockDrawing& drawing) {
  std::string text = "joints are numbers there: 1 the outline of the blocks";
  int number = 0;
  for (const std::string& joint : dc_joints(drawing))
    text += ++number == 1 ? fmt::format(" and the joint {}", joint) : fmt::format(", {} {}", number, joint);
  return text + "; names of groups and materials are left out";
}

using Writer = std::string (*)(const BlockDrawing&);

struct Format {
  std::string_view extension;
  Writer write;
  Writer names_left_out = nullptr;  // none where all names have a place
};
constexpr std::array<Format, 3> formats{{{".dxf", dxf_text}, {".geojson", geojson_text}, {".dc", dc_text, dc_numbers}}};

const Format* format_of(const std::filesystem::path& file) {
  const auto* const found = std::ranges::find(formats, std::string_view(file.extension().string()), &Format::extension);
  return found == formats.end() ? nullptr : found;
}

}  // namespace

bool is_block_format(const std::filesystem::path& file) { return format_of(file) != nullptr; }

std::string block_file(const std::filesystem::path& file, const BlockDrawing& drawing) {
  return format_of(file)->write(drawing);
}

std::string names_left_out(const std::filesystem::path& file, const BlockDrawing& drawing) {
  const Writer write = format_of(file)->names_left_out;
  return write == nullptr ? "" : write(drawing);
}

}  // namespace dda
