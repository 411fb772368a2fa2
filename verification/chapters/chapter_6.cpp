#include "verification/chapters/chapter_6.h"

#include <vector>

#include "verification/chapters/run_figures.h"

namespace verify {

Chapter chapter_6(const SceneFolder& folder, bool quick) {
  Chapter chapter;
  chapter.number = 6;
  chapter.title = "Chapter 6: rockbursts";
  const std::vector<RelaxationResult> relaxation =
      run_relaxation(folder, quick ? quick_relaxation_readings() : relaxation_readings(), chapter.failures);
  judge_relaxation(relaxation, chapter);
  draw_relaxation(folder, relaxation, chapter);
  const std::vector<TunnelBlastResult> blasts =
      run_tunnel_blast(folder, quick ? std::vector<TunnelBlastReading>{} : tunnel_blast_readings(), chapter.failures);
  judge_tunnel_blast(blasts, chapter);
  draw_tunnel_blast(folder, blasts, chapter);
  return chapter;
}

}  // namespace verify
