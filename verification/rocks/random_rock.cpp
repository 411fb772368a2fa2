#include "verification/rocks/random_rock.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "engine/geometry/cut_pieces.h"

namespace verify {
namespace {

using Json = nlohmann::ordered_json;
using dda::SeededNumbers;

constexpr double gravity = 9.81;  // m/s2

std::string degrees(double angle) { return fmt::format("{:.4f} deg", angle); }

struct Box {
  double width = 0, height = 0;  // m
};

// Spacings of the three usual distributions about their mean.
Json spacing(SeededNumbers& random, double mean) {
  switch (random.integer(0, 2)) {
    case 0: return {{"mean", mean}, {"deviation", random.number(0, 0.4) * mean}};
    case 1: return {{"mean", mean}, {"distribution", "exponential"}};
    default: return {{"mean", mean}, {"deviation", 0.5 * mean}, {"distribution", "uniform"}};
  }
}

Json joint_set(SeededNumbers& random, double dip, double mean_spacing) {
  while (dip > 90) dip -= 180;
  return {{"dip", {{"mean", degrees(dip)}, {"deviation", degrees(random.number(0, 8))}}},
          {"spacing", spacing(random, mean_spacing)},
          {"joint", "dry"}};
}

// Sets at about equal angles to each other, turned as a whole by lot.
Json joint_sets(SeededNumbers& random, int count, double unit) {
  const double strike = random.number(0, 180);
  Json sets = Json::array();
  for (int k = 0; k < count; ++k)
    sets.push_back(joint_set(random, strike + 180.0 / count * k + random.number(-18, 18),
                             unit * random.number(0.9, 2) * (count == 3 ? 1.3 : 1)));
  return sets;
}

// Joints end within the rock; those of the second set at those of the first.
void let_end(SeededNumbers& random, double unit, Json& sets) {
  for (Json& set : sets) {
    set["name"] = fmt::format("set {}", &set - &sets[0] + 1);
    set["trace_length"] = unit * random.number(2, 6);
    set["persistence"] = random.number(0.5, 0.95);
  }
  if (random.chance(0.5)) sets[1]["ends_at"] = {"set 1"};
}

Json opening(SeededNumbers& random, const Box& box, double unit) {
  const double middle = box.width * random.number(0.4, 0.6), floor = box.height * random.number(0.3, 0.5);
  if (random.chance(0.6))
    return {{"name", "tunnel"},
            {"circle", {{"centre", {middle, floor + unit}}, {"radius", unit * random.number(1.2, 2)}}}};
  const double width = unit * random.number(2, 4);
  return {{"name", "tunnel"},
          {"horseshoe", {{"foot", {middle, floor}}, {"width", width}, {"height", width * random.number(0.6, 1.3)}}}};
}

Json rock(SeededNumbers& random, RockKind kind, const Box& box, double unit) {
  const bool has_three = kind == RockKind::three_sets || kind == RockKind::tunnel;
  Json sets = joint_sets(random, kind == RockKind::grains ? 1 : has_three ? 3 : 2, unit);
  if (kind == RockKind::traces || (kind == RockKind::excavated && random.chance(0.5))) let_end(random, unit, sets);
  Json rock = {{"boundary", {{0, 0}, {box.width, 0}, {box.width, box.height}, {0, box.height}}}};
  if (kind == RockKind::slope) {
    const double toe = box.width * random.number(0.2, 0.5);
    rock["boundary"] = {{0, 0},
                        {box.width, 0},
                        {box.width, box.height},
                        {toe + (box.width - toe) * random.number(0.1, 0.6), box.height},
                        {toe, 0.2 * box.height},
                        {0, 0.2 * box.height}};
  }
  rock["joint_sets"] = std::move(sets);
  if (kind == RockKind::grains)
    rock["fill"] = {{{"voronoi", {{"size", unit * random.number(0.8, 1.5)}}}, {"joint", "grain"}}};
  if (kind == RockKind::tunnel || kind == RockKind::excavated) rock["openings"] = {opening(random, box, unit)};
  if (kind == RockKind::tunnel) rock["openings"][0]["left_out"] = true;
  rock["seed"] = random.integer(1, 1000000);
  return {{"rock", std::move(rock)}};
}

Json wall(const std::string& name, double left, double bottom, double right, double top) {
  return {{"polygon",
           {{"name", name},
            {"group", "walls"},
            {"vertices", {{left, bottom}, {right, bottom}, {right, top}, {left, top}}}}}};
}

void add_walls(const Box& box, double unit, RockKind kind, Json& scene) {
  scene["blocks"].push_back(wall("bottom", -unit, -unit, box.width + unit, 0));
  if (kind != RockKind::slope) scene["blocks"].push_back(wall("left", -unit, 0, 0, box.height));
  scene["blocks"].push_back(wall("right", box.width, 0, box.width + unit, box.height));
}

// Held walls, or for shaken rock walls that go to and fro from the end of settling on.
void hold_walls(SeededNumbers& random, RockKind kind, double motion, Json& scene) {
  if (kind != RockKind::shaken) {
    scene["fixed"] = {"walls"};
    return;
  }
  scene["supports"] = {{{"block", "walls"},
                        {"acceleration", {random.number(1, 5), random.number(-2, 2)}},
                        {"history", {{"sine", {{"frequency", 2 / motion}, {"cycles", 2}}}}}}};
}

// What a family adds is drawn apart from the rest, which is that of the seed without it.
SeededNumbers numbers_apart(std::uint64_t seed, std::uint64_t family) { return SeededNumbers(seed ^ (family << 32)); }

// No steeper than friction allows.
void let_ride_up(std::uint64_t seed, double unit, Json& joint) {
  SeededNumbers random = numbers_apart(seed, 0x646c);
  joint["dilation_angle"] = degrees(random.number(5, 15));
  if (seed / all_rock_kinds.size() % 2 == 0) joint["zero_dilation_slip"] = unit * random.magnitude(-3.5, -2);
}

// A joint gives way as a tenth to ten units of rock do, and in shear up to ten times as much.
void let_give_way(std::uint64_t seed, double unit, Json& scene) {
  SeededNumbers random = numbers_apart(seed, 0x6b6e);
  const double rock = scene["materials"]["rock"]["young"].get<double>() / unit;
  for (const char* name : {"default", "dry"}) {
    const double normal = rock * random.magnitude(-1, 1);
    scene["joints"][name]["normal_stiffness"] = normal;
    scene["joints"][name]["shear_stiffness"] = normal * random.magnitude(-1, 0);
  }
}

}  // namespace

std::string name_of(RockKind kind) {
  switch (kind) {
    case RockKind::two_sets: return "two sets";
    case RockKind::three_sets: return "three sets";
    case RockKind::traces: return "traces";
    case RockKind::grains: return "grains";
    case RockKind::tunnel: return "tunnel";
    case RockKind::excavated: return "excavated";
    case RockKind::slope: return "slope";
    case RockKind::shaken: return "shaken";
  }
  return "";
}

RockKind rock_kind(std::uint64_t seed) { return all_rock_kinds.at(seed % all_rock_kinds.size()); }

RandomRock random_rock(std::uint64_t seed, const RockFamily& family) {
  const RockJoints joints = family.joints;
  SeededNumbers random(seed);
  RandomRock made;
  made.seed = seed;
  made.kind = rock_kind(seed);
  made.unit = random.chance(0.5) ? 1 : random.magnitude(-2, 2);
  made.motion = 0.1 * std::sqrt(made.unit);
  const double extent = family.extent * (joints == RockJoints::dilating ? 0.6 * made.unit : made.unit);
  const Box box{extent * random.number(8, 18), extent * random.number(8, 14)};
  Json scene = {{"dda", 1}, {"title", fmt::format("Random rock, {}, seed {}", name_of(made.kind), seed)}};
  scene["materials"]["rock"] = {{"density", random.number(2000, 3000)},
                                {"young", made.unit * random.magnitude(9, 10.7)},
                                {"poisson", random.number(0, 0.35)}};
  scene["joints"]["default"] = {{"friction_angle", "30 deg"}};
  scene["joints"]["dry"] = {{"friction_angle", degrees(random.number(15, 45))}};
  if (joints == RockJoints::dilating) let_ride_up(seed, made.unit, scene["joints"]["dry"]);
  if (made.kind == RockKind::grains)
    scene["joints"]["grain"] = {{"friction_angle", "35 deg"},
                                {"cohesion", made.unit * random.magnitude(4, 6)},
                                {"tensile_strength", made.unit * random.magnitude(4, 5)}};
  if (joints == RockJoints::springs)
    for (const char* name : {"default", "dry"}) scene["joints"][name]["law"] = "classical";
  if (joints == RockJoints::compliant) let_give_way(seed, made.unit, scene);
  scene["blocks"] = {rock(random, made.kind, box, made.unit)};
  add_walls(box, made.unit, made.kind, scene);
  hold_walls(random, made.kind, made.motion, scene);
  scene["gravity"] = gravity;
  scene["steps"] = {{{"name", "settle"}, {"integrator", "static"}}};
  if (made.kind == RockKind::excavated)
    scene["steps"].push_back({{"name", "motion"}, {"remove", {"tunnel"}}, {"duration", made.motion}});
  else
    scene["steps"].push_back({{"name", "motion"}, {"duration", made.motion}});
  made.scene = scene.dump(1) + "\n";
  return made;
}

}  // namespace verify
