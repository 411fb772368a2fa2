#!/usr/bin/env python3
"""Kills runs of scenes at random moments and lets them go on: what is left must be, byte for byte, that of one run.

Every scene is run once as a whole. Then it is begun, killed (SIGKILL, sometimes SIGTERM) after a random part of that time,
gone on with by --resume, killed again, and so on; in the end it may finish, and all files are compared but those that hold
run times and counters. A run that was killed before its first checkpoint is begun anew, as its user would.
"""

import argparse
import json
import random
import signal
import subprocess
import sys
import tempfile
import time
from fnmatch import fnmatch
from pathlib import Path

# Run times; checkpoints and ends of stages, with counters of the factorizations that resuming needs.
NOT_COMPARED = ("summary.json", "*.bin")


def start(dda, scene, out, resume):
    command = [dda, "run", scene, "--out", out, "--quiet", "--frames", "7", "--checkpoint-interval", "20ms"]
    return subprocess.Popen([str(word) for word in command + ["--resume"] * resume], stderr=subprocess.PIPE, text=True)


def finish(dda, scene, out, resume):
    process = start(dda, scene, out, resume)
    _, errors = process.communicate()
    if process.returncode != 0:
        raise RuntimeError(f"exit code {process.returncode}{' of a resumed run' * resume}: {errors.strip()}")


def can_resume(out):
    return (out / "checkpoint.bin").exists()


def kill_once(dda, scene, out, seconds, dice):
    """False when the run came to its end first."""
    process = start(dda, scene, out, can_resume(out))
    time.sleep(dice.uniform(0, seconds))
    process.send_signal(signal.SIGTERM if dice.random() < 0.2 else signal.SIGKILL)
    _, errors = process.communicate()
    if process.returncode not in (0, -signal.SIGKILL, -signal.SIGTERM, 128 + signal.SIGTERM):
        raise RuntimeError(f"exit code {process.returncode} of a run that was to be killed: {errors.strip()}")
    return process.returncode != 0


def files_in(folder):
    paths = {str(path.relative_to(folder)): path for path in folder.rglob("*") if path.is_file()}
    compared = {name: path for name, path in paths.items() if not any(fnmatch(name, each) for each in NOT_COMPARED)}
    return {name: path.read_bytes() for name, path in compared.items()}


def differences(whole, pieces):
    expected, found = files_in(whole), files_in(pieces)
    names = sorted(expected.keys() ^ found.keys())
    names += sorted(name for name in expected.keys() & found.keys() if expected[name] != found[name])
    energies = [json.loads((folder / "summary.json").read_text())["energy"] for folder in (whole, pieces)]
    return names + ["the energy in summary.json"] * (energies[0] != energies[1])


def try_scene(dda, scene, kills, dice, work):
    """The number of kills that met a running program, and what differs."""
    whole, pieces = work / "whole", work / "pieces"
    begin = time.monotonic()
    finish(dda, scene, whole, False)
    seconds = time.monotonic() - begin
    done = 0
    for _ in range(kills):
        done += kill_once(dda, scene, pieces, seconds / 2, dice)
    finish(dda, scene, pieces, can_resume(pieces))
    return done, differences(whole, pieces)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("dda", type=Path)
    parser.add_argument("scenes", type=Path, nargs="+", help="scene files, or folders of them")
    parser.add_argument("--kills", type=int, default=40, help="over all scenes")
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    scenes = [s for path in arguments.scenes for s in (sorted(path.glob("*.json")) if path.is_dir() else [path])]
    dice = random.Random(arguments.seed)
    each = -(-arguments.kills // len(scenes))
    total, failed = 0, 0
    for scene in scenes:
        with tempfile.TemporaryDirectory() as work:
            try:
                kills, differing = try_scene(arguments.dda, scene, each, dice, Path(work))
                total += kills
                fault = "differs: " + ", ".join(differing) if differing else ""
            except RuntimeError as error:
                kills, fault = 0, str(error)
        failed += bool(fault)
        print(f"{scene.stem}: {kills} kills, {fault or 'same bytes'}", flush=True)
    print(f"{total} kills in {len(scenes)} scenes, {failed} scenes failed")
    return 1 if failed or total < arguments.kills / 4 else 0


if __name__ == "__main__":
    sys.exit(main())
