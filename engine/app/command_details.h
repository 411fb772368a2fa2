// What the help of the program's commands says below their options.
#pragma once

namespace dda {

inline constexpr auto program_details =
    "Examples:\n"
    "  dda check bar.json                    say what would be run, and how accurate it will be\n"
    "  dda advise bar.json                   why, at what cost, and how coarse it may be\n"
    "  dda cut tunnel.json --out blocks      cut its rock into blocks: a scene of polygons, figures, a picture\n"
    "  dda cut plan.dxf --out blocks         the same from a drawing\n"
    "  dda keyblocks slope.json              which blocks can come out, and what holds them\n"
    "  dda fos slope.json                    by how much its joints are stronger than they need be\n"
    "  dda reaction tunnel.json --opening tunnel    how far its wall comes in at which support pressure\n"
    "  dda run bar.json --out results        run it; histories, summary and checkpoint go to results/\n"
    "  dda view results                      a page that shows the run, when it has frames (--frames 100)\n"
    "  dda report results                    what came of it, on one page\n"
    "  dda spectrum results --measurement a  how oscillators would swing on ground that moves so\n"
    "  dda run --help                        more on a command\n\n"
    "Exit codes: 0 done, 1 a result could not be written, 2 bad input, 3 the run ended before its time,\n"
    "128 + signal the run was stopped (130 after Ctrl-C).\n";

inline constexpr auto check_details =
    "Prints blocks, contacts, what acts, sizes, the terms and phases of every stage with its solver, and the errors "
    "to\n"
    "expect of waves: in speed by interfaces, block size and time step, and in amplitude.\n\n"
    "Examples:\n"
    "  dda check bar.json\n"
    "  dda check bar.json --frequency 250Hz\n";

inline constexpr auto advise_details =
    "Predicts from closed forms, without running the scene, what blocks, interfaces and time steps will do to its "
    "load\n"
    "on the way, or to a steady wave of --frequency: errors of speed and amplitude by wave, direction and cause; "
    "solver\n"
    "and cost; the largest dt and blocks that keep the error of --error.\n\n"
    "Examples:\n"
    "  dda advise bar.json\n"
    "  dda advise bar.json --distance 50m --error 0.5%\n"
    "  dda advise wall.json --frequency 250Hz --json > advice.json\n";

inline constexpr auto run_details =
    "DIR gets histories.csv (the measurements), summary.json (status, counters, energy), checkpoint.bin (for "
    "--resume)\n"
    "and, when asked for, frames.pvd with frames/ for ParaView. What an earlier run left in DIR is taken "
    "away,\nother files are left alone; a DIR to which another run writes is refused.\n"
    "Ctrl-C stops after the current step.\n\n"
    "Examples:\n"
    "  dda run bar.json --out results\n"
    "  dda run wall.json --out results --frames 100                     then open results/frames.pvd in ParaView\n"
    "  dda run wall.json --out results --frame-interval 5ms --every 10\n"
    "  dda run wall.json --out results --frames 100 --resume            go on where this run stopped\n"
    "  dda run wall.json --out results --profile                        say where the time went\n"
    "  dda run quake.json --out shaken --from results:settle            other loads on the wall as it has settled\n";

inline constexpr auto view_details =
    "The page needs nothing but a browser: blocks, stresses, contact forces and measurements, played through time.\n"
    "With --svg, one frame becomes a picture for a document. A scene, or a drawing that dda cut reads, is drawn "
    "before\n"
    "anything moves: blocks by group and material, joints, what is taken out, holds, loads and supports. Nothing is "
    "run.\n\n"
    "Quantities: mean_stress, stress_1, stress_2 (principal, the first the larger), max_shear, stress_xx, stress_yy,\n"
    "stress_xy, speed, displacement.\n\n"
    "Examples:\n"
    "  dda run arch.json --out results --frames 200 && dda view results     then open results/view.html\n"
    "  dda view arch.json                                                   then open arch.view.svg\n"
    "  dda view results --svg last --out arch.svg --quantity stress_2\n"
    "  dda view results --svg 40 --out arch.svg --forces contacts --window -6,-1,6,6\n";

inline constexpr auto report_details =
    "One page that needs nothing but a browser: status, the scene in short, energies over time with their residual, "
    "all\n"
    "measurements as plots, the last frame, warnings and remarks, counters and times. Of a run that has ended; frames\n"
    "(dda run --frames) give it its picture.\n\n"
    "Example:\n"
    "  dda run tunnel.json --out results --frames 40 && dda report results     then open results/report.html\n";

inline constexpr auto cut_details =
    "DIR gets scene.json, with all blocks and joints of the rock written out, which runs as the given scene does;\n"
    "cut.json, with figures and all that was cleaned; and cut.svg, a picture. check, run and view cut by themselves.\n"
    "A drawing has its lines on layers boundary, rock, tunnel, ... (docs/drawings.md); its scene.json has assumptions "
    "for\n"
    "what no drawing says.\n\n"
    "Examples:\n"
    "  dda cut tunnel.json --out blocks                                 then open blocks/cut.svg\n"
    "  dda cut plan.dxf --out blocks --export blocks.dxf\n"
    "  dda cut arch.dxf --out blocks --layer \"bed joints=rock\" --layer notes=ignored\n"
    "  dda cut slope.blck --out blocks --run-data slope.df              what dc made and df read of the original DDA\n";

inline constexpr auto schema_details =
    "Name the file in \"$schema\" of a scene, and editors complete keys and underline mistakes.\n\n"
    "Example:\n"
    "  dda schema > scene.schema.json\n";

}  // namespace dda
