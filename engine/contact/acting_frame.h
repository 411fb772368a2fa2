// The frame in which a vertex contact's forces act.
#pragma once

#include "engine/contact/interface.h"
#include "engine/contact/interface_element.h"
#include "engine/contact/interface_frame.h"
#include "engine/contact/outlines.h"
#include "engine/contact/vertex_contact.h"
#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

// With the blocks as they are in `acting`; `outlines` are as they were when the contact was found. Both blocks feel the
// contact at the vertex, so its forces have no moment between them. Of two corners above each other, on faces that lie
// on each other, either may be the vertex: nothing but their numbers says which, so the frame is the mean of both.
InterfaceFrame acting_frame(const Model& model, const State& acting, const Outlines& outlines,
                            const VertexContact& contact);

}  // namespace dda
