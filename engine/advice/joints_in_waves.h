// Whether joints stay closed and stuck while a wave passes, as is assumed of all that is foretold.
#pragma once

#include <cstddef>
#include <string>

#include "engine/advice/load_history.h"
#include "engine/advice/plane_wave.h"
#include "engine/contact/contact_set.h"
#include "engine/model/model.h"

namespace dda {

struct WaveStress {
  WaveKind kind = WaveKind::bar;
  Vec2 direction = Vec2::UnitX();  // unit, of the way
  double least = 0, most = 0;  // Pa, that the wave has: of P and bar waves along the way, tension positive; of S shear
  Vec2 from = Vec2::Zero();    // m, where it sets out
  double distance = 0;         // m, as far as joints are asked
  double frequency = 0;        // Hz, its main one
};

// Pa, that a wave of P (of a bar) or S has along its way at the load's value 1 as it sets out.
double unit_of_load(const Model& model, const SceneLoad& load, WaveKind kind, const Vec2& direction, bool row);

struct WaveWay {
  WaveKind kind = WaveKind::bar;
  Vec2 direction = Vec2::UnitX();  // unit
  double unit = 0;                 // Pa, as above
};

// The stress of the load and of what comes of it, as far as joints can send it back in time to be seen: it goes as far
// as `run` (m) while it is looked at.
WaveStress stress_of(const SceneLoad& load, const HistoryErrors& history, const WaveWay& wave, double run);

// A clause for people that names a joint which gives way, or whose dashpots take from the wave; empty where none does.
// In a stage of unlimited strength dry joints still open. Joints begin with the stress of their
// blocks. Weight and constant loads that static stages bring in before may press them: where there are any, the
// largest pressure that they could bring is taken for granted.
std::string why_joints_give_way(const Model& model, std::size_t stage, const ContactSet& drawn, const WaveStress& wave);

}  // namespace dda
