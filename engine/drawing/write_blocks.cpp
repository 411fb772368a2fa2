#include "engine/drawing/write_blocks.h"

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

using Writer = std::string (*)(const BlockDrawing&);

struct Format {
  std::string_view extension;
  Writer write;
};
constexpr std::array<Format, 3> formats{{{".dxf", dxf_text}, {".geojson", geojson_text}, {".dc", dc_text}}};

const Format* format_of(const std::filesystem::path& file) {
  const auto* const found = std::ranges::find(formats, std::string_view(file.extension().string()), &Format::extension);
  return found == formats.end() ? nullptr : found;
}

}  // namespace

bool is_block_format(const std::filesystem::path& file) { return format_of(file) != nullptr; }

std::string block_file(const std::filesystem::path& file, const BlockDrawing& drawing) {
  return format_of(file)->write(drawing);
}

}  // namespace dda
