#include "engine/scene/written_scene.h"

#include <fmt/format.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string_view>

#include "engine/scene/json_pieces.h"

namespace dda {
namespace {

using nlohmann::json;

void append_ring(const Ring& ring, std::string& text) {
  append_json_list(
      ring, [](const Vec2& point, std::string& to) { append_json_list(point, append_json_number, to); }, text);
}

// Blocks of one rock, by the entry of the first of them: keys in their order, as the JSON library writes them.
class Polygons {
 public:
  Polygons(const json& first, const std::vector<std::string>& materials)
      : polygon_(first.at("polygon")), materials_(materials) {}

  void append(const Block& block, const std::string& group, std::string& text) const {
    text += "{\"polygon\":{";
    append_own("group", group, text);
    if (!block.shape.holes.empty()) {
      text += ",\"holes\":";
      append_json_list(block.shape.holes, append_ring, text);
    }
    for (const char* key : {"initial_spin", "initial_stress", "initial_velocity"})
      if (polygon_.contains(key)) text += fmt::format(",\"{}\":{}", key, polygon_[key].dump());
    if (polygon_.contains("material"))
      append_next("material", materials_[static_cast<std::size_t>(block.material)], text);
    append_next("name", block.name, text);
    text += ",\"vertices\":";
    append_ring(block.shape.outer, text);
    text += "}}";
  }

 private:
  static void append_own(const char* key, const std::string& value, std::string& text) {
    text += fmt::format("\"{}\":", key);
    append_json_text(value, text);
  }
  static void append_next(const char* key, const std::string& value, std::string& text) {
    text += ',';
    append_own(key, value, text);
  }

  const json& polygon_;
  const std::vector<std::string>& materials_;
};

constexpr std::string_view next_entry = ",\n    ";

void append_blocks(const GivenBlocks& given, const Polygons& polygons, std::string& text) {
  constexpr std::size_t in_part = 1000;
  const auto append_one = [&](std::size_t i, std::string& to) {
    polygons.append(given.blocks[i], given.groups[i], to);
  };
  append_entries(given.blocks.size(), in_part, next_entry, append_one, text);
}

}  // namespace

std::string written_scene(const json& document, const std::vector<GivenBlocks>& given,
                          const std::vector<std::string>& materials) {
  std::string text = "{";
  auto next = given.begin();
  for (const auto& [key, value] : document.items()) {
    text += fmt::format("{}\n  {}: ", text.size() == 1 ? "" : ",", json(key).dump());
    if (!value.is_array() || value.empty()) {
      text += value.dump();
      continue;
    }
    text += '[';
    for (std::size_t i = 0; i < value.size(); ++i) {
      text += i == 0 ? next_entry.substr(1) : next_entry;
      if (key == "blocks" && next != given.end() && next->entry == i)
        append_blocks(*next++, Polygons(value[i], materials), text);
      else
        text += value[i].dump();
    }
    text += "\n  ]";
  }
  text += "\n}\n";
  return text;
}

}  // namespace dda
