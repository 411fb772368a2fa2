// Reactions of random scenes with all that damps, against the balance of momentum: loads, weights and motions, and what
// absorbing edges take, from the drawing and the blocks' rates alone.
#include <gtest/gtest.h>

#include "engine/geometry/box.h"
#include "engine/geometry/segment.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/measured_models.h"

namespace dda {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

const Vec2 elsewhere(0.4, -1.9);

class Numbers {
 public:
  explicit Numbers(unsigned seed) : random_(seed) {}
  double between(double least, double most) { return std::uniform_real_distribution<double>(least, most)(random_); }
  bool chance(double share) { return between(0, 1) < share; }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  Vec2 vector(double most) { return {between(-most, most), between(-most, most)}; }

 private:
  std::mt19937 random_;
};

Vec3 about(const Vec2& place, const Vec2& force, double moment = 0) {
  return {force.x(), force.y(), moment + cross(place - elsewhere, force)};
}

Vec2 centroid_of(const Simulation& simulation, int block) {
  return simulation.plan().finite_kinematics ? current_centroid(simulation.model(), simulation.state(), block)
                                             : simulation.model().blocks[at(block)].moments.centroid;
}

// Momentum and moment of momentum of what is not held, by these rates of rectangles that are hardly deformed.
Vec3 momentum_of(const Simulation& simulation, const std::vector<Vec6>& rates) {
  const Model& model = simulation.model();
  Vec3 sum = Vec3::Zero();
  for (int block = 0; block < static_cast<int>(model.blocks.size()); ++block) {
    if (model.is_held(block)) continue;
    const Vec6& rate = rates[at(block)];
    const Box box = bounding_box(model.blocks[at(block)].shape);
    const Vec2 size = box.upper - box.lower;
    const double mass = model.mass_of(block);
    const double spin =
        mass / 12 * (size.squaredNorm() * rate(2) + (size.x() * size.x() - size.y() * size.y()) / 2 * rate(5));
    sum += about(centroid_of(simulation, block), mass * rate.head<2>(), spin);
  }
  return sum;
}

Vec3 loads_and_weights(const Simulation& simulation) {
  const Model& model = simulation.model();
  Vec3 sum = Vec3::Zero();
  for (int block = 0; block < static_cast<int>(model.blocks.size()); ++block)
    if (!model.is_held(block)) sum += about(centroid_of(simulation, block), model.mass_of(block) * model.gravity);
  for (const PointLoad& load : model.point_loads) {
    const Vec2 place = simulation.plan().finite_kinematics
                           ? current_position(model, simulation.state(), load.block, load.point)
                           : load.point;
    sum += about(place, evaluate(load.history, simulation.state().time) * load.force);
  }
  return sum;
}

// The traction -Z v along an edge as drawn: a parabola with its moments, which Simpson's rule takes whole.
Vec3 absorbed(const Simulation& simulation) {
  Vec3 sum = Vec3::Zero();
  for (const ViscousEdge& edge : simulation.model().viscous_edges) {
    const Vec2 along = (edge.to - edge.from).normalized();
    const Vec2 across(along.y(), -along.x());
    const Vec6& v = simulation.state().velocity[at(edge.block)];
    const Vec2 centroid = simulation.model().blocks[at(edge.block)].moments.centroid;
    for (const auto& [share, weight] : {std::pair(0.0, 1.0), std::pair(0.5, 4.0), std::pair(1.0, 1.0)}) {
      const Vec2 place = edge.from + share * (edge.to - edge.from);
      const Vec2 arm = place - centroid;
      const Vec2 velocity = v.head<2>() + v(2) * Vec2(-arm.y(), arm.x()) +
                            Vec2(v(3) * arm.x() + v(5) / 2 * arm.y(), v(4) * arm.y() + v(5) / 2 * arm.x());
      const Vec2 traction =
          -edge.normal_impedance * velocity.dot(across) * across - edge.shear_impedance * velocity.dot(along) * along;
      sum += about(place, weight / 6 * (edge.to - edge.from).norm() * traction);
    }
  }
  return sum;
}

// A wall on a floor that is held, which goes off with a constant acceleration or stands still; loads, supports of
// blocks and of the floor, absorbing edges and bolts as they come.
Model wall(const JointMaterial& joint, const Stage& stage, Numbers& random) {
  constexpr int size = 3;
  Model model = grid_of(size, joint, random.chance(0.5) ? Pattern::running_bond : Pattern::stack);
  model.blocks.insert(model.blocks.begin(), rectangle("floor", -1, -1, size + 2, 1));
  model.gravity = {0, -10};
  model.held_blocks.resize(1);
  if (random.chance(0.7)) {
    model.held_blocks[0].amplitude = random.vector(3);
    model.held_blocks[0].kind = MotionKind::acceleration;
    model.held_blocks[0].history = Constant{};
  }
  finish_model(model);
  const int blocks = static_cast<int>(model.blocks.size());
  for (int block = 0; block < blocks; ++block)
    model.point_loads.push_back({block, model.blocks[at(block)].moments.centroid + random.vector(0.2),
                                 random.vector(2e4), SineCycles{random.between(20, 300), 50, 0}});
  Measurement& reaction = measure(model, Quantity::reaction);
  reaction.blocks = {0};
  reaction.about = elsewhere;
  for (int i = random.below(4); i > 0; --i) {
    const int block = random.below(blocks);
    const Ring& corners = model.blocks[at(block)].shape.outer;
    PointSupport support{
        block, corners[at(random.below(4))], true, random.chance(0.5), random.between(1e7, 1e9), Vec2::Zero(), {}};
    if (random.chance(0.5)) {
      support.amplitude = random.vector(5e-5);
      support.history = SineCycles{random.between(50, 300), 50, 0};
    }
    model.supports.push_back(support);
    reaction.supports.push_back(static_cast<int>(model.supports.size()) - 1);
  }
  const Ring& last = model.blocks.back().shape.outer;
  if (stage.kinematics == Kinematics::small && random.chance(0.5))
    model.viscous_edges = {{blocks - 1, last[1], last[2], random.between(1e5, 1e7), random.between(1e5, 1e7)}};
  model.stages = {stage};
  return model;
}

struct Balance {
  Vec3 forces, inertia, dashpots;
};

// What dashpots of contacts do to the floor is the mean of the step, and so has no share of the moment before.
Vec3 dashpots_on_floor(const Simulation& simulation) {
  Vec3 sum = Vec3::Zero();
  const ContactSet& contacts = simulation.contacts();
  const Vec2 centroid = centroid_of(simulation, 0);
  for (std::size_t i = 0; i < contacts.elements.size() && !simulation.plan().linear; ++i)
    for (const auto& [block, rows] : {std::pair(contacts.elements[i].block_a, contacts.elements[i].rows_a),
                                      std::pair(contacts.elements[i].block_b, contacts.elements[i].rows_b)}) {
      if (block != 0) continue;
      const Eigen::Index used = is_lone_vertex(contacts.elements[i]) ? 2 : 4;
      const Vec3 force = rows.topRows(used).leftCols<3>().transpose() * contacts.states[i].dashpot.head(used);
      sum += about(centroid, force.head<2>(), force(2));
    }
  return sum;
}

Balance balance_of(const Simulation& simulation) {
  const std::vector<double> reaction = sampled(simulation);
  const double drag = simulation.model().stages[0].material_damping.mass;
  return {Vec3(reaction[0], reaction[1], reaction[2]) + loads_and_weights(simulation) + absorbed(simulation) -
              drag * momentum_of(simulation, simulation.state().velocity),
          momentum_of(simulation, simulation.state().acceleration), dashpots_on_floor(simulation)};
}

struct Precision {
  double force, moment;  // of the largest forces
};

void expect_momentum(Model model, int steps, const Precision& precision, const std::string& what) {
  Simulation simulation = simulation_of(std::move(model));
  const Integrator& integrator = simulation.model().stages[0].integrator;
  Balance before = balance_of(simulation);
  double largest = 0;
  for (int i = 0; i < steps; ++i) {
    ASSERT_EQ(simulation.step(), Status::ok) << what;
    const Balance now = balance_of(simulation);
    largest = std::max(largest, now.forces.norm() + now.inertia.norm());
    const Vec3 left = (1 - integrator.alpha_f) * (now.forces - now.dashpots) +
                      integrator.alpha_f * (before.forces - before.dashpots) + now.dashpots -
                      (1 - integrator.alpha_m) * now.inertia - integrator.alpha_m * before.inertia;
    ASSERT_LT(left.head<2>().norm(), precision.force * largest) << what << ", step " << i;
    ASSERT_LT(std::abs(left(2)), precision.moment * largest) << what << ", step " << i;
    before = now;
  }
}

constexpr unsigned seeds = 60;

// Accelerations are second differences of displacements of 1e-3 m at most, in steps of 1e-4 s.
constexpr Precision round_off{1e-8, 1e-8};

TEST(ReactionPopulation, OfDampedBondedRock) {
  for (unsigned seed = 0; seed < seeds; ++seed) {
    Numbers random(seed);
    const Integrator integrator = dynamic_integrators()[seed % dynamic_integrators().size()];
    Stage stage = stage_of(integrator, random.between(2e-5, 1e-4), 60);
    stage.material_damping = {random.chance(0.5) ? random.between(1, 100) : 0, random.between(1e-6, 1e-3)};
    const JointMaterial joint = bond(random.chance(0.5) ? InterfaceLaw::consistent : InterfaceLaw::classical);
    const Model model = wall(joint, stage, random);
    expect_momentum(model, 60, round_off, fmt::format("seed {}, {}", seed, integrator.name));
  }
}

// Nothing but its contacts acts on the floor then: what holds it is what it gives them, by whichever measurement.
TEST(ReactionPopulation, OfAFloorIsWhatItsContactsCarry) {
  for (unsigned seed = 0; seed < seeds; ++seed) {
    Numbers random(seed + 2000);
    Stage stage = stage_of(thesis_integrator(), 1e-4, 40);
    JointMaterial joint = bond(seed % 2 == 0 ? InterfaceLaw::consistent : InterfaceLaw::classical);
    if (seed % 3 == 0) {
      joint = {};
      joint.friction_angle = 0.5;
      joint.contact_damping = 0.5;
    } else {
      stage.material_damping = {0, random.between(1e-5, 1e-3)};
    }
    Model model = wall(joint, stage, random);
    model.supports.clear();
    model.measurements[0].supports.clear();
    std::erase_if(model.point_loads, [](const PointLoad& load) { return load.block == 0; });
    Measurement& contact = measure(model, Quantity::contact_force);
    contact.blocks = {0};
    for (int block = 1; block < static_cast<int>(model.blocks.size()); ++block) contact.others.push_back(block);
    Measurement& cut = measure(model, Quantity::resultant);  // the floor is on its left
    cut.from = {5, 0};
    cut.to = {-2, 0};
    cut.about = elsewhere;
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, 40);
    const std::vector<double> values = sampled(simulation);
    const double unit = std::hypot(values[0], values[1]);
    EXPECT_GT(unit, 1e3) << seed;
    for (const std::size_t i : {0U, 1U}) {
      EXPECT_NEAR(values[3 + i], -values[i], 1e-9 * unit) << seed;
      EXPECT_NEAR(values[7 + i], -values[i], 1e-9 * unit) << seed;
    }
    EXPECT_NEAR(values[9], -values[2], 1e-9 * unit) << seed;
  }
}

// The same under joints that can open and slide, with dashpots and a bolt to the floor.
TEST(ReactionPopulation, OfDryJointsWithDashpots) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite})
    for (unsigned seed = 0; seed < seeds; ++seed) {
      Numbers random(seed + 1000);
      // The trapezoidal rule conserves energy here: of a step in which a contact opens or closes it has a mean force
      // that the springs of neither end of the step have.
      const std::vector<Integrator> all = {thesis_integrator(), hht_integrator(0.1), generalized_alpha_integrator(0.8)};
      const Integrator integrator = all[seed % all.size()];
      JointMaterial joint;
      joint.friction_angle = random.between(0.2, 0.8);
      joint.contact_damping = random.chance(0.7) ? random.between(0.05, 0.8) : 0;
      Model model = wall(joint, stage_of(integrator, random.between(2e-5, 1e-4), 60, kinematics), random);
      if (random.chance(0.5)) {
        Bolt bolt;
        bolt.name = "bolt";
        bolt.direction = {0, 1};
        bolt.pretension = random.between(0, 1e4);
        bolt.links = {{0, 1, {0.3, -0.5}, {0.3, 0.4}, 1e8, 0}};
        model.bolts = {bolt};
      }
      // In finite kinematics places are those of now, forces act where they are foreseen in the step.
      const Precision precision = kinematics == Kinematics::small ? round_off : Precision{1e-8, 1e-3};
      expect_momentum(model, 60, precision,
                      fmt::format("seed {}, {}, kinematics {}", seed, integrator.name, static_cast<int>(kinematics)));
    }
}

}  // namespace
}  // namespace dda
