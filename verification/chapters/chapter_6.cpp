#include "verification/chapters/chapter_6.h"

#include "verification/chapters/strain_relaxation.h"
#include "verification/chapters/tunnel_blast.h"

namespace verify {

Chapter chapter_6(const SceneFolder& folder, bool quick) {
  Chapter chapter;
  chapter.number = 6;
  chapter.title = "Chapter 6: rockbursts";
  judge_relaxation(
      run_relaxation(folder, quick ? quick_relaxation_readings() : relaxation_readings(), chapter.failures), chapter);
  judge_tunnel_blast(
      run_tunnel_blast(folder, quick ? std::vector<TunnelBlastReading>{} : tunnel_blast_readings(), chapter.failures),
      chapter);
  return chapter;
}

}  // namespace verify
