#include "engine/drawing/dxf_text.h"

#include <fmt/format.h>

#include <iterator>
#include <set>
#include <utility>

#include "engine/drawing/dxf_names.h"
#include "engine/drawing/layers.h"

namespace dda {
namespace {

class DxfText {
 public:
  std::string write(const BlockDrawing& drawing) {
    header();
    tables(drawing);
    group(0, "SECTION");
    group(2, "ENTITIES");
    for (const ExportedBlock& block : drawing.blocks) {
      polyline(layer_for({LayerRole::block, block.group}), block.material, block.shape.outer);
      for (const Ring& hole : block.shape.holes) polyline(layer_for({LayerRole::block_hole, block.group}), {}, hole);
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

  void tables(const BlockDrawing& drawing) {
    group(0, "SECTION");
    group(2, "TABLES");
    layers(drawing);
    application();
    group(0, "ENDSEC");
  }

  // Extended data must have the name of an application that the file knows.
  void application() {
    group(0, "TABLE");
    group(2, "APPID");
    group(70, 1);
    group(0, "APPID");
    group(2, dxf_application);
    group(70, 0);
    group(0, "ENDTAB");
  }

  static std::set<std::string> names_of_layers(const BlockDrawing& drawing) {
    std::set<std::string> names;
    for (const ExportedBlock& block : drawing.blocks) {
      names.insert(dxf_name(layer_for({LayerRole::block, block.group})));
      if (!block.shape.holes.empty()) names.insert(dxf_name(layer_for({LayerRole::block_hole, block.group})));
    }
    for (const ExportedJoint& joint : drawing.joints) names.insert(dxf_name(layer_for({LayerRole::rock, joint.joint})));
    return names;
  }

  void layers(const BlockDrawing& drawing) {
    constexpr int colours = 7;  // of the standard palette, from red to black
    const std::set<std::string> names = names_of_layers(drawing);
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
  }

  // What the name of the layer has lost, and the material.
  void extended_data(const std::string& layer, const std::string& material) {
    const bool is_whole = named_layer(dxf_name(layer))->name == named_layer(layer)->name;
    if (is_whole && material.empty()) return;
    group(1001, dxf_application);
    if (!is_whole) group(1000, dxf_layer_key + dxf_escaped(layer));
    if (!material.empty()) group(1000, dxf_material_key + dxf_escaped(material));
  }

  void polyline(const std::string& layer, const std::string& material, const Ring& ring) {
    const std::string name = dxf_name(layer);
    group(0, "POLYLINE");
    group(8, name);
    group(66, 1);
    point(10, Vec2::Zero());
    group(70, 1);
    extended_data(layer, material);
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
    const std::string layer = layer_for({LayerRole::rock, joint.joint});
    group(8, dxf_name(layer));
    point(10, joint.from);
    point(11, joint.to);
    extended_data(layer, {});
  }

  std::string text_;
};

}  // namespace

std::string dxf_text(const BlockDrawing& drawing) { return DxfText().write(drawing); }

}  // namespace dda
