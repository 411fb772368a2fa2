// One frame of a run as a picture (SVG), for documents.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "engine/view/run_results.h"

namespace dda {

enum class DrawnForces { none, contacts, joints };

struct Window {
  double left = 0, bottom = 0, right = 0, top = 0;  // m
};

struct PictureOptions {
  std::string quantity = "mean_stress";
  std::string title;
  double deformation_scale = 1;  // of all motion
  DrawnForces forces = DrawnForces::joints;
  bool crosses = false;          // of principal stresses
  std::optional<Window> window;  // none: all blocks
  double width = 960;            // px, of the picture
};

// The text of the picture. Colours are scaled to the values of this frame, lines to its forces.
std::string svg_picture(const Drawing& drawing, const Frame& frame, const PictureOptions& options);

}  // namespace dda
