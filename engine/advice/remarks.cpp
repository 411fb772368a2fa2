#include "engine/advice/remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <type_traits>
#include <variant>

#include "engine/advice/at_odds.h"
#include "engine/advice/block_named.h"
#include "engine/advice/bolt_remarks.h"
#include "engine/advice/changed_rock_remarks.h"
#include "engine/advice/coarse_blocks.h"
#include "engine/advice/fading_remarks.h"
#include "engine/advice/followed_wave.h"
#include "engine/advice/gap_remarks.h"
#include "engine/advice/held_blocks_acted_on.h"
#include "engine/advice/holding_remarks.h"
#include "engine/advice/idle_loads.h"
#include "engine/advice/joint_remarks.h"
#include "engine/advice/lining_remarks.h"
#include "engine/advice/magnitude_remarks.h"
#include "engine/advice/rebound_remarks.h"
#include "engine/advice/repeated_loads.h"
#include "engine/advice/shaking_remarks.h"
#include "engine/advice/spin_remarks.h"
#include "engine/advice/springs_around_openings.h"
#include "engine/advice/unseen_loads.h"
#include "engine/contact/joint_stiffness.h"
#include "engine/geometry/box.h"
#include "engine/model/held_motion.h"
#include "engine/model/step_choice.h"
#include "engine/simulation/step_coefficients.h"

namespace dda {
namespace {

using Remarks = std::vector<std::string>;
using Blocks = std::vector<int>;

// Bounds between what occurs and what is most likely a mistake.
constexpr double smallest_share = 1e-2;   // of the median size: such a block decides over dt and conditioning
constexpr double longest_fall = 0.1;      // of the smallest block, in one step; contact detection follows less
constexpr double spoilt_speed = 0.05;     // by time steps, of a wave that is as fast as the loads
constexpr double spoilt_amplitude = 0.2;  // the same, lost in a period
constexpr double most_damping_in_a_step = 0.02;
constexpr double most_crossings = 100;  // of the whole scene by a P wave in one step

std::size_t at(int index) { return static_cast<std::size_t>(index); }

// m2, of two digits, and above that of a block of this size, m.
double area_above(double size) { return 1.06 * size * size; }

void remark_on_sizes(const Model& model, const ContactSet& /*contacts*/, Remarks& remarks) {
  std::vector<double> sizes;
  for (const Block& block : model.blocks) sizes.push_back(block_size(block));
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  const double median = *middle;
  Blocks tiny = blocks_with(model, [&](const Block& block) { return block_size(block) < smallest_share * median; });
  if (tiny.empty()) return;
  const auto size_of = [&model](int block) { return block_size(model.blocks[at(block)]); };
  std::ranges::sort(tiny, {}, size_of);
  const double size = size_of(tiny[0]);
  remarks.push_back(fmt::format(
      "{} is {:.2g} m in size, {:.2g} of the middle block's: such slivers make steps dear, or fail; leave them out "
      "(where rock is cut, \"merge\": {{\"area\": {:.2g}}} adds them to neighbours)",
      blocks_named(model, tiny), size, size / median, area_above(size_of(tiny.back()))));
}

double extent_of(const Model& model) {
  Box box;
  for (const Block& block : model.blocks)
    for (const Vec2& vertex : block.shape.outer) box = expanded(box, vertex);
  return (box.upper - box.lower).norm();
}

void remark_on_steps(const Model& model, const ContactSet& /*contacts*/, Remarks& remarks) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Block& block : model.blocks) smallest = std::min(smallest, block_size(block));
  double fastest = 0;
  for (const Material& material : model.materials) fastest = std::max(fastest, p_wave_speed(material));
  for (const Stage& stage : model.stages) {
    if (stage.integrator.is_static) continue;
    const double fall = model.gravity.norm() * stage.dt * stage.dt / 2;
    const double crossings = fastest * stage.dt / extent_of(model);
    if (fall > longest_fall * smallest)
      remarks.push_back(
          fmt::format("stage \"{}\": in a step of {:g} s a block falls {:.2g} m, and the smallest is {:.2g} m",
                      stage.name, stage.dt, fall, smallest));
    else if (crossings > most_crossings)
      remarks.push_back(fmt::format("stage \"{}\": in a step of {:g} s a P wave crosses the scene {:.2g} times",
                                    stage.name, stage.dt, crossings));
  }
}

// `damping_rate` acts at the ends of steps alone: what a step has gained is then short by rate dt/2 of what steady
// forces would keep, and an initial velocity goes as far further.
void remark_on_damping_rate(const Model& model, const ContactSet& /*contacts*/, Remarks& remarks) {
  for (const Stage& stage : model.stages) {
    const double in_a_step = stage.damping_rate * stage.dt;
    if (stage.integrator.is_static || in_a_step <= most_damping_in_a_step) continue;
    remarks.push_back(
        fmt::format("stage \"{}\": damping_rate times dt is {:.2g}, and velocities miss about half of that as a share "
                    "of them; at a "
                    "dt of {:.2g} s it is 1 %",
                    stage.name, in_a_step, most_damping_in_a_step / stage.damping_rate));
  }
}

// Waves of the load's own frequency that the integrator itself spoils. Loads that steps pass over are unseen_loads'.
void remark_on_coarse_steps(const Model& model, const ContactSet& /*contacts*/, Remarks& remarks) {
  const auto keeps = [](const StepErrors& errors, double speed, double amplitude) {
    return std::abs(errors.speed) <= speed && std::abs(errors.amplitude) <= amplitude;
  };
  for (const Stage& stage : model.stages) {
    const std::optional<FastestWave> wave = followed_wave(model, stage);
    if (!wave || keeps(wave->errors, spoilt_speed, spoilt_amplitude)) continue;
    double dt = stage.dt;
    while (!keeps(fastest_wave(model, stage, dt)->errors, 0.01, 0.05)) dt /= 2;
    remarks.push_back(fmt::format(
        "stage \"{}\": loads change as fast as a wave of {:.3g} Hz does, whose speed steps of {:g} s alter by "
        "{:.0f} % and of whose amplitude they take {:.0f} % in a period; at a dt of {:.2g} s it is 1 and 5 % at most",
        stage.name, wave->frequency, stage.dt, 100 * wave->errors.speed,
        std::max(0.0, std::round(100 * wave->errors.amplitude)), dt));
  }
}

bool moves(const PointSupport& support) { return !support.amplitude.isZero(0); }

bool is_shaken(const Model& model) {
  const auto moving = [](const auto& held) { return moves(held); };
  const auto changing = [](const auto& load) { return !std::holds_alternative<Constant>(load.history); };
  return std::ranges::any_of(model.supports, moving) || std::ranges::any_of(model.held_blocks, moving) ||
         std::ranges::any_of(model.point_loads, changing) || std::ranges::any_of(model.edge_loads, changing);
}

// Friction follows the pressure on a contact and so couples the vibrations of the block on it. Where nothing damps them
// they grow while it slides, until it chatters (ADR 30).
void remark_on_chatter(const Model& model, const ContactSet& contacts, Remarks& remarks) {
  if (!is_shaken(model)) return;
  const auto rubs = [&](const Interface& interface) {
    const JointMaterial& joint = model.joints[at(interface.joint)];
    return !joint.bonded && joint.friction_angle > 0 && joint.contact_damping == 0;
  };
  const auto rubbing = std::ranges::find_if(contacts.interfaces, rubs);
  if (rubbing == contacts.interfaces.end()) return;
  for (const Stage& stage : model.stages) {
    if (stage.integrator.is_static || !with_contacts(stage.integrator).conserves_contact_energy) continue;
    remarks.push_back(fmt::format(
        "stage \"{}\": {} damps nothing, and joint \"{}\" has friction without contact_damping: blocks that are shaken "
        "chatter on it and may slide many times too far; take an integrator that damps, or a contact_damping of 0.2",
        stage.name, stage.integrator.name, model.joints[at(rubbing->joint)].name));
  }
}

// A joint of at least this friction down which its blocks slide under their weight; none where there is no such.
const JointMaterial* joint_of_slide(const Model& model, const ContactSet& contacts, double least_friction) {
  const auto slides = [&](const Interface& interface) {
    const JointMaterial& joint = model.joints[at(interface.joint)];
    const double friction = std::tan(joint.friction_angle);
    if (joint.bonded || joint.cohesion > 0 || friction < least_friction) return false;
    return std::abs(cross(model.gravity, interface.normal)) >
               friction * std::abs(model.gravity.dot(interface.normal)) &&
           std::abs(model.gravity.dot(interface.normal)) > 0.1 * model.gravity.norm();
  };
  const auto sliding = std::ranges::find_if(contacts.interfaces, slides);
  return sliding == contacts.interfaces.end() ? nullptr : &model.joints[at(sliding->joint)];
}

// The same of blocks that slide down a joint under their weight. Where nothing damps, none was found below a friction
// of 0.5, and a contact_damping of 0.2 to 1 lessens it: at the chosen dt cubes on 41 and 45 degrees went 6 to 74 % too
// far. Integrators that damp take more from vibrations the longer their steps are: of 150 blocks on 38 to 56 degrees 36
// went more than 1 % too far, and one of them 1.8 times as far as it should at the chosen dt, 1.01 times at 5 ms, 6
// times at 0.2 ms; of 240 on flatter slopes none did. In rock of many blocks no dt need be long enough: the crest of
// docs/examples/slope_persistent_set.json moves by 2e-6 m at 1 ms and 1.1 mm at 0.03 ms and below, the roof of
// tunnel_excavated.json by 3.2 mm at 0.2 ms and 3.6 mm at 0.05 ms; a contact_damping of 0.2 makes that 0.05 to 0.06 mm
// and 1.4 to 1.5 mm at all of 0.05 to 1 and 0.05 to 0.2 ms.
void remark_on_chatter_on_slopes(const Model& model, const ContactSet& contacts, Remarks& remarks) {
  constexpr double least_undamped = 0.5, least_damped = 0.78;
  const JointMaterial* undamped = joint_of_slide(model, contacts, least_undamped);
  const JointMaterial* damped = joint_of_slide(model, contacts, least_damped);
  for (const Stage& stage : model.stages) {
    if (stage.integrator.is_static) continue;
    if (with_contacts(stage.integrator).conserves_contact_energy && undamped != nullptr)
      remarks.push_back(fmt::format(
          "stage \"{}\": {} damps nothing, and blocks slide down along joint \"{}\": they may chatter and go many "
          "times too far, with contact_damping and at short steps too; take an integrator that damps",
          stage.name, stage.integrator.name, undamped->name));
    else if (!with_contacts(stage.integrator).conserves_contact_energy && damped != nullptr)
      remarks.push_back(fmt::format(
          "stage \"{}\": blocks slide down along joint \"{}\", whose friction is strong: their vibrations feed on it, "
          "and how far they go hangs on dt: short steps let them go too far, long ones hold back what moves; compare "
          "with a longer and a shorter dt than {:g} s; where they differ take a contact_damping of 0.2, or let go over "
          "a time",
          stage.name, damped->name, stage.dt));
  }
}

// What keeps no velocity takes the one that blocks begin with.
void remark_on_lost_motion(const Model& model, const ContactSet& /*contacts*/, Remarks& remarks) {
  const Blocks moving = blocks_with(model, [](const Block& block) { return !block.starts_at_rest(); });
  const Stage& stage = model.stages.front();
  if (moving.empty() || !stage.integrator.is_static) return;
  remarks.push_back(
      fmt::format("stage \"{}\" is the first and static, and static stages keep no velocity: the motion with which {} "
                  "should start is lost; blocks start with it where the first stage is not static",
                  stage.name, blocks_named(model, moving)));
}

// What a header of its own has to say, by the model alone or by its contacts as well.
template <auto sentences>
void remark(const Model& model, const ContactSet& contacts, Remarks& remarks) {
  Remarks said;
  if constexpr (std::is_invocable_v<decltype(sentences), const Model&>)
    said = sentences(model);
  else
    said = sentences(model, contacts);
  std::ranges::move(said, std::back_inserter(remarks));
}

constexpr auto all_remarks = {remark<holding_remarks>,
                              remark<magnitude_remarks>,
                              remark_on_sizes,
                              remark<gap_remarks>,
                              remark_on_steps,
                              remark_on_coarse_steps,
                              remark<coarse_blocks>,
                              remark<unseen_loads>,
                              remark<idle_loads>,
                              remark<repeated_loads>,
                              remark<joint_remarks>,
                              remark<rebound_remarks>,
                              remark_on_chatter,
                              remark_on_chatter_on_slopes,
                              remark<bolt_remarks>,
                              remark<lining_remarks>,
                              remark<acting_on_held_blocks>,
                              remark_on_damping_rate,
                              remark<springs_around_openings>,
                              remark<changed_rock_remarks>,
                              remark<fading_remarks>,
                              remark<spin_remarks>,
                              remark<shaking_remarks>,
                              remark_on_lost_motion,
                              remark<remarks_on_odds>};

}  // namespace

std::vector<std::string> remarks_on(const Model& model, const ContactSet& contacts) {
  Remarks remarks;
  for (const auto& add : all_remarks) add(model, contacts, remarks);
  return remarks;
}

}  // namespace dda
