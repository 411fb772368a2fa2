#include "engine/app/statistics_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>
#include <vector>

#include "engine/cutting/rock_statistics.h"
#include "engine/record/vtp_file.h"
#include "engine/view/line_plot.h"

namespace dda {
namespace {

constexpr double panel_width = 560, panel_height = 250;  // px
constexpr double first_line = 24, row_height = 20;       // px, of the text above
constexpr std::size_t most_points = 400;                 // of a curve

struct Sizes {
  std::vector<double> areas, aspects, lengths;
  std::vector<CutJoint> joints;
};

Sizes sizes_of(const CutScene& scene, const CutFigures& figures) {
  Sizes sizes;
  for (const BlockShape& shape : figures.shapes) {
    sizes.areas.push_back(shape.area);
    sizes.aspects.push_back(shape.aspect);
  }
  for (const CutEntry& entry : scene.entries) {
    for (const CutJoint& run : entry.cut.joints) sizes.lengths.push_back((run.to - run.from).norm());
    sizes.joints.insert(sizes.joints.end(), entry.cut.joints.begin(), entry.cut.joints.end());
  }
  return sizes;
}

// The next of 1, 2 and 5 times the powers of ten that is not above `value`, or not below it.
double rounded(double value, bool down) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  constexpr double round_off = 1e-9;
  double last = power;
  for (const double digit : {1.0, 2.0, 5.0, 10.0}) {
    if (down && digit * power > value * (1 + round_off)) return last;
    if (!down && digit * power >= value * (1 - round_off)) return digit * power;
    last = digit * power;
  }
  return last;
}

// Percentages of the values that are no larger than each of them, and of their sum that those make up.
LinePlot shares_below(const std::string& title, const std::string& across, const std::string& unit,
                      std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const double sum = std::reduce(values.begin(), values.end());
  LinePlot plot{title, "%", {}, {{"their number", {}}, {"their sum", {}}}, false, across, unit, true};
  const auto add = [&](double value, double of_number, double of_sum) {
    plot.times.push_back(value);
    plot.lines[0].values.push_back(100 * of_number);
    plot.lines[1].values.push_back(100 * of_sum);
  };
  add(rounded(values.front(), true), 0, 0);
  const std::size_t every = std::max<std::size_t>(1, values.size() / most_points);
  double below = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    below += values[i];
    if (i % every == 0 || i + 1 == values.size())
      add(values[i], static_cast<double>(i + 1) / static_cast<double>(values.size()), below / sum);
  }
  add(rounded(values.back(), false), 1, 1);
  return plot;
}

std::string placed(std::size_t panel, double above, const std::string& svg) {
  const std::size_t column = panel % 2, row = panel / 2;
  const double x = static_cast<double>(column) * panel_width;
  const double y = above + static_cast<double>(row) * panel_height;
  return fmt::format("<svg x=\"{:.0f}\" y=\"{:.0f}\" width=\"{:.0f}\" height=\"{:.0f}\" {}", x, y, panel_width - 10,
                     panel_height - 6, svg.substr(std::string_view("<svg ").size()));
}

// Wedges to both sides, since a run has no sense.
std::string rose(const std::vector<CutJoint>& joints) {
  constexpr double radius = 96, middle_x = 280, middle_y = 134;  // px
  std::string svg = fmt::format(
      "<svg viewBox=\"0 0 {:.0f} {:.0f}\"><text x=\"20\" y=\"18\">directions of joints, by their length</text>\n"
      "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"none\" stroke=\"#dde3e9\"/>\n",
      panel_width, panel_height, middle_x, middle_y, radius);
  const std::vector<double> shares = length_rose(joints);
  const double largest = *std::max_element(shares.begin(), shares.end());
  const double wedge = std::numbers::pi / static_cast<double>(shares.size());
  for (std::size_t i = 0; i < 2 * shares.size(); ++i) {
    const double length = largest > 0 ? radius * std::sqrt(shares[i % shares.size()] / largest) : 0;
    if (length == 0) continue;
    const double begin = static_cast<double>(i) * wedge, end = begin + wedge;
    fmt::format_to(std::back_inserter(svg),
                   "<path d=\"M{0} {1}L{2:.1f} {3:.1f}A{4:.1f} {4:.1f} 0 0 0 {5:.1f} {6:.1f}Z\" fill=\"#1f5fa8\" "
                   "fill-opacity=\"0.55\" stroke=\"#1f5fa8\"/>\n",
                   middle_x, middle_y, middle_x + length * std::cos(begin), middle_y - length * std::sin(begin), length,
                   middle_x + length * std::cos(end), middle_y - length * std::sin(end));
  }
  const std::string note = fmt::format("largest wedge: {:.3g} % of the length", 100 * largest);
  return svg + fmt::format("<text x=\"20\" y=\"{:.0f}\">{}</text></svg>\n", panel_height - 10, note);
}

std::string numbers_of(const CutEntry& entry, const RockStatistics& statistics) {
  return fmt::format(
      "{}: {} blocks, mean area {:.3g} m2, P20 {:.3g} /m2, P21 {:.3g} /m, RQD {:.0f} % (level lines), {:.0f} % "
      "(upright)",
      entry.rock.group.name, entry.cut.blocks.size(), statistics.mean_area, statistics.p20, statistics.p21,
      100 * statistics.rqd_level, 100 * statistics.rqd_upright);
}

}  // namespace

std::string statistics_picture(const CutScene& scene, const CutFigures& figures) {
  const Sizes sizes = sizes_of(scene, figures);
  const double above = first_line + row_height * static_cast<double>(scene.entries.size());
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "font-family=\"'Source Sans 3', 'Segoe UI', Arial, sans-serif\" font-size=\"13\" fill=\"#1a2129\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      2 * panel_width, above + 2 * panel_height);
  double y = first_line;
  for (std::size_t i = 0; i < scene.entries.size(); ++i) {
    const std::string numbers = numbers_of(scene.entries[i], figures.statistics[i]);
    svg += fmt::format("<text x=\"20\" y=\"{:.0f}\">{}</text>\n", y, xml_escaped(numbers));
    y += row_height;
  }
  std::size_t panel = 0;
  svg += placed(panel++, above, svg_plot(shares_below("blocks that are smaller", "area", "m2", sizes.areas)));
  svg += placed(panel++, above, svg_plot(shares_below("blocks that are less slender", "aspect", "-", sizes.aspects)));
  if (!sizes.lengths.empty()) {
    svg +=
        placed(panel++, above, svg_plot(shares_below("runs of joints that are shorter", "length", "m", sizes.lengths)));
    svg += placed(panel++, above, rose(sizes.joints));
  }
  return svg + "</svg>\n";
}

}  // namespace dda
