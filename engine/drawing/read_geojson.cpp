#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "engine/core/error.h"
#include "engine/drawing/layers.h"
#include "engine/drawing/read_formats.h"

namespace dda {
namespace {

using nlohmann::json;

// Builds no document that is nested more deeply than any GeoJSON is.
json parse(std::string_view text, const std::string& name) {
  constexpr int deepest = 32;
  const auto shallow = [&](int depth, json::parse_event_t, json&) {
    if (depth > deepest) throw InputError("", name, "nested too deeply", "GeoJSON");
    return true;
  };
  try {
    return json::parse(text, shallow);
  } catch (const json::parse_error& error) {
    const auto line = 1 + std::ranges::count(text.substr(0, error.byte), '\n');
    throw InputError("", fmt::format("{} line {}", name, line), "no JSON, or cut off", "GeoJSON");
  } catch (const json::out_of_range&) {
    throw InputError("", name, "with a number beyond all bounds", "GeoJSON with finite numbers");
  }
}

const json& member(const json& object, const char* key) {
  static const json none;
  if (!object.is_object()) return none;
  const auto found = object.find(key);
  return found == object.end() ? none : *found;
}

std::string text_of(const json& value) {
  return value.is_string() ? readable(value.get_ref<const std::string&>()) : "";
}

class GeoJsonReader {
 public:
  GeoJsonReader(LineDrawing& drawing, double metres) : drawing_(drawing), pencil_(drawing), metres_(metres) {}

  void read(const json& document) {
    const std::string type = text_of(member(document, "type"));
    origin_ = drawing_.name;
    if (type == "FeatureCollection") {
      std::size_t number = 0;
      for (const json& feature : list(member(document, "features"), "features"))
        read_feature(feature, fmt::format("{} features[{}]", drawing_.name, number++));
    } else if (type == "Feature") {
      read_feature(document, drawing_.name);
    } else {
      fail("type \"" + type + "\"", "a FeatureCollection or a Feature; layers are properties of features");
    }
  }

 private:
  [[noreturn]] void fail(const std::string& value, const std::string& expected) const {
    throw InputError("", origin_, value, expected);
  }

  [[nodiscard]] const json& list(const json& value, const char* what) const {
    if (!value.is_array()) fail(fmt::format("without a list of {}", what), fmt::format("an array of {}", what));
    return value;
  }

  // One without a place, which GeoJSON allows, draws nothing.
  void read_feature(const json& feature, const std::string& origin) {
    origin_ = origin;
    if (feature.is_object() && feature.contains("geometry") && feature["geometry"].is_null()) {
      ++drawing_.passed_over["feature without geometry"];
      return;
    }
    const json& properties = member(feature, "properties");
    const json& layer = member(properties, properties.contains("layer") ? "layer" : "Layer");  // as GDAL writes it
    if (!layer.is_string()) fail("without a layer", "\"properties\": {\"layer\": NAME}");
    layer_ = text_of(layer);
    material_ = text_of(member(properties, "material"));
    read_geometry(member(feature, "geometry"));
  }

  void read_geometry(const json& geometry) {
    const std::string type = text_of(member(geometry, "type"));
    const json& coordinates = member(geometry, "coordinates");
    if (type == "Point")
      add_point(coordinates);
    else if (type == "LineString")
      add_line(coordinates);
    else if (type == "MultiPoint")
      for_each(coordinates, [this](const json& part) { add_point(part); });
    else if (type == "MultiLineString")
      for_each(coordinates, [this](const json& part) { add_line(part); });
    else if (type == "Polygon")
      add_polygon(coordinates);
    else if (type == "MultiPolygon")
      for_each(coordinates, [this](const json& polygon) { add_polygon(polygon); });
    else if (type == "GeometryCollection")
      for_each(member(geometry, "geometries"), [this](const json& part) { read_geometry(part); });
    else
      fail("of geometry \"" + type + "\"", "Point, LineString, Polygon, their Multi... or GeometryCollection");
  }

  template <typename Read>
  void for_each(const json& parts, Read read) {
    for (const json& part : list(parts, "coordinates or geometries")) read(part);
  }

  // A third coordinate is passed over.
  [[nodiscard]] Vec2 place(const json& position) const {
    if (!position.is_array() || position.size() < 2 || !position[0].is_number() || !position[1].is_number())
      fail("at a position that is not [x, y]", "two numbers");
    return metres_ * Vec2(position[0].get<double>(), position[1].get<double>());
  }

  void add_point(const json& position) { pencil_.add(DrawnPoint{layer_, origin_, place(position)}); }

  // The first ring is the outline, the others are holes in it.
  void add_polygon(const json& rings) {
    const std::string layer = layer_;
    const auto named = named_layer(layer);
    const bool is_block = named && named->role == LayerRole::block;
    for_each(rings, [&](const json& ring) {
      add_line(ring);
      if (is_block) layer_ = layer_for({LayerRole::block_hole, named->name});
    });
    layer_ = layer;
  }

  void add_line(const json& positions) {
    DrawnLine line{layer_, origin_, {}, {}, material_};
    bool first = true;
    for (const json& position : list(positions, "positions")) {
      if (std::exchange(first, false))
        line.start = place(position);
      else
        line.pieces.push_back({place(position), nullptr});
    }
    pencil_.add(std::move(line));
  }

  LineDrawing& drawing_;
  Pencil pencil_;
  double metres_;
  std::string layer_, origin_, material_;
};

// Degrees of longitude and latitude are no lengths. Files that do not name their coordinates are taken to be plans, as
// those of programs of drawing are.
void refuse_degrees(const json& document, const std::string& name) {
  const json::json_pointer place("/crs/properties/name");
  if (!document.is_object() || !document.contains(place) || !document.at(place).is_string()) return;
  const std::string system = document.at(place);
  for (const char* of_degrees : {"CRS84", "EPSG::4326", "EPSG:4326"})
    if (system.find(of_degrees) != std::string::npos)
      throw InputError("", name + " crs", "\"" + readable(system.substr(0, 80)) + "\", degrees",
                       "coordinates of a plan, in lengths");
}

}  // namespace

LineDrawing read_geojson(std::string_view text, const std::string& name, double metres) {
  LineDrawing drawing;
  drawing.name = name;
  const json document = parse(text, name);
  refuse_degrees(document, name);
  GeoJsonReader(drawing, metres > 0 ? metres : 1).read(document);
  return drawing;
}

}  // namespace dda
