// A drawing as read from a file, whatever its format: lines and points on layers. Lengths in m, x right, y up.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/types.h"
#include "engine/drawing/drawn_curve.h"

namespace dda {

// From the end of the piece before: straight, or along a curve.
struct DrawnPiece {
  Vec2 end = Vec2::Zero();
  std::shared_ptr<const DrawnCurve> curve;  // none: straight
};

struct DrawnLine {
  std::string layer;
  std::string origin;  // where it was drawn, for messages: "plan.dxf line 214"
  Vec2 start = Vec2::Zero();
  std::vector<DrawnPiece> pieces;  // one or more; a closed line ends where it starts, to the bit
  std::string material;            // of the block that it outlines, where the drawing says it
};

struct DrawnPoint {
  std::string layer;
  std::string origin;
  Vec2 at = Vec2::Zero();
};

struct LineDrawing {
  std::string name;           // of the file, for messages
  std::string unit;           // of its coordinates by what the file says: "mm"; empty where it says none
  double metres_of_unit = 0;  // 0 there
  // No layer has the boundary: the rock is what the lines enclose, as for dc of the original DDA.
  bool encloses = false;
  std::vector<DrawnLine> lines;
  std::vector<DrawnPoint> points;
  std::map<std::string, int> passed_over;  // how many there were of each kind that is no line or point: "TEXT"
  // Names of layers that differ from another in capitals only, with that other, which stands for both.
  std::map<std::string, std::string> other_spellings;
};

inline bool is_closed(const DrawnLine& line) { return line.pieces.back().end == line.start; }

// Coordinates beyond this are refused, as for polygons.
inline constexpr double farthest_drawn = 1e12;  // m

// More lines and points than this are refused: a few bytes of nested symbols can stand for any number of them.
inline constexpr std::size_t most_drawn = 4'000'000;

// Appends to a drawing, with the checks that all formats share. Throws InputError.
class Pencil {
 public:
  explicit Pencil(LineDrawing& drawing) : drawing_(drawing) {}
  void add(DrawnLine line);
  void add(DrawnPoint point);

 private:
  void check(const Vec2& point, const std::string& origin) const;
  void count(const std::string& origin);
  LineDrawing& drawing_;
};

// Takes layers whose names differ in capitals only for one, which has the name that comes first: lines, then points.
void take_spellings_as_one(LineDrawing& drawing);

// Letters from A to Z in lower case.
std::string in_lower_case(std::string_view text);

// `text` as UTF-8 without control characters; other bytes are taken as Latin-1.
std::string readable(std::string_view text);

}  // namespace dda
