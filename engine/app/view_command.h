// `dda view`: a run with frames in, a page or a picture out; a scene or a drawing in, a picture out.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "engine/app/drawing_words.h"

namespace dda {

struct ViewOptions {
  std::filesystem::path folder;  // of a run; or a scene file, or a drawing
  std::filesystem::path file;    // empty: view.html in the folder, or NAME.view.svg beside the scene
  std::string quantity = "mean_stress";
  double most_megabytes = 50;  // of the page

  std::string svg_frame;  // number of a frame, or "last"; empty: the page
  std::string forces = "joints";
  bool crosses = false;
  double deformation_scale = 1;
  std::vector<double> window;  // left, bottom, right, top, m; empty: all blocks

  DrawingOptions drawing;
  std::vector<std::string> given;  // names of the options on the command line
};

// InputError where the folder of a run is a file, with what it is and which command reads it.
void expect_folder(const std::filesystem::path& folder);

// Says on `out` what was written. InputError for what is wrong with options or run; std::runtime_error when the file
// cannot be written.
void view_run(const ViewOptions& options, std::ostream& out);

}  // namespace dda
