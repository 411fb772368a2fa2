#include "verification/cases/all_cases.h"

#include <array>

#include "verification/cases/absorbing_end_cases.h"
#include "verification/cases/advised_wave_cases.h"
#include "verification/cases/arch_cases.h"
#include "verification/cases/bar_ends_cases.h"
#include "verification/cases/base_shaking_cases.h"
#include "verification/cases/blast_cases.h"
#include "verification/cases/bolt_cases.h"
#include "verification/cases/bounce_cases.h"
#include "verification/cases/cantilever_cases.h"
#include "verification/cases/chatter_cases.h"
#include "verification/cases/collision_cases.h"
#include "verification/cases/contact_oscillator_cases.h"
#include "verification/cases/direction_cases.h"
#include "verification/cases/energy_cases.h"
#include "verification/cases/excavation_cases.h"
#include "verification/cases/free_field_cases.h"
#include "verification/cases/free_field_scene_cases.h"
#include "verification/cases/incline_chart_cases.h"
#include "verification/cases/incompressible_cases.h"
#include "verification/cases/joint_strength_cases.h"
#include "verification/cases/joint_wave_cases.h"
#include "verification/cases/lame_mode_cases.h"
#include "verification/cases/lining_cases.h"
#include "verification/cases/oblique_incidence_cases.h"
#include "verification/cases/opening_cases.h"
#include "verification/cases/p_bar_cases.h"
#include "verification/cases/projected_joint_cases.h"
#include "verification/cases/rigid_motion_cases.h"
#include "verification/cases/rocking_cases.h"
#include "verification/cases/roof_cases.h"
#include "verification/cases/shaken_block_cases.h"
#include "verification/cases/sliding_cases.h"
#include "verification/cases/slope_cases.h"
#include "verification/cases/soil_column_cases.h"
#include "verification/cases/spin_cases.h"
#include "verification/cases/static_stress_cases.h"
#include "verification/cases/statics_cases.h"
#include "verification/cases/stick_slip_cases.h"
#include "verification/cases/viscous_domain_cases.h"
#include "verification/cases/wall_cases.h"
#include "verification/cases/work_precision_cases.h"

namespace verify {
namespace {

// One function a subject, by catalogue number; its cases keep their order.
constexpr std::array subjects{
    rigid_motion_cases,        // 1-3
    spin_cases,                // 3
    contact_oscillator_cases,  // 4
    base_shaking_cases,        // 4, 11
    bounce_cases,              // 5
    collision_cases,           // 6, 7
    energy_cases,              // 8
    sliding_cases,             // 9, 12
    chatter_cases,             // 9
    shaken_block_cases,        // 10, 11
    stick_slip_cases,          // 13
    bolt_cases,                // 8, 9, 23
    rocking_cases,             // 14-16
    incline_chart_cases,       // 17
    slope_cases,               // 18, 19
    roof_cases,                // 20, 22
    arch_cases,                // 21
    joint_strength_cases,      // 23
    statics_cases,             // 24-26
    projected_joint_cases,     // 9, 16, 24, 42
    cantilever_cases,          // 27
    incompressible_cases,      // 27
    lame_mode_cases,           // 30
    p_bar_cases,               // 32
    work_precision_cases,      // 32
    joint_wave_cases,          // 33, 36-38
    bar_ends_cases,            // 34
    absorbing_end_cases,       // 34
    static_stress_cases,       // 34
    oblique_incidence_cases,   // 35
    viscous_domain_cases,      // 35
    soil_column_cases,         // 39
    free_field_cases,          // 39
    free_field_scene_cases,    // 39
    opening_cases,             // 28, 31
    excavation_cases,          // 28, 31, 41
    blast_cases,               // 29, 40, 41
    wall_cases,                // 8, 26
    direction_cases,           // 42
    advised_wave_cases,        // 42
    lining_cases,              // 43
};

std::vector<Case> collect() {
  std::vector<Case> cases;
  for (const auto subject : subjects)
    for (Case& each : subject()) cases.push_back(std::move(each));
  return cases;
}

}  // namespace

const std::vector<Case>& all_cases() {
  static const std::vector<Case> cases = collect();
  return cases;
}

}  // namespace verify
