// `dda cut`: a scene with rock in, its blocks out.
#pragma once

#include <filesystem>
#include <iosfwd>

namespace dda {

// Writes scene.json (blocks and joints written out), cut.json (figures and what was cleaned) and cut.svg (a picture)
// into `folder`, which is made if need be, and says on `out` what was done. All is made before anything is written.
// Throws InputError for what is wrong with the scene.
void cut_into_folder(const std::filesystem::path& scene, const std::filesystem::path& folder, std::ostream& out);

}  // namespace dda
