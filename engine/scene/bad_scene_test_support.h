// For tests of bad scenes: a good scene to spoil and what the sentence of an error must have.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/scene/scene.h"

namespace dda {

inline constexpr const char* good_text = R"({
  "dda": 1,
  "materials": {"rock": {"density": 2650, "young": "50 GPa", "poisson": 0.25}},
  "joints": {"default": {"bonded": true}},
  "blocks": [{"bar": {"length": 4, "height": 1, "block_length": 2}}],
  "loads": [{"point": [0, 0.5], "force": [1e3, 0], "history": {"sine": {"frequency": "100 Hz"}}}],
  "supports": [{"edge": "right"}],
  "viscous_boundaries": [{"edge": "left"}],
  "measurements": [{"quantity": "stress_xx", "point": [2, 0.5]}],
  "steps": {"dt": "1e-4 s", "duration": 0.01}
})";

// The good scene with the first occurrence of `from` replaced.
struct Spoiled {
  std::string what;
  std::string from;
  std::string to;
  std::vector<std::string> sentence;  // what it must contain besides the file
};

inline void PrintTo(const Spoiled& spoiled, std::ostream* out) { *out << spoiled.what; }

inline std::string spoiled_text(const Spoiled& spoiled) {
  std::string text = good_text;
  const std::size_t at = text.find(spoiled.from);
  EXPECT_NE(at, std::string::npos) << spoiled.from;
  return text.replace(at, spoiled.from.size(), spoiled.to);
}

inline void expect_sentence(const std::string& sentence, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(sentence.find(part), std::string::npos) << "no \"" << part << "\" in: " << sentence;
  }
  EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
  EXPECT_LT(sentence.size(), 500U) << sentence;
}

// What is said of a scene; empty where it is taken.
inline std::string refusal(const std::string& scene) {
  try {
    parse_scene(scene, "lot.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// Each test program part has its own table of spoiled scenes.
inline void expect_refusal(const Spoiled& spoiled) {
  try {
    parse_scene(spoiled_text(spoiled), "bad.json");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    expect_sentence(error.what(), {"bad.json: ", " is ", ", expected "});
    expect_sentence(error.what(), spoiled.sentence);
  }
}

}  // namespace dda
