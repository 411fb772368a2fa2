// Explicit steps that the engine chooses by itself: against implicit ones on random plates, by what a mesh of a third
// of the block size has; and that they are not chosen where they should not be.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <iostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "engine/contact/make_contacts.h"
#include "engine/geometry/box.h"
#include "engine/simulation/explicit_models.h"
#include "engine/simulation/stability_limit.h"

namespace dda {
namespace {

using namespace explicit_models;

constexpr int finer = 3;  // so that centroids of the plate are centroids of the reference

struct Histories {
  std::vector<double> times;
  std::vector<std::vector<double>> values;  // of every moment, of all places
  double cpu = 0;                           // s
};

// A plate of random rock, pushed or sheared on a side or from within by a pulse of 10 to 20 blocks a wavelength (S).
class RandomPlate {
 public:
  explicit RandomPlate(unsigned seed) : random_(seed) {
    rock_.density = number(2000, 3000);
    rock_.young = number(5e9, 8e10);
    rock_.poisson = number(0.05, 0.35);
    rock_.plane = chance(0.5) ? PlaneState::stress : PlaneState::strain;
    width_ = number(0.5, 2);
    height_ = width_ * (chance(0.5) ? 1 : number(0.8, 1.25));
    shift_ = chance(0.3) ? 0.5 : 0;
    skewed_ = shift_ == 0 && chance(0.4);
    two_rocks_ = chance(0.3);
    stiffer_ = number(0.5, 2);
    frequency_ = speed() / (number(10, 20) * std::max(width_, height_));
    kinked_ = chance(0.4);
    in_the_rock_ = chance(0.3);
    traction_ = {number(-1e6, 1e6), number(-1e6, 1e6)};
    absorbing_ = chance(0.6);
    held_ = chance(0.5);
    at_once_ = chance(0.2);
    share_of_limit_ = number(0.4, 1);
    leaves_dt_ = chance(0.5);
    duration_ = number(0.5, 0.8) * side * width_ / speed();
  }

  static constexpr int side = 45;  // blocks

  // Cuts the plate into blocks of 1/`parts` of the size.
  [[nodiscard]] Model model(int parts) const {
    Model model;
    model.materials = {rock_, rock_};
    model.materials[1].young *= two_rocks_ ? stiffer_ : 1;
    JointMaterial joint;
    joint.bonded = true;
    joint.law = InterfaceLaw::consistent;
    model.joints = {joint};
    const int count = side * parts;
    for (int row = 0; row < count; ++row)
      for (int i = 0; i < count; ++i) add_block(row, i, parts, model);
    add_what_acts(parts, model);
    return model;
  }

  [[nodiscard]] Stage stage() const {
    Stage stage = stage_of(generalized_alpha_integrator(0.85), 1, 1);
    stage.correct_block_dispersion = stage.correct_time_dispersion = true;
    stage.duration = duration_;
    stage.chosen.dt.automatic = leaves_dt_;
    stage.dt = leaves_dt_ ? 0 : dt_of(share_of_limit_);
    return stage;
  }
  // The dt (s) of this share of the time in which P waves cross a quarter of a block, about the limit of stability.
  [[nodiscard]] double dt_of(double share) const {
    return duration_ / std::ceil(duration_ / (share * 0.25 * width_ / p_speed()));
  }
  [[nodiscard]] bool is_kinked() const { return kinked_ || at_once_; }
  [[nodiscard]] bool is_skewed() const { return skewed_; }
  [[nodiscard]] bool leaves_dt() const { return leaves_dt_; }

 private:
  double number(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  bool chance(double share) { return std::bernoulli_distribution(share)(random_); }

  [[nodiscard]] double speed() const { return std::sqrt(rock_.young / (2 * (1 + rock_.poisson)) / rock_.density); }
  [[nodiscard]] double p_speed() const {
    return speed() * std::sqrt(2.5 / (1 - rock_.poisson)) * (two_rocks_ ? 1.4 : 1);
  }

  // Running bonds shift whole blocks, so their parts shift with them.
  void add_block(int row, int i, int parts, Model& model) const {
    const double w = width_ / parts, h = height_ / parts;
    const double shift = row / parts % 2 == 1 ? shift_ * width_ : 0;
    Block& block = model.blocks.emplace_back();
    block.shape.outer = box_ring(i * w + shift, row * h, i * w + shift + w, row * h + h);
    if (skewed_)
      for (Vec2& corner : block.shape.outer) corner = skewed(corner);
    block.material = row / parts < side / 2 ? 0 : 1;
  }

  // How far corners of whole blocks are moved, those on the outside not; corners of parts lie on lines between them.
  [[nodiscard]] Vec2 off_grid(double i, double j) const {
    if (i <= 0 || j <= 0 || i >= side || j >= side) return Vec2::Zero();
    return 0.12 * Vec2(width_ * std::sin(12.9898 * i + 78.233 * j), height_ * std::sin(39.3468 * i + 11.135 * j));
  }
  [[nodiscard]] Vec2 skewed(const Vec2& place) const {
    constexpr double round_off = 1e-9;
    const double x = place.x() / width_, y = place.y() / height_;
    const double i = std::floor(x + round_off), j = std::floor(y + round_off), s = x - i, t = y - j;
    return place + (1 - s) * (1 - t) * off_grid(i, j) + s * (1 - t) * off_grid(i + 1, j) +
           (1 - s) * t * off_grid(i, j + 1) + s * t * off_grid(i + 1, j + 1);
  }

  void add_what_acts(int parts, Model& model) const {
    const int count = side * parts;
    const double h = height_ / parts, end = side * width_;
    if (in_the_rock_) add_point_load(count, parts, model);
    for (int row = 0; row < count; ++row) {
      const int left = row * count, right = left + count - 1;
      const double shift = row / parts % 2 == 1 ? shift_ * width_ : 0;
      if (!in_the_rock_) add_edge_load(left, {shift, (row + 1) * h}, {shift, row * h}, model);
      if (!absorbing_ || (held_ && row < parts)) continue;
      const double rho = rock_.density;
      model.viscous_edges.push_back(
          {right, {end + shift, row * h}, {end + shift, (row + 1) * h}, rho * p_speed(), rho * speed(), 0});
    }
    for (int i = 0; held_ && i < count * parts; ++i)
      model.held_blocks.push_back({i, Vec2::Zero(), 0, Vec2::Zero(), {}});
  }

  [[nodiscard]] std::vector<std::pair<double, TimeFunction>> pulse() const {
    if (at_once_) return {{1, ExponentialDecay{1 / frequency_, 0, 0.25 / frequency_}}};
    if (kinked_) return {{1, SineCycles{frequency_, 1, 0}}};
    return {{1, SineCycles{frequency_, 1, 0}}, {-0.5, SineCycles{2 * frequency_, 2, 0}}};
  }

  void add_edge_load(int block, const Vec2& from, const Vec2& to, Model& model) const {
    for (const auto& [factor, history] : pulse())
      model.edge_loads.push_back({block, from, to, factor * traction_, history});
  }

  // Spread over a square of 4 x 4 blocks, or what it would not be the same in finer ones.
  void add_point_load(int count, int parts, Model& model) const {
    const int first = (side / 2 - 2) * parts;
    for (int row = first; row < first + 4 * parts; ++row)
      for (int i = first; i < first + 4 * parts; ++i) {
        const int block = row * count + i;
        const Box box = bounding_box(model.blocks[static_cast<std::size_t>(block)].shape);
        for (const auto& [factor, history] : pulse())
          model.point_loads.push_back(
              {block, (box.lower + box.upper) / 2, factor / (parts * parts) * traction_ * width_, history});
      }
  }

  std::mt19937 random_;
  Material rock_{"rock", 2600, 5e10, 0.25, PlaneState::stress};
  double width_ = 1, height_ = 1, shift_ = 0, stiffer_ = 1, frequency_ = 0, share_of_limit_ = 1, duration_ = 0;
  Vec2 traction_;
  bool skewed_, two_rocks_, kinked_, in_the_rock_, absorbing_, held_, at_once_, leaves_dt_;
};

// Reads displacements at the middles of the plate's own blocks, all over it.
std::vector<double> readings(const Simulation& simulation, const std::vector<Vec2>& middles, int parts) {
  std::vector<double> values;
  const int count = RandomPlate::side * parts;
  for (int row = 4; row < RandomPlate::side; row += 9)
    for (int i = 4; i < RandomPlate::side; i += 9) {
      const int block = (row * parts + parts / 2) * count + i * parts + parts / 2;
      const int own = row * RandomPlate::side + i;
      const Vec2& middle = middles[static_cast<std::size_t>(own)];
      const Vec2 moved = point_displacement(simulation.model(), simulation.state(), block, middle);
      values.insert(values.end(), {moved.x(), moved.y()});
    }
  return values;
}

Histories run(Model model, const std::vector<Vec2>& middles, std::string& reason, double* dt = nullptr) {
  finish_model(model);
  const int parts = model.blocks.size() == middles.size() ? 1 : finer;
  const std::clock_t begun = std::clock();
  Simulation simulation(std::move(model));
  reason = simulation.model().stages[0].chosen.integrator.reason;
  if (dt != nullptr) *dt = simulation.model().stages[0].dt;
  Histories histories;
  while (!simulation.finished() && simulation.step() == Status::ok) {
    histories.times.push_back(simulation.state().time);
    histories.values.push_back(readings(simulation, middles, parts));
  }
  EXPECT_TRUE(simulation.finished()) << simulation.message();
  histories.cpu = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
  return histories;
}

// The relative L2 norm of the difference; the reference is interpolated between its moments.
double error_of(const Histories& run, const Histories& reference) {
  double off = 0, size = 0;
  std::size_t k = 0;
  for (std::size_t n = 0; n < run.times.size(); ++n) {
    while (k + 2 < reference.times.size() && reference.times[k + 1] < run.times[n]) ++k;
    const double share = (run.times[n] - reference.times[k]) / (reference.times[k + 1] - reference.times[k]);
    for (std::size_t i = 0; i < run.values[n].size(); ++i) {
      const double wanted = (1 - share) * reference.values[k][i] + share * reference.values[k + 1][i];
      off += std::pow(run.values[n][i] - wanted, 2);
      size += wanted * wanted;
    }
  }
  return std::sqrt(off / size);
}

struct Compared {
  bool is_chosen = false;
  double implicit_error = 0, explicit_error = 0;
  double implicit_cpu = 0, explicit_cpu = 0;
};

Compared compare(unsigned seed) {
  const RandomPlate plate(seed);
  Model model = plate.model(1);
  model.stages = {plate.stage()};
  std::string reason, none;
  std::vector<Vec2> middles;
  for (const Block& block : model.blocks) middles.push_back(area_moments(block.shape).centroid);
  const Histories implicit = run(model, middles, none);
  model.stages[0].chosen.integrator.automatic = true;
  double dt = 0;
  const Histories chosen = run(model, middles, reason, &dt);
  std::cout << seed << (plate.is_kinked() ? " kinked " : " smooth ") << (plate.is_skewed() ? "skewed " : "")
            << (plate.leaves_dt() ? "auto " : "given ") << reason;
  Compared compared;
  compared.is_chosen = reason.starts_with("explicit");
  if (compared.is_chosen) {
    Model fine = plate.model(finer);
    fine.stages = {plate.stage()};
    fine.stages[0].integrator = central_difference_integrator();
    fine.stages[0].chosen.dt.automatic = false;
    fine.stages[0].dt = fine.stages[0].duration / std::ceil(fine.stages[0].duration / (dt / finer));
    const Histories reference = run(fine, middles, none);
    compared.implicit_error = error_of(implicit, reference);
    compared.explicit_error = error_of(chosen, reference);
    compared.implicit_cpu = implicit.cpu, compared.explicit_cpu = chosen.cpu;
    std::cout << ": error " << compared.implicit_error << " -> " << compared.explicit_error << ", ratio "
              << compared.explicit_error / compared.implicit_error << ", cpu " << implicit.cpu << " -> " << chosen.cpu;
  }
  std::cout << std::endl;
  return compared;
}

void expect_to_gain(unsigned first, unsigned last) {
  double implicit_cpu = 0, explicit_cpu = 0;
  int chosen = 0;
  for (unsigned seed = first; seed < last; ++seed) {
    const Compared compared = compare(seed);
    if (!compared.is_chosen) continue;
    ++chosen;
    implicit_cpu += compared.implicit_cpu, explicit_cpu += compared.explicit_cpu;
    EXPECT_LT(compared.explicit_error, 1.05 * compared.implicit_error) << "seed " << seed;
  }
  EXPECT_GT(chosen, static_cast<int>(last - first) / 3);
  EXPECT_LT(explicit_cpu, 0.7 * implicit_cpu);
}

TEST(IntegratorChoice, GainsAndLosesNoAccuracyInPlates) { expect_to_gain(0, 3); }
TEST(IntegratorChoice, DISABLED_SixtyMorePlates) { expect_to_gain(5, 65); }

// A plate whose stage is left to the engine, and that would have explicit steps.
Model left_open(const std::function<void(Model&)>& change) {
  const RandomPlate plate(1);
  Model model = plate.model(1);
  model.stages = {plate.stage()};
  model.stages[0].chosen.integrator.automatic = true;
  model.stages[0].chosen.dt.automatic = false;
  model.stages[0].dt = plate.dt_of(0.5);
  change(model);
  finish_model(model);
  return model;
}

bool gets_explicit_steps(const std::function<void(Model&)>& change) {
  const Simulation simulation(left_open(change));
  const Stage& stage = simulation.model().stages[0];
  EXPECT_EQ(simulation.plan().explicit_steps, stage.integrator.is_explicit());
  EXPECT_EQ(simulation.stability_limit(0) > 0, stage.integrator.is_explicit());
  return stage.integrator.is_explicit();
}

TEST(IntegratorChoice, KeepsImplicitStepsWhereTheyAreWanted) {
  EXPECT_TRUE(gets_explicit_steps([](Model&) {}));
  EXPECT_FALSE(gets_explicit_steps([](Model& m) { m.stages[0].chosen.integrator.automatic = false; }));
  EXPECT_FALSE(gets_explicit_steps([](Model& m) { m.stages[0].correct_time_dispersion = false; }));
  EXPECT_FALSE(gets_explicit_steps([](Model& m) { m.stages[0].correct_block_dispersion = false; }));
  EXPECT_FALSE(gets_explicit_steps([](Model& m) { m.stages[0].strain_inertia = 1.5; }));
  EXPECT_FALSE(gets_explicit_steps([](Model& m) { m.stages[0].material_damping.stiffness = 1e-6; }));
  EXPECT_FALSE(gets_explicit_steps([](Model& m) { m.stages[0].kinematics = Kinematics::finite; }));
  EXPECT_FALSE(gets_explicit_steps([](Model& m) { m.joints[0].bonded = false; }));
  EXPECT_FALSE(gets_explicit_steps([](Model& m) { m.stages[0].duration = 10 * m.stages[0].dt; }));  // soon done
  EXPECT_FALSE(gets_explicit_steps([](Model& m) { m.blocks[1000].initial_spin = 1; }));
  const auto load = [](Model& m, int block) {
    m.point_loads.push_back({block, m.blocks[static_cast<std::size_t>(block)].shape.outer[0], Vec2(1e5, 0), {}});
  };
  EXPECT_FALSE(gets_explicit_steps([&](Model& m) { load(m, 1000); }));
  EXPECT_TRUE(gets_explicit_steps([&](Model& m) { load(m, 1000), load(m, 1001); }));
}

// Above its limit a given dt is no reason to refuse a scene that runs with implicit steps.
TEST(IntegratorChoice, RefusesNothing) {
  const double limit =
      stability_limit(left_open([](Model& m) { m.stages[0].integrator = central_difference_integrator(); }), 0);
  EXPECT_FALSE(gets_explicit_steps([&](Model& m) { m.stages[0].dt = 2 * limit, m.stages[0].duration = 4000 * limit; }));
  const auto stiff_support = [](Model& m) {
    m.supports = {{RandomPlate::side, m.blocks[RandomPlate::side].shape.outer[0], true, true, 1e15, Vec2::Zero(), {}}};
  };
  EXPECT_FALSE(gets_explicit_steps(stiff_support));
}

// The model of a run, run again: what was chosen stays.
TEST(IntegratorChoice, IsMadeOnce) {
  const Simulation first(left_open([](Model&) {}));
  const Simulation second(first.model());
  const Stage &before = first.model().stages[0], &after = second.model().stages[0];
  EXPECT_TRUE(after.integrator.is_explicit());
  EXPECT_EQ(after.dt, before.dt);
  EXPECT_EQ(after.chosen.integrator.reason, before.chosen.integrator.reason);
}

// A dt that is left to the engine may become shorter, but not where each step damps: there it would damp more.
TEST(IntegratorChoice, ShortensNoStepsThatDampEach) {
  const double limit =
      stability_limit(left_open([](Model& m) { m.stages[0].integrator = central_difference_integrator(); }), 0);
  const auto long_steps = [&](double factor, double damping_rate) {
    return left_open([&](Model& m) {
      Stage& stage = m.stages[0];
      stage.chosen.dt.automatic = true;
      stage.dt = 1.2 * limit, stage.duration = 4000 * limit;
      stage.velocity_factor = factor, stage.damping_rate = damping_rate;
    });
  };
  const auto dt_of = [](const Model& model) { return Simulation(model).model().stages[0].dt; };
  EXPECT_LT(dt_of(long_steps(1, 0)), limit);
  EXPECT_LT(dt_of(long_steps(1, 10)), limit);
  EXPECT_EQ(dt_of(long_steps(0.99, 0)), 1.2 * limit);
}

// The limit that few products tell is below the one that many do, and not far where it must not be.
TEST(IntegratorChoice, StepsAreBelowTheLimit) {
  std::mt19937 random(73);
  for (int scene = 0; scene < 30; ++scene) {
    const RandomBondedScene drawn(random, true);
    const Model model = drawn.with(explicit_stage(1e-9, 1));
    const ContactSet contacts = make_contacts(model);
    const double limit = stability_limit(model, 0);
    const auto asked = [&](double wanted, double least, double close) {
      return stable_step(model, 0, contacts, {wanted, least, close});
    };
    if (asked(1e-9, 0, 0.995) == 0) continue;  // inertia couples blocks
    const double roughly = asked(1, 0, 0.95);
    EXPECT_LE(roughly, 1.005 * limit);
    EXPECT_GE(roughly, 0.94 * limit);
    EXPECT_GE(asked(0.3 * limit, 0.3 * limit, 0.995), 0.3 * limit);
    EXPECT_GE(asked(0.98 * limit, 0.98 * limit, 0.995), 0.98 * limit);
    EXPECT_EQ(asked(1.02 * limit, 1.02 * limit, 0.995), 0);
    EXPECT_EQ(asked(1, 3 * limit, 0.95), 0);
  }
}

}  // namespace
}  // namespace dda
