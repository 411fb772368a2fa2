#include "engine/view/bolt_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "engine/view/colour_map.h"
#include "engine/view/colour_scale.h"
#include "engine/view/svg_path.h"

namespace dda {
namespace {

constexpr std::string_view bolt_colour = "#007a3d";
constexpr std::string_view yielded_colour = "#f08a00";
constexpr std::string_view broken_colour = "#1a2129";
constexpr double thin = 1.6;     // px, without force
constexpr double thick = 5.5;    // px, of the largest force
constexpr double spacing = 1.5;  // of the lines of the key, in letters

std::string utilisation_colour(double share) {
  const ColourMap& map = utilisation_map();
  return to_hex(map[static_cast<std::size_t>(std::lround(std::clamp(share, 0.0, 1.0) * 255))]);
}

std::string colour_of(const DrawnBolt& bolt) {
  if (bolt.condition == DrawnCondition::broken) return std::string(broken_colour);
  if (bolt.condition == DrawnCondition::yielded) return std::string(yielded_colour);
  return std::isnan(bolt.utilisation) ? std::string(bolt_colour) : utilisation_colour(bolt.utilisation);
}

// With a halo. A broken bolt is dashed.
std::string line(const std::string& path, double width, const DrawnBolt& like) {
  return fmt::format(
      "<path stroke=\"#fff\" stroke-width=\"{:.2f}\" d=\"{}\"/>"
      "<path stroke=\"{}\" stroke-width=\"{:.2f}\"{} d=\"{}\"/>\n",
      width + 2, path, colour_of(like), width,
      like.condition == DrawnCondition::broken ? " stroke-dasharray=\"4 3\"" : "", path);
}

DrawnBolt sample(DrawnCondition condition) {
  DrawnBolt bolt;
  bolt.condition = condition;
  return bolt;
}

DrawnBolt utilised(double share) {
  DrawnBolt bolt;
  bolt.utilisation = share;
  return bolt;
}

// Lines of a key below each other: short lines with what they mean, and headings.
class Key {
 public:
  Key(double x, double y, double text_size) : x_(x), y_(y), text_size_(text_size) {}

  void heading(std::string_view text) {
    text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-weight=\"600\">{}</text>\n", x_, y_, text);
    y_ += spacing * text_size_;
  }

  void row(const std::string& text, double width, const DrawnBolt& like) {
    text_ += fmt::format("<g fill=\"none\">{}</g>",
                         line(fmt::format("M{:.1f} {:.1f}h28", x_ + 2, y_ - 0.35 * text_size_), width, like));
    text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x_ + 40, y_, text);
    y_ += spacing * text_size_;
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  double x_, y_, text_size_;
  std::string text_;
};

constexpr double shares[] = {0, 0.25, 0.5, 0.75, 1};

}  // namespace

BoltDrawing::BoltDrawing(const std::vector<DrawnBolt>& links, double text_size) : links_(links), text_size_(text_size) {
  for (const DrawnBolt& link : links) {
    largest_ = std::max(largest_, std::abs(link.force));
    has_utilisation_ = has_utilisation_ || !std::isnan(link.utilisation);
  }
}

double BoltDrawing::width_of(double force) const {
  return thin + (largest_ > 0 ? (thick - thin) * std::abs(force) / largest_ : 0);
}

std::string BoltDrawing::links(const std::function<Vec2(const Vec2&)>& at, double deformation_scale) const {
  if (links_.empty()) return "";
  std::string text = "<g fill=\"none\" stroke-linejoin=\"round\">\n";
  for (const DrawnBolt& link : links_) {
    if (link.condition == DrawnCondition::waiting) continue;
    SvgPath path;
    for (std::size_t i = 0; i < link.reference.size(); ++i) {
      const Vec2 point = at(link.reference[i] + deformation_scale * link.displacement[i]);
      i == 0 ? path.move_to(point) : path.line_to(point);
    }
    text += line(path.text(), width_of(link.force), link);
  }
  return text + "</g>\n";
}

// A heading, three widths, yielded and broken; and a heading with the shares.
double BoltDrawing::key_height() const {
  if (links_.empty()) return 0;
  return spacing * text_size_ * (6 + (has_utilisation_ ? 1 + static_cast<double>(std::size(shares)) : 0));
}

std::string BoltDrawing::key(double x, double y) const {
  if (links_.empty()) return "";
  Key key(x, y, text_size_);
  key.heading("Axial force");
  const ScaledUnit unit = scaled_unit("N", largest_);
  const std::vector<double> values = ticks(0, largest_ / unit.factor, 2);
  for (const double value : values)
    key.row(label(value, values.size() > 1 ? values[1] : 1) + " " + unit.name, width_of(value * unit.factor),
            sample(DrawnCondition::elastic));
  for (const auto& [condition, text] :
       {std::pair(DrawnCondition::yielded, "yielded"), std::pair(DrawnCondition::broken, "broken")})
    if (std::ranges::count(links_, condition, &DrawnBolt::condition) > 0) key.row(text, thin, sample(condition));
  if (has_utilisation_) {
    key.heading("Utilisation");
    for (const double share : shares) key.row(fmt::format("{:g} %", 100 * share), thick, utilised(share));
  }
  return key.text();
}

}  // namespace dda
