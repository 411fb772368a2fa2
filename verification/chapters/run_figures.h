// Figures of chapters 5 and 6 drawn from their runs: histories of points, and the mesh as it has moved with its
// principal stresses.
#pragma once

#include <vector>

#include "verification/chapters/jinping.h"
#include "verification/chapters/scene_runs.h"
#include "verification/chapters/strain_relaxation.h"
#include "verification/chapters/tunnel_blast.h"

namespace verify {

// Draws for each reading that is given the sensors, and the points at the edges beside those of the larger rock.
void draw_jinping(const SceneFolder& folder, const std::vector<JinpingReading>& readings, Chapter& chapter);

// Both draw the first reading of each section, whose other readings are variations of it. Runs that failed have no
// figure.
void draw_relaxation(const SceneFolder& folder, const std::vector<RelaxationResult>& results, Chapter& chapter);
void draw_tunnel_blast(const SceneFolder& folder, const std::vector<TunnelBlastResult>& results, Chapter& chapter);

}  // namespace verify
