#!/usr/bin/env python3
"""Runs every command of a page, in order, in one folder, and compares what it prints with what the page shows.

Usage: tutorial_test.py PROGRAM PAGE EXAMPLES. In blocks of code, a line that begins with "dda " is a command and the lines below
it are what it prints; a line "..." stands for any lines, a page that shows nothing asks for nothing, and seconds may differ. A
block that begins with "{" is a scene, which the text before it names: "... `name.json`:". An image is the file that the text
before it names, "`name.svg`". A table that begins with "| `summary.json` | | `FOLDER` | ..." has figures that the summary.json of these
folders must have: place ("peaks.ejected.blocks", a number of it names an entry of a list), what it is, a value for each folder. Files and
folders of EXAMPLES lie in the folder.
"""

import json
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path


def steps_of(page):
    """("file", name, text) and ("command", line, lines shown) in the order of the page."""
    for found in re.finditer(r"(?P<before>[^\n]*)\n\n?```\w*\n(?P<code>.*?)```", page, re.DOTALL):
        code = found["code"]
        if code.startswith("{"):
            yield "file", re.findall(r"`([\w.]+\.json)`", found["before"])[-1], code
            continue
        shown = None
        for line in code.splitlines():
            if line.startswith("dda "):
                shown = []
                yield "command", line, shown
            elif shown is not None:
                shown.append(line)


def images_of(page):
    """The file that a command writes, and the image of the page that must be the same."""
    return re.findall(r"`([\w./]+\.svg)`[^\n]*\n\n!\[[^\]]*\]\(([^)]+)\)", page)


# Units that a page may show in place of those of the files.
UNITS = {"kJ/m": 1e3, "t/m": 1e3}


def cells_of(row):
    return [cell.strip(" `") for cell in row.strip().strip("|").split("|")]


def figures_of(page):
    """(folder, place, value shown, its unit) of every figure in the tables of figures."""
    for table in re.findall(r"^\| `summary\.json` \|.*\n\|[-| ]+\n(?:\|.*\n)+", page, re.MULTILINE):
        head, _, *rows = [cells_of(row) for row in table.splitlines()]
        for place, _, *shown in rows:
            for folder, cell in zip(head[2:], shown, strict=True):
                value, _, unit = cell.partition(" ")
                yield folder, place, value, unit


def value_at(place, content):
    for key in place.split("."):
        content = content[int(key) if isinstance(content, list) else key]
    return content


def is_as_shown(value, shown, unit):
    """Whether a value is the one shown, to one unit of the last digit shown beside rounding: other compilers round otherwise."""
    digits = len(shown.partition(".")[2])
    return abs(value / UNITS.get(unit, 1) - float(shown)) < 1.5 * 10.0**-digits


def wrong_figures(page, folder):
    figures = list(figures_of(page))
    if "`summary.json` |" in page and not figures:
        yield "no figure is read from the tables of the page"
    for run_folder, place, shown, unit in figures:
        value = value_at(place, json.loads((Path(folder) / run_folder / "summary.json").read_text()))
        if not is_as_shown(value, shown, unit):
            yield f"{place} of {run_folder} is {value}, but the page has {shown} {unit}"


def matches(shown, printed):
    """Whether the lines shown, with their gaps, are those printed."""
    parts = [r"(?:.*\n)*" if line == "..." else re.escape(line) + "\n" for line in shown]
    pattern = re.sub(r"in\\ [\d.e\\-]+\\ s\b", r"in [0-9.e-]+ s", "".join(parts))
    return re.fullmatch(pattern, printed) is not None


def run(program, line, folder):
    words = shlex.split(line)
    result = subprocess.run([program, *words[1:]], cwd=folder, capture_output=True, text=True, timeout=300)
    return result.returncode, result.stdout + result.stderr


def problem_with(program, line, shown, folder):
    code, printed = run(program, line, folder)
    refused = bool(shown) and shown[0].startswith("dda: ")
    if code != (2 if refused else 0):
        return f"exit code {code}:\n{printed}"
    if shown and not matches(shown, printed):
        return "printed\n" + printed + "but the page has\n" + "\n".join(shown)
    return None


def main():
    program, page, examples = (str(Path(argument).resolve()) for argument in sys.argv[1:])
    text = Path(page).read_text()
    tried = 0
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(examples, folder, dirs_exist_ok=True)
        # A generator's list of lines is whole only when the next step is asked for.
        for kind, name, content in list(steps_of(text)):
            if kind == "file":
                (Path(folder) / name).write_text(content)
                continue
            tried += 1
            if why := problem_with(program, name, content, folder):
                print(f"{name}\n{why}")
                return 1
        for made, image in images_of(text):
            if (Path(folder) / made).read_bytes() != (Path(page).parent / image).read_bytes():
                print(f"{image} is not what {made} came out as")
                return 1
        if wrong := list(wrong_figures(text, folder)):
            print("\n".join(wrong))
            return 1
    print(f"{tried} commands do what the page says")
    return 0 if tried else 1


if __name__ == "__main__":
    sys.exit(main())
