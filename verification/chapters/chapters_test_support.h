// What the tests of this folder share.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "engine/core/temporary_folder.h"
#include "engine/record/atomic_file.h"
#include "verification/chapters/scene_runs.h"
#include "verification/chapters/statement.h"

namespace verify {

inline std::optional<bool> verdict(const Chapter& chapter, const std::string& id) {
  for (const Statement& statement : chapter.statements)
    if (statement.id == id) return statement.confirmed;
  ADD_FAILURE() << "no statement " << id;
  return std::nullopt;
}

// A run that left these rows in histories.csv.
inline SceneRun run_that_left(const std::string& histories) {
  const dda::TemporaryFolder folder;
  dda::write_file(folder / "histories.csv", histories);
  SceneRun run;
  run.histories = dda::read_histories(folder / "histories.csv");
  return run;
}

}  // namespace verify
