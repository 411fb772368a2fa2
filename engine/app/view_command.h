// `dda view`: a run with frames in, a page or a picture out.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace dda {

struct ViewOptions {
  std::filesystem::path folder;
  std::filesystem::path file;  // empty: view.html in the folder
  std::string quantity = "mean_stress";
  double most_megabytes = 50;  // of the page

  std::string svg_frame;  // number of a frame, or "last"; empty: the page
  std::string forces = "joints";
  bool crosses = false;
  double deformation_scale = 1;
  std::vector<double> window;  // left, bottom, right, top, m; empty: all blocks
};

// InputError where the folder of a run is a file, with what it is and which command reads it.
void expect_folder(const std::filesystem::path& folder);

// Says on `out` what was written. InputError for what is wrong with options or run; std::runtime_error when the file
// cannot be written.
void view_run(const ViewOptions& options, std::ostream& out);

}  // namespace dda
