#include "engine/view/line_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "engine/record/vtp_file.h"
#include "engine/view/colour_scale.h"
#include "engine/view/svg_path.h"

namespace dda {
namespace {

constexpr double width = 640, height = 260;  // px
constexpr double left = 78, right = 12, top = 34, bottom = 44;
constexpr double line_of_key = 18, above_key = 8;  // px
constexpr double decades = 12;                     // of a logarithmic plot, below its largest value
constexpr double headroom = 0.05;                  // of the range, above and below
constexpr std::array<std::string_view, 8> colours = {"#1f5fa8", "#c4471d", "#2e8540", "#8a4fa3",
                                                     "#b8860b", "#0f8b8d", "#d1497f", "#5b6570"};

// Lines beyond the colours are dashed.
std::string stroke_of(std::size_t line) {
  return fmt::format("stroke=\"{}\"{}", colours[line % colours.size()],
                     line < colours.size() ? "" : " stroke-dasharray=\"6 4\"");
}

struct Axis {
  double low = 0, high = 1;  // as drawn: of a logarithmic plot the powers of ten
  double from = 0, to = 1;   // px
  [[nodiscard]] double place(double value) const { return from + (value - low) / (high - low) * (to - from); }
};

double drawn_value(const LinePlot& plot, double value) {
  if (!plot.logarithmic) return value;
  return value == 0 ? std::numeric_limits<double>::quiet_NaN() : std::log10(std::abs(value));
}

double drawn_across(const LinePlot& plot, double across) {
  return plot.logarithmic_across ? std::log10(across) : across;
}

Axis across_axis(const LinePlot& plot) {
  Axis axis{0, 1, left, width - right};
  if (!plot.times.empty()) axis.low = drawn_across(plot, plot.times.front());
  if (!plot.times.empty()) axis.high = drawn_across(plot, plot.times.back());
  if (!(axis.high > axis.low)) axis.high = axis.low + 1;
  return axis;
}

Axis value_axis(const LinePlot& plot) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const PlottedLine& line : plot.lines) {
    for (const double each : line.values) {
      const double value = drawn_value(plot, each);
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (low > high) low = high = 0;
  if (plot.logarithmic) return {std::max(std::floor(low), std::ceil(high) - decades), std::ceil(high), 0, 0};
  const double alone = high == 0 ? 1 : headroom * std::abs(high);  // of a line that is level
  const double room = high > low ? headroom * (high - low) : alone;
  return {low - room, high + room, 0, 0};
}

double step_of(const std::vector<double>& marks) { return marks.size() > 1 ? marks[1] - marks[0] : 1; }

void append_text(double x, double y, std::string_view anchor, std::string_view text, std::string& svg) {
  svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor, xml_escaped(text));
}

void append_rule(const Vec2& from, const Vec2& to, std::string& svg) {
  svg += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#dde3e9\"/>\n", from.x(), from.y(), to.x(),
                     to.y());
}

void append_mark_across(double x, double foot, std::string_view text, std::string& svg) {
  append_rule({x, top}, {x, foot}, svg);
  append_text(x, foot + 16, "middle", text, svg);
}

// 1, 2 and 5 times the powers of ten.
void append_powers_across(const Axis& axis, double foot, std::string& svg) {
  for (double power = std::floor(axis.low); power <= axis.high; ++power) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double mark = power + std::log10(digit);
      if (mark < axis.low || mark > axis.high) continue;
      append_mark_across(axis.place(mark), foot, fmt::format("{:.4g}", digit * std::pow(10, power)), svg);
    }
  }
}

void append_across_axis(const LinePlot& plot, const Axis& axis, double foot, std::string& svg) {
  ScaledUnit unit{1, plot.across_unit};
  if (plot.logarithmic_across) {
    append_powers_across(axis, foot, svg);
  } else {
    unit = scaled_unit(plot.across_unit, std::max(std::abs(axis.low), std::abs(axis.high)));
    const std::vector<double> marks = ticks(axis.low / unit.factor, axis.high / unit.factor, 7);
    for (const double mark : marks)
      append_mark_across(axis.place(mark * unit.factor), foot, label(mark, step_of(marks)), svg);
  }
  append_text((axis.from + axis.to) / 2, foot + 34, "middle", fmt::format("{} ({})", plot.across, unit.name), svg);
}

void append_value_axis(const LinePlot& plot, const Axis& axis, std::string& svg) {
  const bool plain = plot.unit.empty() || plot.unit == "-";
  const ScaledUnit unit = plain || plot.logarithmic
                              ? ScaledUnit{1, plot.unit}
                              : scaled_unit(plot.unit, std::max(std::abs(axis.low), std::abs(axis.high)));
  const std::vector<double> marks = ticks(axis.low / unit.factor, axis.high / unit.factor, 5);
  for (const double mark : marks) {
    if (plot.logarithmic && mark != std::round(mark)) continue;
    const double y = axis.place(mark * unit.factor);
    append_rule({left, y}, {width - right, y}, svg);
    const std::string text = plot.logarithmic ? fmt::format("1e{:.0f}", mark) : label(mark, step_of(marks));
    append_text(left - 6, y + 4, "end", text, svg);
  }
  append_text(left, 18, "start", plain ? plot.title : fmt::format("{} ({})", plot.title, unit.name), svg);
}

void append_line(const LinePlot& plot, const PlottedLine& line, const Axis& across, const Axis& value,
                 std::string_view stroke, std::string& svg) {
  SvgPath path;
  bool drawing = false;
  for (std::size_t i = 0; i < line.values.size(); ++i) {
    const double drawn = drawn_value(plot, line.values[i]);
    if (!std::isfinite(drawn)) {
      drawing = false;
      continue;
    }
    const Vec2 place(across.place(drawn_across(plot, plot.times[i])), value.place(std::max(drawn, value.low)));
    if (line.is_dots) path.move_to(place);
    if (drawing || line.is_dots) {
      path.line_to(place);
    } else {
      path.move_to(place);
    }
    drawing = true;
  }
  svg += fmt::format("<path d=\"{}\" fill=\"none\" {} stroke-width=\"{}\" stroke-linejoin=\"round\"{}/>\n", path.text(),
                     stroke, line.is_dots ? 4 : 1.6, line.is_dots ? " stroke-linecap=\"round\"" : "");
}

void append_key(const LinePlot& plot, double foot, std::string& svg) {
  if (plot.lines.size() < 2) return;
  for (std::size_t i = 0; i < plot.lines.size(); ++i) {
    const double x = left + static_cast<double>(i % 4) * (width - left - right) / 4;
    const std::size_t row = i / 4;
    const double y = foot + bottom + above_key + line_of_key * static_cast<double>(row);
    svg += fmt::format("<path d=\"M{:.1f} {:.1f}h18\" {} stroke-width=\"2.5\"/>", x, y - 4, stroke_of(i));
    append_text(x + 24, y, "start", plot.lines[i].name, svg);
  }
}

}  // namespace

std::string svg_plot(const LinePlot& plot) {
  const double rows = plot.lines.size() < 2 ? 0 : std::ceil(static_cast<double>(plot.lines.size()) / 4);
  const double foot = height - bottom;
  std::string svg = fmt::format(
      "<svg class=\"plot\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" "
      "font-family=\"'Source Sans 3', 'Segoe UI', Arial, sans-serif\" font-size=\"13\" fill=\"#1a2129\">\n",
      width, height + (rows > 0 ? above_key + rows * line_of_key : 0));
  const Axis across = across_axis(plot);
  Axis value = value_axis(plot);
  if (!(value.high > value.low)) value.high = value.low + 1;
  value.from = foot;
  value.to = top;
  append_across_axis(plot, across, foot, svg);
  append_value_axis(plot, value, svg);
  for (std::size_t i = 0; i < plot.lines.size(); ++i)
    append_line(plot, plot.lines[i], across, value, stroke_of(i), svg);
  append_key(plot, foot, svg);
  return svg + "</svg>\n";
}

}  // namespace dda
