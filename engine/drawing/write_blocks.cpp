#include "engine/drawing/write_blocks.h"

#include "engine/drawing/dc_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

namespace dda {
namespace {

using nlohmann::json;

// A name that release 12 takes: up to 31 of these characters.
std::string dxf_name(const std::string& name) {
  constexpr std::size_t longest = 31;
  std::string text;
  for (const char c : name.substr(0, longest)) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    text += letter || c == '-' ? c : '_';
  }
  return text;
}

class DxfText {
 public:
  std::string write(const BlockDrawing& drawing) {
    header();
    layers(drawing);
    group(0, "SECTION");
    group(2, "ENTITIES");
    for (const ExportedBlock& block : drawing.blocks) {
      polyline(block.layer, block.shape.outer);
      for (const Ring& hole : block.shape.holes) polyline(block.layer, hole);
    }
    for (const ExportedJoint& joint : drawing.joints) line(joint);
    group(0, "ENDSEC");
    group(0, "EOF");
    return std::move(text_);
  }

 private:
  template <typename Value>
  void group(int code, const Value& value) {
    fmt::format_to(std::back_inserter(text_), "{}\n{}\n", code, value);
  }

  void point(int x_code, const Vec2& place) {
    group(x_code, place.x());
    group(x_code + 10, place.y());
    group(x_code + 20, 0.0);
  }

  void header() {
    constexpr int metres = 6;
    group(0, "SECTION");
    group(2, "HEADER");
    group(9, "$ACADVER");
    group(1, "AC1009");
    group(9, "$INSUNITS");
    group(70, metres);
    group(0, "ENDSEC");
  }

  void layers(const BlockDrawing& drawing) {
    constexpr int colours = 7;  // of the standard palette, from red to black
    std::set<std::string> names;
    for (const ExportedBlock& block : drawing.blocks) names.insert(dxf_name(block.layer));
    for (const ExportedJoint& joint : drawing.joints) names.insert(dxf_name(joint.layer));
    group(0, "SECTION");
    group(2, "TABLES");
    group(0, "TABLE");
    group(2, "LAYER");
    group(70, names.size());
    int colour = 0;
    for (const std::string& name : names) {
      group(0, "LAYER");
      group(2, name);
      group(70, 0);
      group(62, 1 + colour++ % colours);
      group(6, "CONTINUOUS");
    }
    group(0, "ENDTAB");
    group(0, "ENDSEC");
  }

  void polyline(const std::string& layer, const Ring& ring) {
    const std::string name = dxf_name(layer);
    group(0, "POLYLINE");
    group(8, name);
    group(66, 1);
    point(10, Vec2::Zero());
    group(70, 1);
    for (const Vec2& vertex : ring) {
      group(0, "VERTEX");
      group(8, name);
      point(10, vertex);
    }
    group(0, "SEQEND");
    group(8, name);
  }

  void line(const ExportedJoint& joint) {
    group(0, "LINE");
    group(8, dxf_name(joint.layer));
    point(10, joint.from);
    point(11, joint.to);
  }

  std::string text_;
};

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

std::string dxf_text(const BlockDrawing& drawing) { return DxfText().write(drawing); }

// One feature a line.
std::string geojson_text(const BlockDrawing& drawing) {
  std::string text = "{\"type\": \"FeatureCollection\", \"features\": [";
  const char* before = "\n";
  const auto add = [&](const json& each) { text += std::exchange(before, ",\n") + each.dump(); };
  for (const ExportedBlock& block : drawing.blocks) {
    json rings = json::array({closed(block.shape.outer)});
    for (const Ring& hole : block.shape.holes) rings.push_back(closed(hole));
    add(feature({{"layer", block.layer}, {"name", block.name}}, "Polygon", std::move(rings)));
  }
  for (const ExportedJoint& joint : drawing.joints)
    add(feature({{"layer", joint.layer}}, "LineString", json::array({position(joint.from), position(joint.to)})));
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
