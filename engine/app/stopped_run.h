// A run that was broken off, for the tests of this folder.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <string>

#include "engine/app/run_files.h"
#include "engine/app/run_request.h"
#include "engine/scene/scene.h"

namespace dda {

// What `dda run SCENE --out FOLDER --frame-interval INTERVAL` leaves when it is killed after some steps.
inline void leave_stopped_run(const std::string& scene, const std::string& folder, double frame_interval, int steps) {
  RunOptions options;
  options.frame_interval = frame_interval;
  std::filesystem::create_directory(folder);
  write_request(folder, run_request(options, scene_text(scene), 0));
  Simulation simulation(read_scene(scene));
  const Probes probes(simulation);
  RunFiles files(simulation, probes, {folder, 1, frame_interval}, std::nullopt);
  for (int i = 0; i < steps; ++i) {
    ASSERT_EQ(simulation.step(), Status::ok);
    files.after_step();
  }
  files.write_checkpoint();
}

}  // namespace dda
