#include "engine/app/block_layers.h"

#include <array>
#include <cstddef>
#include <string_view>

namespace dda {
namespace {

constexpr std::array<std::string_view, 8> fills{"#dfe7ee", "#f3dfc1", "#d3e8d0", "#ecd6e6",
                                                "#f4ebb5", "#cfe4e8", "#e5d9cf", "#d9d9f0"};
constexpr std::array<std::string_view, 8> strokes{"#3d4a57", "#c2410c", "#1d6fb8", "#15803d",
                                                  "#9333ea", "#b45309", "#0f766e", "#be123c"};

}  // namespace

void BlockLayers::draw() {
  std::size_t number = 0;
  for (const auto& [kind, path] : areas_)
    sheet_.add("<path d=\"{}\" fill=\"{}\" fill-rule=\"evenodd\" stroke=\"#8a96a3\" stroke-width=\"0.4\"/>\n",
               path.text(), fills[number++ % fills.size()]);
  number = 0;
  for (const auto& [name, path] : runs_)
    sheet_.add("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1\"/>\n", path.text(),
               strokes[number++ % strokes.size()]);
}

void BlockLayers::draw_key() {
  std::size_t number = 0;
  for (const auto& [kind, path] : areas_) sheet_.add_area_to_key(fills[number++ % fills.size()], kind);
  number = 0;
  for (const auto& [name, path] : runs_) sheet_.add_line_to_key(strokes[number++ % strokes.size()], "joint " + name);
}

}  // namespace dda
