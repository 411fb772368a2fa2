// Random rock, cut from one piece with short faces, needles and slivers on purpose, thrown, dropped and stacked: no run
// may gain energy, let blocks through each other or stop.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "engine/geometry/cut_pieces.h"
#include "engine/geometry/overlap.h"
#include "engine/geometry/rotation.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr double dt = 5e-5;  // s
constexpr int steps = 150;
constexpr double least_area = 1e-4;  // m2; pieces have a radius of 1 m

Model rock_of(const std::vector<Ring>& blocks, SeededNumbers& random) {
  Model model;
  model.materials = {{"rock", 2700, 50e9, 0.25, PlaneState::strain}};
  JointMaterial joint;
  joint.law = InterfaceLaw::classical;
  joint.friction_angle = random.chance(0.3) ? 0 : random.number(0.2, 0.8);
  model.joints = {joint};
  for (const Ring& ring : blocks) {
    Block& block = model.blocks.emplace_back();
    block.name = "block " + std::to_string(model.blocks.size());
    block.shape.outer = ring;
  }
  // An integrator that loses energy by itself, so that what is gained is the contacts'. The steps are far too long for
  // what small blocks do on their springs.
  model.stages = {stage_of(thesis_integrator(), dt, steps, Kinematics::finite)};
  return model;
}

// Velocities that leave the centre of mass at rest, so that the energy is all in what blocks do to each other.
void throw_about(Model& model, SeededNumbers& random, double speed) {
  Vec2 momentum = Vec2::Zero();
  double area = 0;
  for (Block& block : model.blocks) {
    block.initial_velocity = speed * random.number(0, 1) * random.direction();
    momentum += signed_area(block.shape.outer) * block.initial_velocity;
    area += signed_area(block.shape.outer);
  }
  for (Block& block : model.blocks) block.initial_velocity -= momentum / area;
}

void hold(Model& model, int block) {
  model.held_blocks.emplace_back().block = block;
  model.blocks[static_cast<std::size_t>(block)].initial_velocity = Vec2::Zero();
}

// Below all of them.
void add_floor(Model& model, double gap) {
  double lowest = 1e300;
  for (const Block& block : model.blocks)
    for (const Vec2& vertex : block.shape.outer) lowest = std::min(lowest, vertex.y());
  Block& floor = model.blocks.emplace_back();
  floor.name = "floor";
  floor.shape.outer = box_ring(-5, lowest - gap - 1, 5, lowest - gap);
  hold(model, static_cast<int>(model.blocks.size()) - 1);
  model.gravity = {0, -9.81};
}

std::vector<Ring> two_neighbours(SeededNumbers& random) {
  while (true) {
    const std::vector<Ring> blocks = random_blocks(random, random.integer(1, 5), least_area);
    if (blocks.size() < 2) continue;
    const Ring& a = random.one_of(blocks);
    const Ring& b = random.one_of(blocks);
    if (&a == &b) continue;
    for (const Vec2& vertex : a)
      if (locate({b, {}}, vertex, 1e-9) == Location::boundary) return {a, b};
  }
}

Model random_scene(std::uint64_t seed) {
  SeededNumbers random(seed);
  const double kind = random.number(0, 1);
  if (kind < 0.4) {  // two neighbours against each other, one of them held or not
    Model model = rock_of(two_neighbours(random), random);
    throw_about(model, random, random.magnitude(-1.5, 0));
    if (random.chance(0.4)) hold(model, 0);
    return model;
  }
  Model model = rock_of(random_blocks(random, random.integer(2, 6), least_area), random);
  if (kind < 0.7) {
    throw_about(model, random, random.magnitude(-1.5, 0));
  } else {  // dropped, or laid on a floor that it hardly touches
    add_floor(model, random.chance(0.5) ? 0 : random.magnitude(-5, -3));
    if (random.chance(0.5)) throw_about(model, random, 0.1);
    model.blocks.back().initial_velocity = Vec2::Zero();
  }
  return model;
}

// What there is beyond what there was and what loads brought, as a share of the most that there was to have.
struct Gain {
  double worst = 0;
  double most = 1e-9;  // J/m

  void look(const EnergyLedger& energy) {
    const double had = energy.initial.kinetic + energy.initial.strain + energy.initial.contact;
    const double stored = energy.kinetic + energy.strain + energy.contact;
    const double brought = energy.external_work + energy.gravity_work;
    most = std::max({most, had, std::abs(energy.gravity_work), energy.kinetic});
    worst = std::max(worst, (stored - had - brought) / most);
  }
};

Polygon shape_now(const Simulation& simulation, std::size_t block) {
  const Model& model = simulation.model();
  Polygon shape = model.blocks[block].shape;
  const Vec2 now = current_centroid(model, simulation.state(), static_cast<int>(block));
  for (Vec2& vertex : shape.outer)
    vertex = now + simulation.state().deformation[block] * (vertex - model.blocks[block].moments.centroid);
  return shape;
}

// Two blocks of which one is deeper in the other than `share` of the smaller one's size, or an empty string.
std::string blocks_in_each_other(const Simulation& simulation, double share) {
  const std::size_t count = simulation.model().blocks.size();
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Polygon a = shape_now(simulation, i);
      const Polygon b = shape_now(simulation, j);
      const double size = std::sqrt(std::min(signed_area(a.outer), signed_area(b.outer)));
      if (interiors_overlap(a, b, share * size))
        return simulation.model().blocks[i].name + " and " + simulation.model().blocks[j].name;
    }
  return "";
}

enum class Contacts { springs, chosen_springs, projected };

Model random_scene(std::uint64_t seed, Contacts contacts) {
  Model model = random_scene(seed);
  JointMaterial& joint = model.joints[0];
  joint.automatic_stiffness = contacts == Contacts::chosen_springs;
  if (contacts == Contacts::projected) joint.law = InterfaceLaw::projected;
  return model;
}

// Springs that go by the length of a face are up to 1e7 times as stiff as what the step resolves of a needle's inertia.
// 6.6e-8 is the worst of 24,000 scenes (seeds 2000 to 25999, seed 3559), and 12 of them are above 1e-9.
double round_off(Contacts contacts) { return contacts == Contacts::springs ? 1e-9 : 2e-7; }

// A sentence on what is wrong, or an empty string.
std::string fault_of(std::uint64_t seed, Contacts contacts, double& worst_gain) {
  Model model = random_scene(seed, contacts);
  Simulation simulation = simulation_of(std::move(model));
  Gain gain;
  gain.look(simulation.energy());
  while (!simulation.finished()) {
    const Status status = simulation.step();
    if (status != Status::ok) return std::string(to_string(status)) + ": " + simulation.message();
    gain.look(simulation.energy());
  }
  worst_gain = std::max(worst_gain, gain.worst);
  const double residual = std::abs(simulation.energy().relative_residual());
  if (gain.worst > 1e-6) return fmt::format("gains {:.2g}", gain.worst);
  if (residual > round_off(contacts)) return fmt::format("energy out of balance by {:.2g}", residual);
  const std::string overlap = blocks_in_each_other(simulation, 5e-3);
  return overlap.empty() ? "" : "deep in each other: " + overlap;
}

int faults(std::uint64_t first, int count, Contacts contacts = Contacts::springs) {
  int wrong = 0;
  double worst_gain = 0;
  for (int i = 0; i < count; ++i) {
    const std::uint64_t seed = first + static_cast<std::uint64_t>(i);
    const std::string fault = fault_of(seed, contacts, worst_gain);
    if (fault.empty()) continue;
    ++wrong;
    std::printf("seed %llu: %s\n", static_cast<unsigned long long>(seed), fault.c_str());
  }
  std::printf("largest gain of energy: %.2g of what there was\n", worst_gain);
  return wrong;
}

TEST(ContactFuzz, RandomRockGainsNothingAndDoesNotStop) {
  for (const Contacts contacts : {Contacts::springs, Contacts::chosen_springs, Contacts::projected})
    EXPECT_EQ(faults(1, 40, contacts), 0) << static_cast<int>(contacts);
}

// A face that grows brings a contact where blocks already lie deeper in each other than beside it. It had the depth of
// the one beside all the same, and brought more energy than there was.
TEST(ContactFuzz, FacesThatGrowGainNothing) {
  for (const std::uint64_t seed : {2145U, 2188U, 2481U, 2540U, 2730U, 2851U, 3267U, 3725U, 4129U, 5239U})
    EXPECT_EQ(faults(seed, 1, Contacts::chosen_springs), 0);
  EXPECT_EQ(faults(5239, 1, Contacts::projected), 0);
}

// A sliver that is pressed by the last few millimetres of its face. The bed there gave way by the width of its large
// neighbour, and the sliver lay 0.0059 of its size in that one.
TEST(ContactFuzz, SliversDoNotSinkInWhereTheirFacesGape) { EXPECT_EQ(faults(5570, 1, Contacts::projected), 0); }

// Passes that went far and came back left round-off in the gaps, and other round-off in the increments that the balance
// is taken of: needles' contacts had forces that were 1e-4 off it. Ledgers were off by 2.9e-7, 6e-3, 0.1 and 4e-5.
TEST(ContactFuzz, ForcesAreThoseOfTheIncrements) {
  for (const std::uint64_t seed : {5292U, 9672U, 17013U, 18338U})
    EXPECT_EQ(faults(seed, 1, Contacts::chosen_springs), 0);
}

TEST(ContactFuzz, DISABLED_ThousandsOfScenes) {
  EXPECT_EQ(faults(1000, 500, Contacts::springs), 0);
  EXPECT_EQ(faults(2000, 6000, Contacts::chosen_springs), 0);
  EXPECT_EQ(faults(2000, 6000, Contacts::projected), 0);
}

// ---- The same scene seen from elsewhere.

struct View {
  Mat2 turn = Mat2::Identity();  // a reflection where its determinant is negative
  Vec2 shift = Vec2::Zero();     // m
  double scale = 1;              // of lengths and times: speeds and stresses stay
  bool renumbered = false;
};

Model seen(Model model, const View& view) {
  const bool mirrored = cross(view.turn.col(0), view.turn.col(1)) < 0;
  for (Block& block : model.blocks) {
    for (Vec2& vertex : block.shape.outer) vertex = view.scale * (view.turn * vertex) + view.shift;
    block.initial_velocity = view.turn * block.initial_velocity;
    if (mirrored) std::reverse(block.shape.outer.begin(), block.shape.outer.end());
    if (view.renumbered) std::rotate(block.shape.outer.begin(), block.shape.outer.begin() + 1, block.shape.outer.end());
  }
  model.gravity = view.turn * model.gravity / view.scale;
  for (Stage& stage : model.stages) {
    stage.dt *= view.scale;
    stage.duration *= view.scale;
  }
  if (!view.renumbered) return model;
  std::reverse(model.blocks.begin(), model.blocks.end());
  for (HeldBlock& held : model.held_blocks) held.block = static_cast<int>(model.blocks.size()) - 1 - held.block;
  return model;
}

// Displacements of the centroids as the scene that is not seen from elsewhere has them, m.
std::vector<Vec2> displacements(const Model& model, const View& view) {
  Simulation simulation = simulation_of(seen(model, view));
  run(simulation, 60);
  std::vector<Vec2> all;
  for (const Vec6& each : simulation.state().displacement)
    all.emplace_back(view.turn.transpose() * each.head<2>() / view.scale);
  if (view.renumbered) std::reverse(all.begin(), all.end());
  return all;
}

// Coordinates a few metres from the origin are rounded by 4e-16 m, 1e-8 of a gap of 5e-8 m, and each impact multiplies
// that; so only scenes of few blocks, which meet a few times.
TEST(ContactFuzz, MotionDoesNotDependOnTheView) {
  Mat2 mirror = Mat2::Identity();
  mirror(0, 0) = -1;
  const std::vector<View> views = {{Mat2::Identity(), {3, -2}},
                                   {rotation(0.7), {0, 0}},
                                   {mirror, {0, 0}},
                                   {Mat2::Identity(), {0, 0}, 1000},
                                   {Mat2::Identity(), {0, 0}, 1, true},
                                   {rotation(-2) * mirror, {1e-3, 1e-3}, 1e-3, true}};
  int scenes = 0;
  for (std::uint64_t seed = 1; scenes < 36; ++seed) {
    const Model model = random_scene(seed, scenes % 3 == 0   ? Contacts::springs
                                           : scenes % 3 == 1 ? Contacts::chosen_springs
                                                             : Contacts::projected);
    if (model.blocks.size() != 2) continue;
    ++scenes;
    const std::vector<Vec2> expected = displacements(model, {});
    double largest = 0;
    for (const Vec2& each : expected) largest = std::max(largest, each.norm());
    for (std::size_t view = 0; view < views.size(); ++view) {
      const std::vector<Vec2> actual = displacements(model, views[view]);
      double difference = 0;
      for (std::size_t i = 0; i < actual.size(); ++i)
        difference = std::max(difference, (actual[i] - expected[i]).norm());
      EXPECT_LT(difference, 1e-6 * largest) << "seed " << seed << ", view " << view;
    }
  }
}

}  // namespace
}  // namespace dda
