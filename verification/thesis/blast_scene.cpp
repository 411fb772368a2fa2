#include "verification/thesis/blast_scene.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "engine/builder/ground_plan.h"
#include "verification/harness/cavity.h"

namespace verify {
namespace {

constexpr double quarter = 8;       // m, side of the large blocks
constexpr int strip_columns = 6;    // of 1 m, to each side of the octagon
constexpr double strip_height = 7;  // m, half of the level strip

// Appends the rectangles between the lines x and y, and their mirror images in both axes that are not themselves.
class Rectangles {
 public:
  explicit Rectangles(dda::Model& model) : model_(&model) {}

  void append(double x0, double x1, double y0, double y1) {
    append_one(x0, x1, y0, y1);
    const bool across_x = x0 < 0;  // straddles the upright axis
    const bool across_y = y0 < 0;
    if (!across_x) append_one(-x1, -x0, y0, y1);
    if (!across_y) append_one(x0, x1, -y1, -y0);
    if (!across_x && !across_y) append_one(-x1, -x0, -y1, -y0);
  }

  void append_polygon(dda::Ring corners) {
    dda::Block block;
    block.name = fmt::format("{}", model_->blocks.size() + 1);
    block.shape.outer = std::move(corners);
    model_->blocks.push_back(std::move(block));
  }

 private:
  void append_one(double x0, double x1, double y0, double y1) {
    append_polygon({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
  }

  dda::Model* model_;
};

// 1 m long and 2 m high to both sides of the blast; the row through it is level with it.
void append_level_strip(Rectangles& blocks, double half_width, const BlastMesh& mesh) {
  const int columns = strip_columns + static_cast<int>(quarter) * mesh.quarter_columns;
  for (int i = 0; i < columns; ++i) {
    const double x = half_width + i;
    blocks.append(x, x + 1, -1, 1);
    for (double y = 1; y < strip_height; y += 2) blocks.append(x, x + 1, y, y + 2);
  }
}

// Above and below the blast: a column as wide as the octagon's edge with one to each side, 2 m high.
void append_middle_columns(Rectangles& blocks, double half_width, double half_edge, const BlastMesh& mesh) {
  const double end = strip_height + quarter * mesh.quarter_rows;
  for (double y = half_width; y < end; y = y == half_width ? 3 : y + 2) {
    const double above = y == half_width ? 3 : y + 2;
    blocks.append(-half_edge, half_edge, y, above);
    blocks.append(half_edge, half_width, y, above);
  }
}

void append_upright_strip_and_quarters(Rectangles& blocks, double half_width, const BlastMesh& mesh) {
  const double end = strip_height + quarter * mesh.quarter_rows;
  for (int i = 0; i < strip_columns; ++i)
    for (double y = strip_height; y < end; y += 2) blocks.append(half_width + i, half_width + i + 1, y, y + 2);
  const double side = half_width + strip_columns;
  for (int column = 0; column < mesh.quarter_columns; ++column)
    for (int row = 0; row < mesh.quarter_rows; ++row)
      blocks.append(side + column * quarter, side + (column + 1) * quarter, strip_height + row * quarter,
                    strip_height + (row + 1) * quarter);
}

void append_corners_of_the_octagon(Rectangles& blocks, double w, double half_edge) {
  for (const double sx : {1.0, -1.0})
    for (const double sy : {1.0, -1.0})
      blocks.append_polygon({{sx * w, sy * w}, {sx * w, sy * half_edge}, {sx * half_edge, sy * w}});
}

// Eight blocks around a hollow, each on one side of the octagonal hole that they fill.
void append_element(Rectangles& blocks, double w, double half_edge) {
  const std::array<dda::Vec2, 8> corners = {{{w, -half_edge},
                                             {w, half_edge},
                                             {half_edge, w},
                                             {-half_edge, w},
                                             {-w, half_edge},
                                             {-w, -half_edge},
                                             {-half_edge, -w},
                                             {half_edge, -w}}};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const dda::Vec2& from = corners[i];
    const dda::Vec2& to = corners[(i + 1) % corners.size()];
    blocks.append_polygon({from, to, element_hollow * to, element_hollow * from});
  }
}

dda::Model bare_rock(const ThesisBlast& blast, const BlastRun& run) {
  dda::Model model;
  model.title = "the blast of chapter 4";
  model.materials = {{"rock", blast.density, blast.young, blast.poisson, dda::PlaneState::stress}};
  model.joints = {run.joint};
  const double half_width = blast.octagon_width() / 2;
  const double half_edge = blast.octagon_edge / 2;
  Rectangles blocks(model);
  append_level_strip(blocks, half_width, run.mesh);
  append_middle_columns(blocks, half_width, half_edge, run.mesh);
  append_upright_strip_and_quarters(blocks, half_width, run.mesh);
  append_corners_of_the_octagon(blocks, half_width, half_edge);
  if (run.element) append_element(blocks, half_width, half_edge);
  dda::finish_model(model);
  return model;
}

void measure(dda::Model& model, const dda::GroundPlan& plan, const PrintedArrival& point) {
  const dda::Vec2 at = point.level() ? dda::Vec2(point.distance, 0) : dda::Vec2(0, point.distance);
  dda::Measurement velocity;
  velocity.name = point.point + " velocity";
  velocity.quantity = point.level() ? dda::Quantity::velocity_x : dda::Quantity::velocity_y;
  velocity.block = plan.blocks_at(at).front();
  velocity.point = at;
  dda::Measurement stress = velocity;
  stress.name = point.point + " stress";
  stress.quantity = point.level() ? dda::Quantity::stress_xx : dda::Quantity::stress_yy;
  model.measurements.push_back(velocity);
  model.measurements.push_back(stress);
}

}  // namespace

double blast_arrival_time(const ThesisBlast& blast) { return blast.octagon_width() / blast.speed_plane_stress(); }

BlastPulse equation_18(const ThesisBlast& blast) {
  const double arrival = blast_arrival_time(blast);
  return {arrival, 1.1 * arrival};
}

double blast_factor(const BlastPulse& pulse, double time) {
  const double since = time - pulse.start;
  if (since <= 0) return 0;
  return since < blast_rise ? since / blast_rise : std::exp(-(since - blast_rise) / pulse.decay_time);
}

std::vector<PrintedArrival> points_inside(const ThesisBlast& blast, const BlastMesh& mesh) {
  std::vector<PrintedArrival> inside;
  for (const PrintedArrival& point : blast.points) {
    const double end = quarter * (point.level() ? mesh.quarter_columns : mesh.quarter_rows) + strip_height;
    if (point.distance < end) inside.push_back(point);
  }
  return inside;
}

dda::Model blast_scene(const ThesisBlast& blast, const BlastRun& run) {
  dda::Model model = bare_rock(blast, run);
  const double pressure = run.element ? blast.peak_pressure / element_hollow : blast.peak_pressure;
  if (run.loaded) press_wall(model, pressure, dda::ExponentialDecay{run.pulse.decay_time, run.pulse.start, blast_rise});
  absorb_outside(model);
  const dda::GroundPlan plan(model);
  for (const PrintedArrival& point : points_inside(blast, run.mesh)) measure(model, plan, point);
  dda::Stage stage;
  stage.kinematics = dda::Kinematics::small;
  stage.integrator = run.integrator;
  stage.dt = run.dt;
  stage.duration = run.duration;
  model.stages = {stage};
  dda::finish_model(model);
  return model;
}

}  // namespace verify
