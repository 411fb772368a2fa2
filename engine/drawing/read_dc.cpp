// Lines as dl of the original DDA writes them and dc reads them, in the layout of the reader of "DDA for Windows" of
// the University of California, Berkeley (ntdda, src/geomreader.c, which says it is that of Shi's program in C):
// numbers, and blanks or ends of lines between them.
//
//   least distance of a node from an edge, as a share of the size of the rock
//   number of lines, of those that bound the rock; of material lines; bolts; fixed lines; load, measured and hole
//   points x1 y1 x2 y2 and number of joint material of each line x1 y1 x2 y2 and number of block material of each
//   material line x1 y1 x2 y2 of each fixed line, both ends the same for a fixed point x y of each load point, measured
//   point and hole point
//
// The dc that has absorbing edges and stages of excavation reads another layout, which Appendix A of the thesis writes
// (fprintf by fprintf; the rock's lines have material 1, absorbing ones are among them a second time):
//
//   least distance
//   number of lines, of those that bound the rock
//   number of material lines, bolts, fixed lines, load, measured and hole points, bolts again, points in blocks to be
//   removed
//   lines, fixed lines, points, as above; points in blocks to be removed
//   twice 1, by which the speed of waves is reduced at absorbing lines; number of absorbing lines; x1 y1 x2 y2 of each
//   number of traction lines
//
// No word in a file says which layout it has. How many numbers follow the counts does.
#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/drawing/number_list.h"
#include "engine/drawing/number_text.h"
#include "engine/drawing/read_formats.h"
#include "engine/geometry/segment_crossing.h"

namespace dda {
namespace {

struct Counts {
  int lines = 0, material_lines = 0, fixed = 0, loads = 0, measured = 0, holes = 0, removed = 0;
};

// Up to the first word that is no number.
std::vector<double> all_numbers(std::string_view text, const std::string& name) {
  NumberList list(text, name);
  std::vector<double> numbers;
  while (!list.at_end()) {
    const auto number = number_in<double>(list.word());
    if (!number) break;
    numbers.push_back(*number);
  }
  return numbers;
}

// How many numbers there are up to the last point, `head` of which are the distance and counts.
double up_to_points(const std::vector<double>& numbers, std::size_t head, double removed) {
  const double points = numbers[6] + numbers[7] + numbers[8] + removed;
  return static_cast<double>(head) + 5 * (numbers[1] + numbers[3]) + 4 * numbers[5] + 2 * points;
}

// Whether a file has just as many numbers as the layout of Appendix A asks for, and not as many as the other one.
bool is_of_the_appendix(std::string_view text, const std::string& name) {
  const std::vector<double> numbers = all_numbers(text, name);
  constexpr std::size_t head = 11, foot = 4, original_head = 9;  // foot: two ratios and two counts
  const auto count = static_cast<double>(numbers.size());
  if (numbers.size() < head + foot || up_to_points(numbers, original_head, 0) == count) return false;
  const double before = up_to_points(numbers, head, numbers[10]);
  const double absorbing = (count - before - foot) / 4;
  return before >= head && absorbing >= 0 && numbers[static_cast<std::size_t>(before) + 2] == absorbing;
}

class DcReader {
 public:
  DcReader(std::string_view text, const std::string& name, double metres)
      : numbers_(text, name), metres_(metres), of_the_appendix_(is_of_the_appendix(text, name)) {
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
    for (int i = 0; i < counts.removed; ++i) read_point("removable hole");
    if (of_the_appendix_) read_absorbing_lines();
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
    expect_no_bolts();
    counts.fixed = numbers_.whole("the number of fixed lines");
    counts.loads = numbers_.whole("the number of load points");
    counts.measured = numbers_.whole("the number of measured points");
    counts.holes = numbers_.whole("the number of hole points");
    if (!of_the_appendix_) return counts;
    expect_no_bolts();
    counts.removed = numbers_.whole("the number of points in blocks to be removed");
    return counts;
  }

  void expect_none(const char* what, const char* expected) {
    if (const int count = numbers_.whole(fmt::format("the number of {}", what).c_str()); count > 0)
      throw InputError("", numbers_.here(), fmt::format("{} {}", count, what), expected);
  }

  void expect_no_bolts() {
    expect_none("bolts", "none: give bolts in the scene, as versions of dc differ in how they write them");
  }

  void read_absorbing_lines() {
    for (int i = 0; i < 2; ++i) {
      const double ratio = numbers_.number("the ratio by which the speed of waves is reduced");
      if (ratio != 1)
        throw InputError("", numbers_.here(),
                         fmt::format("{:g} for the ratio by which the speed of waves is reduced", ratio),
                         "1: edges absorb at the speed of the rock's own waves");
    }
    const int count = numbers_.whole("the number of absorbing lines");
    for (int i = 0; i < count; ++i) read_absorbing_line();
    expect_none("traction lines", "none: give tractions as loads in the scene");
  }

  void read_absorbing_line() {
    const Vec2 from = place("the start of an absorbing line");
    const Vec2 to = place("the end of an absorbing line");
    pencil_.add(DrawnLine{"absorbing boundary", numbers_.here(), from, {{to, nullptr}}, ""});
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
  bool of_the_appendix_;
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
