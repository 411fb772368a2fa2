// Saving a run so that it can go on later, to the last bit as if it had not stopped.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <span>
#include <vector>

#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

struct Checkpoint {
  State state;
  std::vector<std::byte> extra;  // what others keep from step to step, e.g. contact states; theirs to understand
};

// Writes `state` and the parts of `extra` whole or not at all: on an error (std::runtime_error naming path and reason)
// an earlier checkpoint of that name stays. Every double keeps its bits.
void save_checkpoint(const std::filesystem::path& path, const Model& model, const State& state,
                     std::initializer_list<std::span<const std::byte>> extra = {});

// Reads it back. Throws InputError naming the file for one that is missing, not a checkpoint, of another version or
// byte order, cut off, damaged, or of another scene.
Checkpoint load_checkpoint(const std::filesystem::path& path, const Model& model);

// A hash of what gives a state its meaning: outlines, materials, joints, bolts and held blocks, not their names, and
// the samples of recordings. Other loads, supports, stages and measurements are left out, so that a run may go on under
// other loads.
std::uint64_t fingerprint(const Model& model);

}  // namespace dda
