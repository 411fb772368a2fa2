#include "engine/app/stiffness_report.h"

#include <algorithm>
#include <cstddef>

#include "engine/advice/closed_joints.h"
#include "engine/contact/contact_set.h"
#include "engine/contact/make_contacts.h"
#include "engine/contact/projected_law.h"
#include "engine/model/moving_stages.h"

namespace dda {
namespace {

void add(const Model& model, const Interface& interface, std::optional<JointSurvey>& survey) {
  const double per_area = 2 * springs_of(model, interface).normal / interface.length;
  const StiffnessErrors errors = stiffness_errors(model, interface);
  if (!survey) survey = JointSurvey{per_area, per_area, errors};
  survey->softest = std::min(survey->softest, per_area);
  survey->stiffest = std::max(survey->stiffest, per_area);
  survey->worst.compliance = std::max(survey->worst.compliance, errors.compliance);
  survey->worst.penetration = std::max(survey->worst.penetration, errors.penetration);
}

}  // namespace

std::vector<std::optional<JointSurvey>> survey_joints(const Model& model) {
  std::vector<std::optional<JointSurvey>> joints(model.joints.size());
  const ContactSet drawn = make_contacts(model);
  const Kinematics kinematics = has_finite_kinematics(model) ? Kinematics::finite : Kinematics::small;
  for (std::size_t i = 0; i < drawn.interfaces.size(); ++i) {
    const Interface& interface = drawn.interfaces[i];
    const auto joint = static_cast<std::size_t>(interface.joint);
    const bool gives_way = drawn.elements.but_for_blocks(i).law == InterfaceLaw::classical ||
                           gives_way_closed(model.joints[joint], kinematics);
    if (gives_way && interface.length > 0) add(model, interface, joints[joint]);
  }
  return joints;
}

std::vector<std::optional<PenaltySurvey>> survey_penalties(const Model& model, const ContactSet& contacts) {
  std::vector<std::optional<PenaltySurvey>> joints(model.joints.size());
  for (std::size_t i = 0; i < contacts.interfaces.size(); ++i) {
    if (contacts.elements.but_for_blocks(i).law != InterfaceLaw::projected) continue;
    const Interface& interface = contacts.interfaces[i];
    const double per_area = 2 * contacts.elements.but_for_blocks(i).stiffness(0) / interface.length;
    std::optional<PenaltySurvey>& survey = joints[static_cast<std::size_t>(interface.joint)];
    for (const int block : {interface.block_a, interface.block_b}) {
      if (model.is_held(block)) continue;
      const double penalty = projected_penalty(model, block);
      if (!survey) survey = PenaltySurvey{penalty, penalty, per_area, per_area};
      survey->least = std::min(survey->least, penalty);
      survey->most = std::max(survey->most, penalty);
      survey->softest = std::min(survey->softest, per_area);
      survey->stiffest = std::max(survey->stiffest, per_area);
    }
  }
  return joints;
}

}  // namespace dda
