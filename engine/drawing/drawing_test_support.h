// What the tests of this folder share.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/drawing/plan_of_drawing.h"

namespace dda {

inline std::string fixture(const std::string& name) { return (std::filesystem::path(DDA_DRAWINGS) / name).string(); }

inline std::string text_of_fixture(const std::string& name) { return read_file(fixture(name)); }

// What the layers of shapes.dxf mean.
inline DrawingOptions shapes_options() {
  DrawingOptions options;
  options.layers["umriss"].role = LayerRole::boundary;
  options.layers["Stollen"].role = LayerRole::tunnel;
  options.layers["FUGEN"] = {LayerRole::rock, "bedding", false};
  return options;
}

template <typename Action>
void expect_refused(Action action, const std::string& sentence) {
  try {
    action();
    ADD_FAILURE() << "taken, expected " << sentence;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(sentence), std::string::npos) << error.what() << "\nexpected\n"
                                                                           << sentence;
  }
}

}  // namespace dda
