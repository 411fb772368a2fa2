// `dda cut`: a scene with rock or a drawing in, its blocks out.
#pragma once

#include <filesystem>
#include <iosfwd>
#include "engine/app/drawing_words.h"

namespace dda {

struct CutRequest {
  std::filesystem::path scene;  // or a drawing
  std::filesystem::path folder;
  std::filesystem::path exported;  // a drawing of the blocks; empty: none
  DrawingOptions drawing;
  int threads = 0;  // that share the work; 0: one a core
};

// Writes scene.json (blocks and joints written out), cut.json (figures and what was cleaned) and cut.svg (a picture)
// into the folder, which is made if need be, and says on `out` what was done. All is made before anything is written.
// Throws InputError for what is wrong with the scene or drawing, and for a folder to which a run writes.
void cut_into_folder(const CutRequest& request, std::ostream& out);

}  // namespace dda
