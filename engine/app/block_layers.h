// Blocks in the colour of their kind and joints in that of their name, with a key: what pictures of cut rock and of
// scenes share.
#pragma once

#include <map>
#include <string>

#include "engine/app/block_sheet.h"

namespace dda {

class BlockLayers {
 public:
  explicit BlockLayers(BlockSheet& sheet) : sheet_(sheet) {}

  void add_block(const std::string& kind, const Polygon& shape) { sheet_.append_block(shape, areas_[kind]); }
  void add_joint(const std::string& name, const Vec2& from, const Vec2& to) {
    sheet_.append_line(from, to, runs_[name]);
  }

  // Joints lie on top of all blocks.
  void draw();
  void draw_key();

 private:
  BlockSheet& sheet_;
  std::map<std::string, SvgPath> areas_, runs_;
};

}  // namespace dda
