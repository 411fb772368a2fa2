#include "engine/app/wave_survey.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/contact/cubic_law.h"
#include "engine/contact/mesh_correction.h"

namespace dda {
namespace {

enum class Kind { bar, p, s };

const char* name_of(Kind kind) {
  switch (kind) {
    case Kind::bar: return "bar";
    case Kind::p: return "P";
    case Kind::s: return "S";
  }
  return "";
}

double speed_of(Kind kind, const Material& material) {
  switch (kind) {
    case Kind::bar: return std::sqrt(side_free_modulus(material) / material.density);
    case Kind::p: return p_wave_speed(material);
    case Kind::s: return s_wave_speed(material);
  }
  return 0;
}

// One interface as a wave in one of its blocks meets it.
struct Crossing {
  const Interface& interface;
  const InterfaceElement& element;
  double block_size;  // m, of the block across the interface
};

// All stretches where blocks of a material touch something, seen from each such block.
std::vector<Crossing> crossings(const Model& model, const ContactSet& contacts, int material) {
  std::vector<Crossing> found;
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    const Interface& interface = contacts.interfaces[i];
    if (interface.length == 0) continue;
    const Vec2 middle = (interface.from + interface.to) / 2;
    for (const int index : {interface.block_a, interface.block_b}) {
      const Block& block = model.blocks[static_cast<std::size_t>(index)];
      if (block.material != material) continue;
      const double depth = std::abs((middle - block.moments.centroid).dot(interface.normal));
      found.push_back({interface, contacts.elements[i], 2 * depth});
    }
  }
  return found;
}

// True when the blocks follow each other in one direction, with at most two neighbours each.
bool is_straight_row(const Model& model, const ContactSet& contacts) {
  std::vector<int> neighbours(model.blocks.size(), 0);
  for (const Interface& interface : contacts.interfaces) {
    for (const int block : {interface.block_a, interface.block_b}) {
      if (++neighbours[static_cast<std::size_t>(block)] > 2) return false;
    }
    if (std::abs(interface.normal.dot(contacts.interfaces.front().normal)) < 1 - 1e-9) return false;
  }
  return true;
}

double compliance(const Crossing& crossing, Kind kind, double modulus) {
  if (crossing.element.law != InterfaceLaw::classical) return 0;
  const Vec4& springs = crossing.element.stiffness;
  const double stiffness = kind == Kind::s ? springs(1) + springs(3) : springs(0) + springs(2);
  return modulus * crossing.interface.length / (stiffness * crossing.block_size);
}

double lateral_coupling(const Crossing& crossing, const Material& material) {
  if (crossing.element.law != InterfaceLaw::classical) return 0;
  const double ratio = side_free_ratio(material);
  return ratio * ratio * crossing.element.stiffness(1) * crossing.interface.length /
         (crossing.block_size * side_free_modulus(material));
}

// Strains (n, t, nt) of a wave along the normal.
Vec3 strains_of(Kind kind, const Material& material) {
  if (kind == Kind::s) return {0, 0, 1};
  return {1, kind == Kind::bar ? -side_free_ratio(material) : 0, 0};
}

// What corrections do where all joints are consistent.
void set_corrections(const Material& material, const JointMaterial& joint, const Stage& stage, Kind kind,
                     BlockWave& wave) {
  const Vec3 strains = strains_of(kind, material);
  const Mat3 elasticity = elasticity_matrix(material);
  const double modulus = material.density * wave.speed * wave.speed;
  if (stage.correct_block_dispersion) wave.softened = jump_share(material, joint.stabilisation, strains);
  wave.shear = elasticity(2, 2) / modulus;
  wave.strain = 1 - wave.shear;                                                     // 0 for S waves
  wave.most_strain = mesh::most_strain_correction / (kind == Kind::bar ? 12 : 24);  // e_nn alone; dilatation of squares
}

bool all_consistent(const std::vector<Crossing>& crossings) {
  return std::all_of(crossings.begin(), crossings.end(),
                     [](const Crossing& crossing) { return crossing.element.law == InterfaceLaw::consistent; });
}

BlockWave worst_wave(const Material& material, const std::vector<Crossing>& crossings, Kind kind) {
  BlockWave wave;
  wave.speed = speed_of(kind, material);
  wave.cubic = true;
  const double modulus = material.density * wave.speed * wave.speed;
  for (const Crossing& crossing : crossings) {
    wave.block_size = std::max(wave.block_size, crossing.block_size);
    wave.compliance = std::max(wave.compliance, compliance(crossing, kind, modulus));
    if (kind == Kind::bar)
      wave.lateral_coupling = std::max(wave.lateral_coupling, lateral_coupling(crossing, material));
    wave.cubic = wave.cubic && crossing.element.law == InterfaceLaw::cubic;
  }
  return wave;
}

}  // namespace

std::vector<SurveyedWave> survey_waves(const Model& model, const ContactSet& contacts, const Stage& asked,
                                       double frequency) {
  const Stage stage = model.with_acting_corrections(asked);
  std::vector<SurveyedWave> waves;
  if (stage.integrator.is_static || contacts.interfaces.empty()) return waves;
  const std::vector<Kind> kinds =
      is_straight_row(model, contacts) ? std::vector{Kind::bar} : std::vector{Kind::p, Kind::s};
  for (int material = 0; material < static_cast<int>(model.materials.size()); ++material) {
    const std::vector<Crossing> found = crossings(model, contacts, material);
    if (found.empty()) continue;
    for (const Kind kind : kinds) {
      BlockWave wave = worst_wave(model.materials[static_cast<std::size_t>(material)], found, kind);
      wave.frequency = frequency;
      wave.strain_inertia = stage.strain_inertia;
      wave.integrator = stage.integrator;
      wave.dt = stage.dt;
      wave.time_corrected = stage.correct_time_dispersion;
      if (all_consistent(found)) {
        const auto joint = static_cast<std::size_t>(found.front().interface.joint);
        set_corrections(model.materials[static_cast<std::size_t>(material)], model.joints[joint], stage, kind, wave);
      }
      waves.push_back({material, name_of(kind), wave});
    }
  }
  return waves;
}

}  // namespace dda
