#include "verification/stability/answers.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/geometry/overlap.h"
#include "engine/model/current_outline.h"
#include "verification/exact/pulsed_row.h"
#include "verification/stability/scenes.h"

namespace verify {
namespace {

using dda::Simulation;
using dda::Vec2;

Vec2 moved(const Simulation& simulation, std::size_t block) { return simulation.state().displacement[block].head<2>(); }

// std::max keeps its first argument where the second is no number.
void grow(double& largest, double value) { largest = value > largest || std::isnan(value) ? value : largest; }

exact::RowMotion row_under_pulse(const Setting& setting) {
  exact::PulsedRow row;
  for (int i = 0; i < pulse_columns; ++i)
    row.density.push_back(i % 2 == 0 ? rock_density : rock_density / setting.mass_ratio);
  row.young = rock_young;
  row.joint_stiffness = 2 * setting.penalty * rock_young / row_height(setting);  // two springs on a face of a block
  row.peak = pulse_peak;
  row.rise = row.fall = pulse_rise;
  return exact::RowMotion(row);
}

class PulseAnswer final : public Answer {
 public:
  explicit PulseAnswer(const Setting& setting) : motion_(row_under_pulse(setting)) {}

  void look(const Simulation& simulation, std::span<const double> /*sample*/) override {
    constexpr int every = 10;  // steps, where there are many
    if (simulation.state().step > 100 && simulation.state().step % every != 0) return;
    const Eigen::VectorXd exact = motion_.displacements(simulation.state().time);
    for (std::size_t block = 0; block < simulation.state().displacement.size(); ++block) {
      const Vec2 expected(exact[static_cast<Eigen::Index>(block) / pulse_rows], 0);
      grow(largest_, expected.norm());
      grow(worst_, (moved(simulation, block) - expected).norm());
    }
  }

  [[nodiscard]] std::vector<Check> checks(const Simulation& /*simulation*/) const override {
    return {{"error of displacements over the largest", worst_ / largest_, 0.05}};
  }

 private:
  exact::RowMotion motion_;
  double worst_ = 0, largest_ = 0;  // m
};

class WallAnswer final : public Answer {
 public:
  explicit WallAnswer(const Setting& setting)
      : height_(wall_rows * row_height(setting)),
        weight_(weight_pull * rock_density * wall_width * height_ / 2 * (1 + 1 / setting.mass_ratio)),
        // All of the weight through one spring a course, and through blocks as narrow as a brick.
        sag_(weight_ / rock_young * (wall_rows / setting.penalty + height_ / (wall_width / 3))) {}

  void look(const Simulation& simulation, std::span<const double> sample) override {
    const std::size_t blocks = simulation.model().blocks.size();
    if (settled_.empty())
      for (std::size_t block = 0; block < blocks; ++block) settled_.push_back(moved(simulation, block));
    for (std::size_t block = 0; block < blocks; ++block) {
      grow(sunk_, settled_[block].norm());
      grow(moved_, (moved(simulation, block) - settled_[block]).norm());
    }
    grow(imbalance_, std::abs(sample[1] / weight_ - 1));
  }

  // Equilibrium is asked to 1e-9 of the load, and what is left of it rings.
  [[nodiscard]] std::vector<Check> checks(const Simulation& /*simulation*/) const override {
    return {{"settlement over what springs and blocks give way at most", sunk_ / sag_, 1},
            {"motion after it over the same", moved_ / sag_, 1e-4},
            {"reaction of the base over the weight, less 1", imbalance_, 1e-4}};
  }

 private:
  double height_, weight_, sag_;  // m, N, m
  std::vector<Vec2> settled_;
  double sunk_ = 0, moved_ = 0, imbalance_ = 0;
};

class InclineAnswer final : public Answer {
 public:
  explicit InclineAnswer(const Setting& setting) : dt_(setting.dt) {
    constexpr double degree = std::numbers::pi / 180;
    const auto [width, height] = slider_extent(setting);
    const double weight = weight_pull * rock_density * width * height * (1 + 1 / setting.mass_ratio);
    acceleration_ = weight_pull * (std::sin(incline_angle * degree) -
                                   std::cos(incline_angle * degree) * std::tan(incline_friction * degree));
    // Springs and blocks under the weight, and the tilt that the weight's arm gives them.
    const double lean = 1 + 2 * height / width * (2 * height / width);
    give_ = weight / rock_young * (1 / setting.penalty + 2 * height / width) * lean;
  }

  void look(const Simulation& simulation, std::span<const double> /*sample*/) override {
    if (!start_) {
      start_ = simulation.state().time;
      for (std::size_t block = 1; block < 3; ++block) settled_.push_back(moved(simulation, block));
    }
    const double t = simulation.state().time - *start_;
    slip_ = acceleration_ * t * t / 2;
    speed_ = acceleration_ * t;
    for (std::size_t block = 1; block < 3; ++block) {
      const Vec2 way = moved(simulation, block) - settled_[block - 1];
      grow(worst_, (way - Vec2(slip_, 0)).norm());
      grow(sunk_, std::abs(moved(simulation, block).y()));
    }
  }

  // A step begins with the forces of a moment within it: what starts to slide does so half a step late or early.
  [[nodiscard]] double late_start() const { return speed_ * dt_ / 2; }

  // What swings goes to twice its static value, to either side. The first step may lift a block by a negligible share
  // of its size, which is 1 m (ADR 28).
  [[nodiscard]] std::vector<Check> checks(const Simulation& /*simulation*/) const override {
    return {{"error of the way down, m", worst_, 1e-3 * slip_ + late_start() + 4 * give_},
            {"motion across the plane, m", sunk_, 4 * give_ + 1e-5}};
  }

 private:
  double dt_;                // s
  double acceleration_ = 0;  // m/s2
  double give_ = 0;          // m
  std::optional<double> start_;
  std::vector<Vec2> settled_;
  double slip_ = 0, worst_ = 0, sunk_ = 0;  // m
  double speed_ = 0;                        // m/s
};

class PileAnswer final : public Answer {
 public:
  explicit PileAnswer(const Setting& setting)
      : half_width_(pile_box * pile_scale(setting).width), height_(pile_gap + 2 * pile_scale(setting).height) {}

  void look(const Simulation& simulation, std::span<const double> /*sample*/) override {
    const dda::Model& model = simulation.model();
    double kinetic = 0, fallen = 0, whole = 0;  // J
    for (std::size_t block = held; block < model.blocks.size(); ++block) {
      const double mass = model.mass_of(static_cast<int>(block));
      const Vec2 place = model.blocks[block].moments.centroid + moved(simulation, block);
      kinetic += mass * simulation.state().velocity[block].head<2>().squaredNorm() / 2;
      fallen -= mass * weight_pull * moved(simulation, block).y();
      whole += mass * weight_pull * height_;
      grow(outside_, std::abs(place.x()) / half_width_ - 1);
      grow(outside_, -place.y() / height_);
    }
    grow(gained_, (kinetic - fallen) / whole);
  }

  [[nodiscard]] std::vector<Check> checks(const Simulation& simulation) const override {
    return {{"kinetic energy beyond the fall, over weight times height", gained_, 1e-4},
            {"way of a centroid out of the box, over its size", outside_, 0},
            {"pairs of blocks in each other by more than 1 % of their size", overlaps(simulation), 0}};
  }

 private:
  static constexpr std::size_t held = 3;  // floor and walls

  [[nodiscard]] double overlaps(const Simulation& simulation) const {
    if (std::isnan(outside_)) return outside_;
    const std::vector<dda::Polygon> outlines = dda::current_outlines(simulation.model(), simulation.state());
    double pairs = 0;
    for (std::size_t i = held; i < outlines.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const dda::Polygon &a = outlines[i], &b = outlines[j];
        const double size = std::sqrt(std::min(dda::signed_area(a.outer), dda::signed_area(b.outer)));
        if (dda::interiors_overlap(a, b, 0.01 * size)) ++pairs;
      }
    return pairs;
  }

  double half_width_, height_;  // m
  double gained_ = 0, outside_ = -1;
};

}  // namespace

std::unique_ptr<Answer> answer_of(const Setting& setting) {
  switch (setting.problem) {
    case ChartProblem::pulse: return std::make_unique<PulseAnswer>(setting);
    case ChartProblem::wall: return std::make_unique<WallAnswer>(setting);
    case ChartProblem::incline: return std::make_unique<InclineAnswer>(setting);
    case ChartProblem::pile: return std::make_unique<PileAnswer>(setting);
  }
  return nullptr;
}

}  // namespace verify
