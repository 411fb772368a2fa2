#!/usr/bin/env python3
"""Every option and every name of a file of every command of a program refuses an empty value.

Usage: option_values_test.py PROGRAM. Commands and options are those that PROGRAM --help lists, so that a new one is tried as soon
as it is there. Each is given an empty value, a blank one, none behind "=", and the next option in place of a value; the
program must answer with one sentence that names the option, exit code 2, and no file.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

# "  --out DIR REQUIRED      folder ...": a word after one blank is a kind of value; flags have none.
OPTION = re.compile(r"^  (?:-\w,)?(--[a-z][\w-]*) (?=\S)(?!Needs:|Excludes:)")
POSITIONAL = re.compile(r"^  ([a-z]\w*) (?=\S)")


def run(program, *arguments, folder=None):
    return subprocess.run([program, *arguments], capture_output=True, text=True, cwd=folder, timeout=60)


def section(text, title):
    """The lines below a title of the help."""
    found = re.search(rf"^{title}:\n((?:.+\n?)*)", text, re.MULTILINE)
    return found.group(1).splitlines() if found else []


def commands_of(program):
    text = run(program, "--help").stdout
    names = [re.match(r"^  ([a-z][\w-]*)", line) for line in section(text, "Subcommands")]
    return [[name.group(1)] for name in names if name] or [[]]


def named(lines, pattern):
    return [found.group(1) for found in map(pattern.match, lines) if found]


def cases(program):
    """Arguments, and what the sentence must have in it."""
    for command in commands_of(program):
        text = run(program, *command, "--help").stdout
        for option in named(section(text, "Options"), OPTION):
            for value in ("", " ", "\t"):
                yield [*command, option, value], f"{option}: is empty, expected a value"
            yield [*command, option + "="], f"{option}: is empty, expected a value"
            yield [*command, option, "--quiet"], f'{option}: is "--quiet", which looks like an option'
        for number, name in enumerate(named(section(text, "Positionals"), POSITIONAL)):
            yield [*command, *["x"] * number, ""], f"{name}: is empty, expected a value"


def complaint(program, arguments, sentence):
    with tempfile.TemporaryDirectory() as folder:
        result = run(program, *arguments, folder=folder)
        left = [path.name for path in Path(folder).iterdir()]
    if result.returncode != 2:
        return f"exit code {result.returncode}: {result.stderr}"
    if result.stderr.count("\n") != 1 or sentence not in result.stderr:
        return f"said {result.stderr!r}, expected {sentence!r}"
    if left or result.stdout:
        return f"left {left} and said {result.stdout!r}"
    return None


def main():
    program = str(Path(sys.argv[1]).resolve())
    tried = list(cases(program))
    wrong = [(arguments, why) for arguments, sentence in tried if (why := complaint(program, arguments, sentence))]
    for arguments, why in wrong:
        print(f"{arguments}: {why}")
    print(f"{len(tried)} command lines, {len(wrong)} wrong")
    return 1 if wrong or not tried else 0


if __name__ == "__main__":
    sys.exit(main())
