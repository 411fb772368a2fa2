// The law of joints for which a scene names none.
//
// A dry joint whose blocks move and turn has springs where nothing else is said of it: these lock blocks whose strains
// differ, and let waves through at a wrong speed. A joint with strength that has one of the other laws breaks at up to
// three times the moment that beams break at, and becomes springs (ADR 35). So where the scene leaves both the law and
// the springs open, joints that can slide or break get the projected law where the scene can have it. A stiffness per
// area is no choice of springs: it is what the joint gives way by beside its blocks, which that law has in series with
// them.
#pragma once

#include "engine/builder/scheme.h"
#include "engine/model/model.h"
#include "engine/scene/field.h"

namespace dda {

// Needs the stages, and what they change of the rock.
void choose_laws(const Field& scene, const Scheme& scheme, Model& model);

}  // namespace dda
