#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "engine/core/error.h"
#include "engine/drawing/drawn_units.h"
#include "engine/drawing/dxf_file.h"
#include "engine/drawing/dxf_shapes.h"
#include "engine/drawing/read_formats.h"

namespace dda {
namespace {

// Draws the entities of a file, and those of its symbols wherever they are put.
class DxfDraughtsman {
 public:
  DxfDraughtsman(const DxfFile& file, LineDrawing& drawing) : file_(file), drawing_(drawing), pencil_(drawing) {}

  void draw(std::span<const DxfEntity> entities, const DxfPlacement& placement, int depth) {
    while (!entities.empty()) {
      const DxfEntity& entity = entities.front();
      std::size_t taken = 1;
      if (entity.whole(67) == 1)
        ++drawing_.passed_over["paper space"];
      else if (entity.type() == "INSERT")
        insert(entity, placement, depth);
      else
        taken = shape(entities, placement);
      entities = entities.subspan(taken);
    }
  }

 private:
  std::size_t shape(std::span<const DxfEntity> entities, const DxfPlacement& placement) {
    const std::size_t taken = draw_shape(entities, placement, pencil_);
    if (taken > 0) return taken;
    const std::string_view type = entities.front().type();
    const bool belongs_to_another = type == "SEQEND" || type == "VERTEX";
    if (!belongs_to_another) ++drawing_.passed_over[type == "LWPOLYLINE" ? "LWPOLYLINE of one point" : readable(type)];
    return 1;
  }

  // Rows and columns of a symbol: their spacing is turned with it, and not scaled.
  void insert(const DxfEntity& entity, const DxfPlacement& placement, int depth) {
    constexpr int deepest = 16;
    if (depth == deepest) fail(entity, "symbols in symbols more than 16 deep", "fewer; a symbol may not hold itself");
    const std::string name = entity.text(2);
    const auto block = file_.blocks.find(name);
    if (block == file_.blocks.end()) fail(entity, fmt::format("symbol \"{}\"", name), "a block of the drawing");
    const int columns = std::max(1, entity.whole(70, 1));
    const int rows = std::max(1, entity.whole(71, 1));
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const Vec2 offset(column * entity.number(44), row * entity.number(45));
        put(entity, block->second, offset, placement, depth);
      }
    }
  }

  void put(const DxfEntity& entity, const DxfBlock& block, const Vec2& offset, const DxfPlacement& outer, int depth) {
    constexpr int most_symbols = 1'000'000;
    if (++symbols_ > most_symbols) fail(entity, "one symbol too many", fmt::format("at most {}", most_symbols));
    const double angle = std::numbers::pi / 180 * entity.number(50);
    const Mat2 view = seen_from_above(entity);
    const Mat2 rotation = Eigen::Rotation2Dd(angle).toRotationMatrix();
    const Mat2 turn = view * rotation * Vec2(entity.number(41, 1), entity.number(42, 1)).asDiagonal();
    DxfPlacement inner;
    inner.turn = outer.turn * turn;
    inner.shift = outer.at(view * (entity.needed_point(10) + rotation * offset) - turn * block.base);
    inner.layer = layer_of(entity, outer);
    draw(block.entities, inner, depth + 1);
  }

  [[noreturn]] static void fail(const DxfEntity& entity, const std::string& value, const std::string& expected) {
    throw InputError("", entity.origin() + " (INSERT)", value, expected);
  }

  const DxfFile& file_;
  LineDrawing& drawing_;
  Pencil pencil_;
  int symbols_ = 0;
};

void note_unit(int code, LineDrawing& drawing) {
  const auto found = std::ranges::find(drawn_units, code, &DrawnUnit::code);
  if (found == drawn_units.end()) return;
  drawing.unit = found->symbol;
  drawing.metres_of_unit = found->metres;
}

double metres_of(int code, const LineDrawing& drawing) {
  if (code == 0) return 1;
  if (drawing.unit.empty())
    throw InputError("", drawing.name + ", $INSUNITS", fmt::format("{}", code),
                     "a unit from mil to mi, or one that is said: --unit mm, in a scene \"unit\": \"mm\"");
  return drawing.metres_of_unit;
}

}  // namespace

LineDrawing read_dxf(std::string_view text, const std::string& name, double metres) {
  LineDrawing drawing;
  drawing.name = name;
  const DxfFile file = parse_dxf(text, name);
  note_unit(file.unit, drawing);
  DxfPlacement paper;
  paper.turn *= metres > 0 ? metres : metres_of(file.unit, drawing);
  DxfDraughtsman(file, drawing).draw(file.entities, paper, 0);
  return drawing;
}

}  // namespace dda
