#include "engine/app/keyblocks_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "engine/app/block_sheet.h"

namespace dda {
namespace {

// Kinds of blocks as they are drawn: by type, then those that were not asked for.
enum Kind : std::size_t { key, friction_held, stable, tapered, other, taken_out, kinds };
struct Look {
  std::string_view fill, text;
};
constexpr std::array<Look, kinds> looks{{{"#e2725b", "I: key block, moves unless it is held"},
                                         {"#f2c14e", "II: held by friction or cohesion"},
                                         {"#a8cf9e", "III: can be removed, but is pressed onto its neighbours"},
                                         {"#b9cbe0", "IV: has a free face, cannot be removed"},
                                         {"#e9e9e6", "without a free face that was asked for, or held"},
                                         {"#ffffff", "taken out"}}};

std::vector<Kind> kinds_of_blocks(const KeyBlockReport& report, const KeyBlockQuestion& question) {
  std::vector<Kind> kind_of(question.is_void.size(), other);
  for (std::size_t block = 0; block < kind_of.size(); ++block) {
    if (question.is_void[block]) kind_of[block] = taken_out;
  }
  for (const KeyBlock& block : report.blocks) {
    for (const int each : block.body.blocks) kind_of[static_cast<std::size_t>(each)] = static_cast<Kind>(block.type);
  }
  return kind_of;
}

void draw_blocks(const Model& model, const std::vector<Kind>& kind_of, BlockSheet& sheet) {
  std::array<SvgPath, kinds> paths;
  for (std::size_t block = 0; block < kind_of.size(); ++block)
    sheet.append_block(model.blocks[block].shape, paths[kind_of[block]]);
  for (std::size_t kind = 0; kind < kinds; ++kind) sheet.draw_blocks(paths[kind], looks[kind].fill);
}

// The outlines of the bodies asked for: thin where they touch others, thick where they are free.
void draw_outlines(const KeyBlockReport& report, BlockSheet& sheet) {
  SvgPath joints;
  SvgPath free;
  for (const KeyBlock& block : report.blocks) {
    for (const JointFace& face : block.body.joints) sheet.append_line(face.from, face.to, joints);
    for (const FreeFace& face : block.body.free_faces) sheet.append_line(face.from, face.to, free);
  }
  sheet.add("<path d=\"{}\" fill=\"none\" stroke=\"#3d4a57\" stroke-width=\"0.8\"/>\n", joints.text());
  sheet.add("<path d=\"{}\" fill=\"none\" stroke=\"#1a2129\" stroke-width=\"2\"/>\n", free.text());
}

// An arrow along the way that a body slides or falls, and its factor of safety.
void draw_way(const KeyBlock& block, BlockSheet& sheet) {
  if (block.motion.direction == Vec2::Zero()) return;
  const double length = std::clamp(sheet.scale() * std::sqrt(block.body.area) / 2, 8.0, 40.0);  // px
  sheet.draw_arrow(block.body.centroid, block.motion.direction, length);
  const Vec2 start = sheet.place_of(block.body.centroid);
  sheet.add("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"10\" text-anchor=\"middle\">{:.2f}</text>\n", start.x(),
            start.y() - 4, block.motion.factor_of_safety);
}

}  // namespace

std::string keyblocks_picture(const KeyBlockReport& report, const KeyBlockQuestion& question, const Model& model) {
  BlockSheet sheet(model);
  draw_blocks(model, kinds_of_blocks(report, question), sheet);
  draw_outlines(report, sheet);
  for (const KeyBlock& block : report.blocks) draw_way(block, sheet);
  for (const Look& look : looks) sheet.add_area_to_key(look.fill, look.text);
  return sheet.text(420);
}

}  // namespace dda
