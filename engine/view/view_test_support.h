// What the tests of this folder share: a small run on disk, written by the writers that dda run uses.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "engine/contact/contact_points.h"
#include "engine/core/temporary_folder.h"
#include "engine/model/model.h"
#include "engine/model/state.h"
#include "engine/record/atomic_file.h"
#include "engine/record/bolt_frame_writer.h"
#include "engine/record/contact_frame_writer.h"
#include "engine/record/frame_writer.h"
#include "engine/record/lining_frame_writer.h"

namespace dda {

inline Ring square_ring(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

// A square of 1 m2, a U (concave, seen whole from none of its vertices) and a square frame (with a hole).
inline Model model_to_view() {
  Model model;
  model.materials = {{"rock", 2600, 1e9, 0.25, PlaneState::stress}};
  model.joints.resize(1);
  model.blocks.resize(3);
  model.blocks[0].name = "square";
  model.blocks[1].name = "U";
  model.blocks[2].name = "frame";
  model.blocks[0].shape.outer = square_ring(0, 0, 1);
  model.blocks[1].shape.outer = {{2, 0}, {5, 0}, {5, 2}, {4, 2}, {4, 1}, {3, 1}, {3, 2}, {2, 2}};
  model.blocks[2].shape = {square_ring(6, 0, 3), {square_ring(7, 1, 1)}};
  model.bolts.resize(2);
  model.bolts[0].name = "tie";
  model.bolts[0].links = {{0, 1, Vec2(0.5, 0.5), Vec2(2.5, 0.5), 1e6, 0}};
  model.bolts[1].name = "<grouted>";
  model.bolts[1].grouted = true;
  model.bolts[1].links = {{1, 2, Vec2(5, 0.5), Vec2(6, 0.5), 1e6, 0, 0.75, 0.5}};
  model.stages.resize(1);
  model.stages[0].dt = model.stages[0].duration = 1;
  finish_model(model);
  return model;
}

// Block i has moved by (i + 1) * time * (0.1, -0.2) m, at that velocity, under (i + 1) * time * (-3, -1, 1.5) MPa.
inline State state_at(const Model& model, double time) {
  State state = initial_state(model);
  state.time = time;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const double k = static_cast<double>(i + 1);
    state.displacement[i].head<2>() << 0.1 * k * time, -0.2 * k * time;
    state.velocity[i].head<2>() << 0.1 * k, -0.2 * k;
    state.stress[i] << -3e6 * k * time, -1e6 * k * time, 1.5e6 * k * time;
  }
  return state;
}

// Block 0 touched by block 1 (locked, compressed) and block 2 (sliding); an open one without force.
inline std::vector<ContactPoint> contacts_at(const Model& model, const State& state) {
  std::vector<ContactPoint> contacts(3);
  const auto set = [&](std::size_t i, int a, int b, const Vec2& reference, const Vec2& normal, double force,
                       ContactStatus status) {
    contacts[i].block_a = a;
    contacts[i].block_b = b;
    contacts[i].reference = reference;
    contacts[i].point = current_position(model, state, b, reference);
    contacts[i].normal = normal;
    contacts[i].normal_force = force;
    contacts[i].status = status;
  };
  set(0, 0, 1, Vec2(2, 0.5), Vec2(1, 0), -4000 * state.time, ContactStatus::locked);
  set(1, 0, 2, Vec2(6, 3), Vec2(1, 0), -1000 * state.time, ContactStatus::sliding);
  set(2, 1, 2, Vec2(6, 0), Vec2(1, 0), 0, ContactStatus::open);
  return contacts;
}

// Frames of the model at these times, with contacts.
inline void write_run(const std::filesystem::path& folder, const Model& model, const std::vector<double>& times) {
  FrameWriter frames(model, folder / "frames.pvd");
  ContactFrameWriter contacts(folder / "contacts.pvd");
  for (const double time : times) {
    const State state = state_at(model, time);
    contacts.write(time, contacts_at(model, state));
    frames.write(state);
  }
}

// Its bolts: the tie pulls with 2 kN times the time, the other one pushes with 1 kN and breaks at 1 s.
inline void write_bolts(const std::filesystem::path& folder, const Model& model, const std::vector<double>& times) {
  BoltFrameWriter bolts(model, folder / "bolts.pvd");
  for (const double time : times) {
    const BoltLinkValues pushed{Vec2(-1000, 0), -1e-3, BoltCondition::yielded};
    const BoltLinkValues broken{Vec2(0, 0), 1e-3, BoltCondition::broken};
    bolts.write(state_at(model, time), std::vector<BoltLinkValues>{{Vec2(2000 * time, 0), 0, BoltCondition::elastic},
                                                                   time < 1 ? pushed : broken});
  }
}

template <typename Error, typename Action>
std::string message_of(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace dda
