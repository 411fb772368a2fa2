#include "engine/app/reaction_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include "engine/app/reaction_report.h"
#include "engine/record/vtp_file.h"
#include "engine/view/colour_scale.h"
#include "engine/view/svg_path.h"

namespace dda {
namespace {

constexpr double width = 720, height = 480;                     // px
constexpr double left = 76, right = 64, top = 30, bottom = 54;  // px, around the plot
constexpr double line_of_key = 20;                              // px
constexpr double foot = height - bottom, end = width - right;   // px
constexpr std::array<std::string_view, 5> colours{"#1a2129", "#c4471d", "#1f5fa8", "#2e8540", "#8a4fa3"};
constexpr std::array<std::string_view, 5> names{"mean of the wall", "crown", "left", "right", "invert"};

struct Range {
  double low = 0, high = 1;
};

// The value that a curve shows: the mean, or that of one of the places.
double value_of(const WallMotion& motion, std::size_t curve) {
  return curve == 0 ? motion.mean : motion.places[curve - 1];
}

// The range of all displacements, with zero and some room.
Range displacements(const ReactionCurve& curve) {
  Range range{0, 0};
  for (const ReactionPoint& point : curve.points) {
    if (!point.settles()) continue;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const double value = value_of(point.motion, i);
      if (!std::isfinite(value)) continue;
      range = {std::min(range.low, value), std::max(range.high, value)};
    }
  }
  if (!(range.high > range.low)) range.high = range.low + 1e-3;
  const double room = 0.04 * (range.high - range.low);
  return {range.low < -room / 4 ? range.low - room : 0, range.high + room};  // below zero by more than round-off
}

// Draws within axes whose upright one goes from a share of 0 to 1.
class Plot {
 public:
  explicit Plot(const ReactionCurve& curve) : curve_(curve), across_(displacements(curve)) {}

  [[nodiscard]] std::string text() {
    draw_unstable();
    draw_displacement_axis();
    draw_pressure_axis();
    draw_share_axis();
    for (std::size_t i = names.size(); i-- > 0;) draw_curve(i);  // the mean on top
    draw_key();
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" "
               "font-family=\"'Source Sans 3', 'Segoe UI', Arial, sans-serif\" font-size=\"14\" fill=\"#1a2129\">\n"
               "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
               width, height + line_of_key + 10) +
           content_ + "</svg>\n";
  }

 private:
  [[nodiscard]] Vec2 place(double displacement, double share) const {
    const double along = (displacement - across_.low) / (across_.high - across_.low);
    return {left + along * (end - left), foot - share * (foot - top)};
  }

  void write(double x, double y, std::string_view anchor, std::string_view text) {
    content_ +=
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor, xml_escaped(text));
  }

  void rule(const Vec2& from, const Vec2& to) {
    content_ += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#dde3e9\"/>\n", from.x(), from.y(),
                            to.x(), to.y());
  }

  // From the greatest share at which the rock did not come to rest down.
  void draw_unstable() {
    const auto failure = failure_of(curve_);
    if (!failure) return;
    const double from = place(0, failure->share).y();
    content_ += fmt::format("<rect x=\"{}\" y=\"{:.1f}\" width=\"{}\" height=\"{:.1f}\" fill=\"#f8ddd3\"/>\n", left,
                            from, end - left, std::max(foot - from, 2.0));
    write(end - 8, std::min(from + 18, foot - 6), "end", fmt::format("no rest at a share of {:.4g}", failure->share));
  }

  void draw_displacement_axis() {
    const ScaledUnit unit = scaled_unit("m", std::max(std::abs(across_.low), std::abs(across_.high)));
    const std::vector<double> marks = ticks(across_.low / unit.factor, across_.high / unit.factor, 8);
    const double step = marks.size() > 1 ? marks[1] - marks[0] : 1;
    for (const double mark : marks) {
      const double x = place(mark * unit.factor, 0).x();
      rule({x, top}, {x, foot});
      write(x, foot + 18, "middle", label(mark, step));
    }
    write((left + end) / 2, foot + 40, "middle", fmt::format("inward displacement of the wall ({})", unit.name));
  }

  void draw_pressure_axis() {
    if (!(std::abs(curve_.pressure) > 0)) return;
    const ScaledUnit unit = scaled_unit("Pa", std::abs(curve_.pressure));
    const double most = curve_.pressure / unit.factor;
    const std::vector<double> marks = ticks(std::min(0.0, most), std::max(0.0, most), 6);
    const double step = marks.size() > 1 ? marks[1] - marks[0] : 1;
    for (const double mark : marks) {
      const double y = place(0, mark / most).y();
      rule({left, y}, {end, y});
      write(left - 8, y + 5, "end", label(mark, step));
    }
    write(8, top - 12, "start", fmt::format("support pressure ({})", unit.name));
  }

  void draw_share_axis() {
    constexpr double step = 0.2;
    for (int i = 0; i <= 5; ++i) write(end + 8, place(0, step * i).y() + 5, "start", label(step * i, step));
    write(width - 8, top - 12, "end", "share");
    content_ +=
        fmt::format("<path d=\"M{} {}V{}H{}V{}\" fill=\"none\" stroke=\"#8a96a3\"/>\n", left, top, foot, end, top);
  }

  void draw_curve(std::size_t curve) {
    SvgPath path;
    std::string dots;
    for (const ReactionPoint& point : curve_.points) {
      const double value = point.settles() ? value_of(point.motion, curve) : std::nan("");
      if (!std::isfinite(value)) continue;
      const Vec2 at = place(value, point.share);
      if (path.empty()) path.move_to(at);
      path.line_to(at);
      dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/>", at.x(), at.y(), curve == 0 ? 3.5 : 2.2);
    }
    if (path.empty()) return;
    content_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"/>\n<g fill=\"{}\">{}</g>\n",
                            path.text(), colours[curve], curve == 0 ? 2.4 : 1.4, colours[curve], dots);
  }

  void draw_key() {
    const double y = height + line_of_key - 6;
    double x = left;
    for (std::size_t i = 0; i < names.size(); ++i) {
      content_ += fmt::format("<path d=\"M{:.1f} {:.1f}h20\" stroke=\"{}\" stroke-width=\"{}\"/>", x, y - 5, colours[i],
                              i == 0 ? 3 : 2);
      write(x + 26, y, "start", names[i]);
      x += i == 0 ? 170 : 96;
    }
  }

  const ReactionCurve& curve_;
  Range across_;
  std::string content_;
};

}  // namespace

std::string reaction_picture(const ReactionCurve& curve) { return Plot(curve).text(); }

}  // namespace dda
