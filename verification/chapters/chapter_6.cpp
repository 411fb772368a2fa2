#include "verification/chapters/chapter_6.h"

#include "verification/chapters/strain_relaxation.h"

namespace verify {
namespace {

Statement not_reached(const char* id, const char* statement, const char* thesis) {
  return {6,
          id,
          statement,
          std::string(thesis),
          std::string("not yet judged"),
          "",
          std::nullopt,
          "Not yet judged: the blast near a tunnel of section 6.2 is not run by this command so far."};
}

// Section 6.2.
std::vector<Statement> blast_near_a_tunnel() {
  return {
      not_reached("6.2-collapse", "The roof collapses only without friction", "only at 0 deg"),
      not_reached("6.2-stress", "The response to the blast is stronger without initial stress", "0 above 50 MPa"),
      not_reached("6.2-distance", "Point 6, nearer to the blast, responds more than point 5", "point 6 above point 5"),
      not_reached("6.2-friction", "Peak velocity of key block 1 falls with growing friction", "falls"),
      not_reached("6.2-wall", "Without initial stress point 1 has the largest peak velocity", "at every friction"),
      not_reached("6.2-roof", "At 50 MPa point 2 has the largest peak velocity", "for most angles of friction")};
}

}  // namespace

Chapter chapter_6(const SceneFolder& folder, bool quick) {
  Chapter chapter;
  chapter.number = 6;
  chapter.title = "Chapter 6: rockbursts";
  judge_relaxation(
      run_relaxation(folder, quick ? quick_relaxation_readings() : relaxation_readings(), chapter.failures), chapter);
  for (Statement& statement : blast_near_a_tunnel()) chapter.statements.push_back(std::move(statement));
  return chapter;
}

}  // namespace verify
