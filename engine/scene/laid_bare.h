// The faces that an opening lays bare: those of other blocks that lie on blocks which are away.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/builder/ground_plan.h"
#include "engine/geometry/polygon.h"
#include "engine/model/model.h"
#include "engine/model/stage_span.h"
#include "engine/scene/field.h"

namespace dda {

// `name`: of blocks or of a group (`groups`: of each block). They must be away in all of `stages`, or are refused with
// what was `expected`; faces are those of blocks that are there in the first of them.
std::vector<Stretch> faces_laid_bare(const Field& name, const std::vector<std::string>& groups, const StageSpan& stages,
                                     const char* expected, const Model& model);

// Those that blocks which are there in `stage` have along the outline of an opening that was cut without blocks inside.
std::vector<Stretch> faces_around(const Ring& outline, std::size_t stage, const Model& model);

}  // namespace dda
