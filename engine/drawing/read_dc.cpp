// Lines as dl of the original DDA writes them and dc reads them, in the layout of the reader of "DDA for Windows" of
// the University of California, Berkeley (ntdda, src/geomreader.c, which says it is that of Shi's program in C):
// numbers, and blanks or ends of lines between them.
//
//   least distance of a node from an edge, as a share of the size of the rock
//   number of lines, of those that bound the rock; of material lines; bolts; fixed lines; load, measured and hole
//   points x1 y1 x2 y2 and number of joint material of each line x1 y1 x2 y2 and number of block material of each
//   material line x1 y1 x2 y2 of each fixed line, both ends the same for a fixed point x y of each load point, measured
//   point and hole point
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/core/error.h"
#include "engine/drawing/number_list.h"
#include "engine/drawing/read_formats.h"
#include "engine/geometry/segment_crossing.h"

namespace dda {
namespace {

struct Counts {
  int lines = 0, material_lines = 0, fixed = 0, loads = 0, measured = 0, holes = 0;
};

class DcReader {
 public:
  DcReader(std::string_view text, const std::string& name, double metres) : numbers_(text, name), metres_(metres) {
    drawing_.name = name;
    drawing_.encloses = true;
  }

  LineDrawing read() {
    const Counts counts = read_counts();
    for (int i = 0; i < counts.lines; ++i) read_line();
    for (int i = 0; i < counts.material_lines; ++i) pass_material_line();
    for (int i = 0; i < counts.fixed; ++i) read_fixed();
    for (int i = 0; i < counts.loads; ++i) read_point("load point");
    for (int i = 0; i < counts.measured; ++i) read_point("measure point");
    for (int i = 0; i < counts.holes; ++i) read_point("hole point");
    numbers_.expect_end("the last point",
                        "as many numbers as the counts at the top ask for; files of other versions of dc have others");
    return std::move(drawing_);
  }

 private:
  Counts read_counts() {
    const double least = numbers_.number("the least distance of a node from an edge");
    if (least < 0 || least >= 1)
      throw InputError("", numbers_.here(), fmt::format("{:g} for the least distance of a node from an edge", least),
                       "a share from 0 to 1");
    Counts counts;
    counts.lines = numbers_.whole("the number of lines");
    numbers_.whole("the number of lines that bound the rock");
    counts.material_lines = numbers_.whole("the number of material lines");
    if (const int bolts = numbers_.whole("the number of bolts"); bolts > 0)
      throw InputError("", numbers_.here(), fmt::format("{} bolts", bolts),
                       "none: give bolts in the scene, as versions of dc differ in how they write them");
    counts.fixed = numbers_.whole("the number of fixed lines");
    counts.loads = numbers_.whole("the number of load points");
    counts.measured = numbers_.whole("the number of measured points");
    counts.holes = numbers_.whole("the number of hole points");
    return counts;
  }

  Vec2 place(const char* what) {
    const double x = numbers_.number(what);
    return metres_ * Vec2(x, numbers_.number(what));
  }

  void read_line() {
    const Vec2 from = place("the start of a line");
    const Vec2 to = place("the end of a line");
    const int material = numbers_.whole("the joint material of a line");
    pencil_.add(DrawnLine{fmt::format("joint {}", material), numbers_.here(), from, {{to, nullptr}}, ""});
  }

  void pass_material_line() {
    place("the start of a material line");
    place("the end of a material line");
    numbers_.whole("the block material of a line");
    ++drawing_.passed_over["material line"];
  }

  void read_point(const char* layer) {
    const Vec2 at = place(layer);
    pencil_.add(DrawnPoint{layer, numbers_.here(), at});
  }

  // dc fixes blocks where the line enters and leaves them; a line inside of a block holds it at its start.
  void read_fixed() {
    const Vec2 from = place("the start of a fixed line");
    const Segment fixed{from, place("the end of a fixed line")};
    std::vector<double> shares;
    for (const DrawnLine& line : drawing_.lines) {
      if (const auto share = share_at_crossing(fixed, {line.start, line.pieces.front().end})) shares.push_back(*share);
    }
    std::ranges::sort(shares);
    constexpr double one_place = 1e-9;  // of the line: two joints that cross there
    const auto is_same = [](double a, double b) { return b - a < one_place; };
    shares.erase(std::unique(shares.begin(), shares.end(), is_same), shares.end());
    if (shares.empty()) shares.push_back(0);
    for (const double share : shares) pencil_.add(DrawnPoint{"fix point", numbers_.here(), point_at(fixed, share)});
  }

  NumberList numbers_;
  double metres_;
  LineDrawing drawing_;
  Pencil pencil_{drawing_};
};

}  // namespace

LineDrawing read_dc(std::string_view text, const std::string& name, double metres) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && text[first] == '<')
    throw InputError("", name, "XML, as later versions of DDA for Windows have it", "the numbers of a file for dc");
  return DcReader(text, name, metres > 0 ? metres : 1).read();
}

}  // namespace dda
