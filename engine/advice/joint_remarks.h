// What is legal but odd in the strength and stiffness of joints.
#pragma once

#include <string>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/model/model.h"

namespace dda {

// One sentence, without a full stop, for each oddity of each joint that blocks touch along:
// - it loses all of its cohesion where it fails;
// - its tensile strength is beyond the apex of Coulomb's law, cohesion / tan(friction angle): a joint that is pulled
//   harder than that has no shear strength left, and the least shear breaks it before it is torn apart;
// - its springs resist no shear.
std::vector<std::string> joint_remarks(const Model& model, const ContactSet& contacts);

}  // namespace dda
