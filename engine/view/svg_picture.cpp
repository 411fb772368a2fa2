#include "engine/view/svg_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <string_view>
#include <vector>

#include "engine/core/error.h"
#include "engine/record/vtp_file.h"
#include "engine/view/bolt_drawing.h"
#include "engine/view/colour_scale.h"
#include "engine/view/force_lines.h"
#include "engine/view/quantities.h"
#include "engine/view/svg_path.h"

namespace dda {
namespace {

constexpr double margin = 16;        // px
constexpr double side = 148;         // px, for colour bar and key
constexpr double foot = 34;          // px, for time and ruler
constexpr double title_size = 18;    // px
constexpr double text_size = 14;     // px
constexpr double letter = 0.5;       // mean width of a letter by its size
constexpr double most_height = 760;  // px, of the blocks
constexpr double room = 0.03;        // around the blocks, of their extent
constexpr int line_widths = 24;

constexpr std::string_view ink = "#1a2129";
constexpr std::string_view quiet = "#566370";
constexpr std::string_view compression = "#d4002a";
constexpr std::string_view tension = "#7a2bd0";

std::vector<std::string> wrapped(std::string_view text, std::size_t letters) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    std::size_t end = text.size();
    if (end > letters) end = text.rfind(' ', letters) == std::string_view::npos ? letters : text.rfind(' ', letters);
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::string two_digits(double value) {
  const double step = std::pow(10, std::floor(std::log10(std::max(std::abs(value), 1e-9))) - 1);
  return label(step * std::round(value / step), step);
}

class Picture {
 public:
  Picture(const Drawing& drawing, const Frame& frame, const PictureOptions& options)
      : drawing_(drawing),
        frame_(frame),
        options_(options),
        quantity_(drawn_quantities[find_quantity(options.quantity, "--quantity")]),
        bolts_(frame.bolts, text_size) {
    for (std::size_t i = 0; i < drawing.reference.size(); ++i)
      points_.emplace_back(drawing.reference[i] + options.deformation_scale * frame.displacement[i]);
    lay_out();
    choose_scales();
  }

  std::string text() {
    add("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" width=\"{:.0f}\" height=\"{:.0f}\" "
        "font-family=\"'Source Sans 3', 'Segoe UI', 'Helvetica Neue', Arial, sans-serif\" font-size=\"{}\" "
        "fill=\"{}\">\n",
        width_, height_, width_, height_, text_size, ink);
    add("<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n");
    draw_title();
    add("<clipPath id=\"view\"><rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/></clipPath>\n",
        left_, top_, plot_width_, plot_height_);
    add("<g clip-path=\"url(#view)\">\n");
    draw_blocks();
    if (options_.crosses) draw_crosses();
    draw_forces();
    draw_bolts();
    add("</g>\n");
    draw_colour_bar();
    draw_foot();
    add("</svg>\n");
    return text_;
  }

 private:
  template <typename... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
  }

  void lay_out() {
    if (options_.window)
      window_ = *options_.window;
    else
      window_ = all_blocks();
    const double wide = window_.right - window_.left;
    const double high = window_.top - window_.bottom;
    scale_ = std::min((options_.width - 2 * margin - side) / wide, most_height / high);
    plot_width_ = wide * scale_;
    plot_height_ = high * scale_;
    width_ = plot_width_ + 2 * margin + side;
    title_ = wrapped(options_.title, static_cast<std::size_t>((width_ - 2 * margin) / (letter * title_size)));
    left_ = margin;
    top_ = margin + static_cast<double>(title_.size()) * 1.3 * title_size;
    key_room_ = 170 + bolts_.key_height();
    height_ = top_ + body_height() + foot + margin / 2;
  }

  // Between title and foot: room for the plot, and beside it for the colour bar and the keys.
  [[nodiscard]] double body_height() const { return std::max(plot_height_, 130 + key_room_); }

  [[nodiscard]] Window all_blocks() const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Window box{infinity, infinity, -infinity, -infinity};
    for (const Vec2& point : points_) {
      if (!point.allFinite()) continue;
      box = {std::min(box.left, point.x()), std::min(box.bottom, point.y()), std::max(box.right, point.x()),
             std::max(box.top, point.y())};
    }
    if (!std::isfinite(box.right - box.left) || !std::isfinite(box.top - box.bottom))
      throw InputError("", "the frame", "without blocks at finite places",
                       "another frame, or a smaller --deformation-scale");
    const double around = room * std::max(box.right - box.left, box.top - box.bottom);
    return {box.left - around, box.bottom - around, box.right + around, box.top + around};
  }

  void choose_scales() {
    std::vector<double> values;
    std::vector<double> sizes;
    for (std::size_t block = 0; block < drawing_.blocks(); ++block) {
      values.push_back(quantity_.value(frame_, block));
      sizes.push_back(std::sqrt(area_and_centroid(drawing_, drawing_.reference, block).first));
    }
    colours_ = scale_of(values);
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::ranges::nth_element(sizes, middle);
    typical_ = *middle * scale_;
    if (options_.forces == DrawnForces::contacts)
      lines_ = contact_lines(drawing_, frame_.contacts, options_.deformation_scale);
    if (options_.forces == DrawnForces::joints)
      lines_ = joint_lines(drawing_, points_, frame_.contacts, options_.deformation_scale);
    for (const ForceLine& line : lines_) largest_ = std::max(largest_, line.force);
  }

  // On the page.
  [[nodiscard]] Vec2 at(const Vec2& point) const {
    return {left_ + (point.x() - window_.left) * scale_, top_ + (window_.top - point.y()) * scale_};
  }

  void draw_title() {
    for (std::size_t i = 0; i < title_.size(); ++i)
      add("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" font-weight=\"600\">{}</text>\n", margin,
          margin + title_size * (0.75 + 1.3 * static_cast<double>(i)), title_size, xml_escaped(title_[i]));
  }

  // Outer rings run counter-clockwise and holes clockwise, so the rule "nonzero" leaves holes open.
  void add_outline(std::size_t block, SvgPath& path) const {
    for (std::uint32_t ring = drawing_.block_begin[block]; ring < drawing_.block_begin[block + 1]; ++ring) {
      const std::uint32_t begin = drawing_.ring_begin[ring];
      path.move_to(at(points_[begin]));
      for (std::uint32_t i = begin + 1; i < drawing_.ring_begin[ring + 1]; ++i) path.line_to(at(points_[i]));
      path.close();
    }
  }

  void draw_blocks() {
    std::map<std::string, SvgPath> path_of_colour;
    for (std::size_t block = 0; block < drawing_.blocks(); ++block)
      if (is_present(frame_, block))
        add_outline(block, path_of_colour[to_hex(colours_.colour(quantity_.value(frame_, block)))]);
    add("<g stroke=\"{}\" stroke-width=\"{:.2f}\" stroke-linejoin=\"round\">\n", ink,
        std::clamp(typical_ / 40, 0.25, 1.2));
    for (const auto& [colour, path] : path_of_colour) add("<path fill=\"{}\" d=\"{}\"/>\n", colour, path.text());
    add("</g>\n");
  }

  struct Stroke {
    std::string_view colour;
    double width = 0;  // px
    SvgPath path;
  };

  // All halos lie below all lines.
  void add_strokes(const std::vector<Stroke>& strokes) {
    add("<g fill=\"none\" stroke-linecap=\"round\">\n");
    for (const bool halo : {true, false}) {
      for (const Stroke& stroke : strokes) {
        if (stroke.path.empty()) continue;
        const double width = halo ? stroke.width + std::clamp(stroke.width - 0.8, 0.0, 1.6) : stroke.width;
        add("<path stroke=\"{}\" stroke-width=\"{:.2f}\" d=\"{}\"/>\n", halo ? "#fff" : stroke.colour, width,
            stroke.path.text());
      }
    }
    add("</g>\n");
  }

  void add_segment(const Vec2& from, const Vec2& to, SvgPath& path) const {
    path.move_to(at(from));
    path.line_to(at(to));
  }

  // The thickest line fills a quarter of a block, within what looks like a line.
  [[nodiscard]] double width_of(double force) const {
    return std::max(std::clamp(0.25 * typical_, 1.5, 10.0) * force / largest_, 0.3);
  }

  // Lines of nearly the same width are one path.
  void draw_forces() {
    std::vector<Stroke> strokes;
    for (const bool pulls : {false, true})
      for (int i = 0; i <= line_widths; ++i)
        strokes.push_back({pulls ? tension : compression, width_of(largest_ * i / line_widths), {}});
    for (const ForceLine& line : lines_) {
      if (line.force < least_drawn_force * largest_) continue;
      const auto place = std::lround(line_widths * line.force / largest_) + (line.tension ? line_widths + 1 : 0);
      add_segment(line.from, line.to, strokes[static_cast<std::size_t>(place)].path);
    }
    add_strokes(strokes);
  }

  void draw_bolts() {
    text_ += bolts_.links([this](const Vec2& point) { return at(point); }, options_.deformation_scale);
  }

  // The arms of the largest principal stress fill its block, as far as that is not much larger than the others.
  void draw_crosses() {
    double most = 0;
    for (const Vec3& stress : frame_.stress) {
      const PrincipalStress principal = principal_stress(stress);
      most = std::max({most, std::abs(principal.first), std::abs(principal.second)});
    }
    if (!(most > 0)) return;
    std::vector<Stroke> strokes = {{ink, 1.8, {}}, {compression, 1.8, {}}};  // pressed, pulled
    for (std::size_t block = 0; block < drawing_.blocks(); ++block) {
      const auto [area, centroid] = area_and_centroid(drawing_, points_, block);
      const PrincipalStress principal = principal_stress(frame_.stress[block]);
      const Vec2 across(-principal.direction.y(), principal.direction.x());
      for (const auto& [stress, direction] :
           {std::pair(principal.first, principal.direction), std::pair(principal.second, across)}) {
        const double size = std::min(std::sqrt(area), 1.5 * typical_ / scale_);
        const Vec2 arm = 0.45 * size * std::abs(stress) / most * direction;
        if (arm.norm() * scale_ > 0.5) add_segment(centroid - arm, centroid + arm, strokes[stress > 0 ? 1 : 0].path);
      }
    }
    add_strokes(strokes);
  }

  void draw_colour_bar() {
    const double x = width_ - side;
    const ScaledUnit unit = scaled_unit(quantity_.unit, std::max(std::abs(colours_.low), std::abs(colours_.high)));
    const bool is_signed = quantity_.unit == "Pa" && quantity_.id != "max_shear";
    double y = top_ + 0.8 * text_size;
    const auto add_line = [&](std::string_view style, const std::string& line) {
      add("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, style, line);
      y += 1.3 * text_size;
    };
    for (const std::string& line : wrapped(quantity_.title, 18)) add_line("font-weight=\"600\"", line);
    const std::string plain = fmt::format("fill=\"{}\"", quiet);
    add_line(plain, unit.name + (is_signed ? ", tension +" : ""));
    if (colours_.least < colours_.low || colours_.most > colours_.high)
      add_line(plain, fmt::format("{} to {}", two_digits(colours_.least / unit.factor),
                                  two_digits(colours_.most / unit.factor)));
    const double size = std::min(body_height() - key_room_, 300.0);
    add("<linearGradient id=\"scale\" x1=\"0\" y1=\"1\" x2=\"0\" y2=\"0\">");
    for (int i = 0; i <= 32; ++i)
      add("<stop offset=\"{:.4f}\" stop-color=\"{}\"/>", i / 32.0, to_hex(colours_.colour_at(i / 32.0)));
    add("</linearGradient>\n<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"20\" height=\"{:.1f}\" fill=\"url(#scale)\" "
        "stroke=\"{}\"/>\n",
        x, y, size, quiet);
    const std::vector<double> values = ticks(colours_.low / unit.factor, colours_.high / unit.factor, 6);
    const double step = values.size() > 1 ? values[1] - values[0] : 1;
    for (const double value : values) {
      const double height = y + size * (1 - (value * unit.factor - colours_.low) / (colours_.high - colours_.low));
      add("<path d=\"M{:.1f} {:.1f}h5\" stroke=\"{}\"/><text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x + 20, height,
          quiet, x + 30, height + 0.35 * text_size, label(value, step));
    }
    y += size + 2.4 * text_size;
    draw_key(x, y);
    text_ += bolts_.key(x, y);
  }

  // Moves y below what it drew.
  void draw_key(double x, double& y) {
    if (!(largest_ > 0)) return;
    const ScaledUnit unit = scaled_unit("N/m", largest_);
    const std::vector<double> values = ticks(0, largest_ / unit.factor, 3);
    add("<text x=\"{:.1f}\" y=\"{:.1f}\" font-weight=\"600\">{}</text>\n", x, y,
        options_.forces == DrawnForces::joints ? "Joint force" : "Contact force");
    for (std::size_t i = 1; i < values.size(); ++i) {
      y += 1.5 * text_size;
      add("<path d=\"M{:.1f} {:.1f}h24\" stroke=\"{}\" stroke-width=\"{:.2f}\" stroke-linecap=\"round\"/>"
          "<text x=\"{:.1f}\" y=\"{:.1f}\">{} {}</text>\n",
          x + 4, y - 0.35 * text_size, compression, width_of(values[i] * unit.factor), x + 40, y,
          label(values[i], values[1]), unit.name);
    }
    y += 2.2 * text_size;
  }

  void draw_foot() {
    const double y = height_ - margin;
    const std::string motion =
        options_.deformation_scale == 1 ? "" : fmt::format(", deformation \u00d7 {}", options_.deformation_scale);
    add("<text x=\"{:.1f}\" y=\"{:.1f}\">t = {:.4g} s{}</text>\n", left_, y, frame_.time, motion);
    const std::vector<double> lengths = ticks(0, 150 / scale_, 2);
    const double length = lengths.size() > 1 ? lengths[1] : 150 / scale_;
    const ScaledUnit unit = scaled_unit("m", length);
    const double right = left_ + plot_width_;
    const double px = length * scale_;
    add("<path d=\"M{:.1f} {:.1f}v5h{:.1f}v-5\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{} {}</text>\n",
        right - px, y - 5, px, ink, right - px - 8, y, label(length / unit.factor, length / unit.factor), unit.name);
  }

  const Drawing& drawing_;
  const Frame& frame_;
  const PictureOptions& options_;
  const DrawnQuantity& quantity_;
  BoltDrawing bolts_;
  std::vector<Vec2> points_;
  std::vector<std::string> title_;
  Window window_;
  double scale_ = 1;                                                                       // px/m
  double typical_ = 1;                                                                     // px, size of a block
  double left_ = 0, top_ = 0, width_ = 0, height_ = 0, plot_width_ = 0, plot_height_ = 0;  // px
  ColourScale colours_;
  std::vector<ForceLine> lines_;
  double largest_ = 0;   // N/m
  double key_room_ = 0;  // px, below the colour bar
  std::string text_;
};

}  // namespace

std::string svg_picture(const Drawing& drawing, const Frame& frame, const PictureOptions& options) {
  return Picture(drawing, frame, options).text();
}

}  // namespace dda
