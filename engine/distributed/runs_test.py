#!/usr/bin/env python3
"""Runs scenes with the solver "petsc" in one, two and three processes: results are those of the other solvers, and runs end.

runs_test.py DDA EXAMPLES MPIRUN...     MPIRUN: with its options, but for -n
"""

import csv
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

# Differences of the columns of histories.csv from a run with complete factors, over the largest number of the column. A
# solution is off by 1e-12 (pcg_solver.h), and a thousand steps add that up to 1e-9 at most where nothing is judged. Joints
# that are judged hand a difference on from pass to pass: there the solver "pcg" is off by up to 2e-9 itself.
BONDED, JUDGED = 1e-9, 1e-7
LONGEST = 300  # s; runs take one, and a hundred times that on a busy machine, but who waits in vain never ends

EXAMPLES = {  # scene: tolerance, processes (0: without mpirun), and what is different in the last stage
    "absorbed_pulse": (BONDED, (1, 2), {"integrator": {"generalized_alpha": 0.85}, "duration": "4 ms"}),
    "tunnel_bonded_voronoi": (JUDGED, (1, 2), {"duration": "10 ms"}),
    "tunnel_two_sets": (JUDGED, (1, 2), {}),
    "masonry_wall": (JUDGED, (1, 2), {}),
    "dry_wall": (JUDGED, (0, 1, 2, 3), {}),
}


def problem(name, text):
    raise AssertionError(f"{name}: {text}")


class Bench:
    """Where scenes are written and run."""

    def __init__(self, dda, examples, mpirun, folder):
        self.dda, self.examples = str(Path(dda).resolve()), Path(examples)
        self.mpirun, self.folder = mpirun, Path(folder)

    def write(self, name, solver, **changes):
        scene = json.loads((self.examples / f"{name}.json").read_text())
        stages = scene["steps"] if isinstance(scene["steps"], list) else [scene["steps"]]
        for stage in stages:
            stage["solver"] = solver
        stages[-1].update(changes)
        path = self.folder / f"{name}-{solver}.json"
        path.write_text(json.dumps(scene))
        return path

    def command(self, processes, *words):
        start = self.mpirun + ["-n", str(processes)] if processes > 0 else []
        return [*start, self.dda, *map(str, words)]

    def call(self, processes, *words, **environment):
        return subprocess.run(self.command(processes, *words), capture_output=True, text=True, timeout=LONGEST,
                              env={**os.environ, **environment}, cwd=self.folder)

    def run(self, processes, scene, *options, **environment):
        out = self.folder / f"{scene.stem}-{processes}"
        done = self.call(processes, "run", scene, "--out", out, "--threads", 1, "--quiet", *options, **environment)
        if done.returncode != 0:
            problem(scene.name, f"exit code {done.returncode} in {processes} processes: {done.stderr}")
        return out


def rows_of(out):
    with open(out / "histories.csv") as file:
        return [[float(number) for number in row] for row in list(csv.reader(file))[1:]]


def difference(expected, found):
    if len(expected) != len(found):
        return float("inf")
    largest = [max(map(abs, column)) or 1 for column in zip(*expected)]
    return max(abs(a - b) / most for one, other in zip(expected, found) for a, b, most in zip(one, other, largest))


def results_are_the_same(bench):
    for name, (tolerance, numbers, changes) in EXAMPLES.items():
        expected = rows_of(bench.run(0, bench.write(name, "cholesky", **changes)))
        scene = bench.write(name, "petsc", **changes)
        for processes in numbers:
            off = difference(expected, rows_of(bench.run(processes, scene)))
            print(f"{name}, {processes} processes: off by {off:.1e}", flush=True)
            if not off <= tolerance:
                problem(name, f"off by {off:.1e} in {processes} processes, expected {tolerance:.0e} at most")


def options_of_petsc_change_nothing(bench):
    scene = bench.write("dry_wall", "petsc")
    expected = rows_of(bench.run(2, scene))
    (bench.folder / ".petscrc").write_text("-ksp_max_it 1\n")
    found = rows_of(bench.run(2, scene, PETSC_OPTIONS="-ksp_rtol 0.1 -ksp_max_it 2 -ksp_type gmres"))
    (bench.folder / ".petscrc").unlink()
    if found != expected:
        problem("PETSC_OPTIONS", "other results")


def mistakes_end_all(bench):
    scene = bench.write("dry_wall", "petsc", dt="-1 ms")
    done = bench.call(2, "run", scene, "--out", bench.folder / "none")
    if done.returncode != 2 or "steps[1].dt is \"-1 ms\"" not in done.stderr:
        problem("bad scene", f"exit code {done.returncode}: {done.stderr}")
    if (bench.folder / "none").exists():
        problem("bad scene", "left a folder")
    if bench.call(2, "run", bench.write("dry_wall", "petsc"), "--out", "/proc/none").returncode != 2:
        problem("folder that cannot be made", "not exit code 2")


def idle_processes_are_named(bench):
    done = bench.call(2, "run", bench.write("dry_wall", "pcg"), "--out", bench.folder / "idle")
    if done.returncode != 0 or "remark: of 2 processes one does all the work" not in done.stdout:
        problem("idle processes", f"exit code {done.returncode}: {done.stdout}{done.stderr}")


def wait_until(what, is_so):
    end = time.monotonic() + LONGEST
    while not is_so():
        if time.monotonic() > end:
            problem(what, "did not come")
        time.sleep(0.02)


def begin(bench, scene, out, *options):
    """A run of two processes that has taken some steps."""
    words = ["run", scene, "--out", out, "--threads", 1, "--quiet", "--checkpoint-interval", "50ms", *options]
    process = subprocess.Popen(bench.command(2, *words), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    wait_until("first steps", lambda: process.poll() is not None or (out / "checkpoint.bin").exists())
    time.sleep(0.1)
    return process


def children(process):
    """Of one, however far down."""
    below = {}
    for status in Path("/proc").glob("[0-9]*/stat"):
        try:
            words = status.read_text().rpartition(")")[2].split()
            below.setdefault(int(words[1]), []).append(int(status.parent.name))
        except OSError:
            pass
    found, stack = [], [process]
    while stack:
        own = below.get(stack.pop(), [])
        found += own
        stack += own
    return found


def is_alive(process):
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def stopped_runs_go_on(bench):
    scene = bench.write("masonry_wall", "petsc", duration="3 s")
    whole = rows_of(bench.run(2, scene))
    for number in (signal.SIGINT, signal.SIGTERM):
        out = bench.folder / f"stopped-{number}"
        process = begin(bench, scene, out)
        process.send_signal(number)
        process.communicate(timeout=LONGEST)
        if process.returncode == 0:
            problem("stopped run", "came to its end first")
        done = bench.call(2, "run", scene, "--out", out, "--threads", 1, "--quiet", "--checkpoint-interval", "50ms",
                          "--resume")
        if done.returncode != 0 or rows_of(out) != whole:
            problem("resumed run", f"exit code {done.returncode}, other rows or {done.stderr}")


def whoever_dies_ends_all(bench):
    scene = bench.write("masonry_wall", "petsc", duration="3 s")
    for which in range(2):
        process = begin(bench, scene, bench.folder / f"killed-{which}")
        ranks = [each for each in children(process.pid) if "dda" in Path(f"/proc/{each}/comm").read_text()]
        if len(ranks) != 2:
            problem("processes", f"are {len(ranks)}, expected 2")
        os.kill(ranks[which], signal.SIGKILL)
        process.communicate(timeout=LONGEST)
        if process.returncode == 0:
            problem("killed process", "is not known from the exit code")
        wait_until("end of all processes", lambda: not any(map(is_alive, ranks)))


def main():
    dda, examples, *mpirun = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(dda, examples, mpirun, folder)
        for test in (results_are_the_same, options_of_petsc_change_nothing, mistakes_end_all, idle_processes_are_named,
                     stopped_runs_go_on, whoever_dies_ends_all):
            test(bench)
            print(f"{test.__name__}: ok", flush=True)


if __name__ == "__main__":
    main()
