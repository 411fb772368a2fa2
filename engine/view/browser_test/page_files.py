"""Checks of the page: the block that is clicked at, the files that are saved, and forces that are everywhere."""

import csv
import json
import pathlib
import tempfile
import time

from chromium import pixels
from page_support import FRAMES, FRAME_BLOCK, colour_at, make_run, on_screen
from vtp_frame import VtpFrame, near


def saved_file(folder, suffix):
    """The one file that a click has left in the folder, once it is all there."""
    deadline = time.monotonic() + 20
    while time.monotonic() < deadline:
        found = [path for path in folder.iterdir() if path.suffix == suffix]
        if found:
            return found[0]
        time.sleep(0.05)
    raise AssertionError(f"no file *{suffix}")


def rows_of(path):
    return list(csv.reader(path.read_text().splitlines()))


def check_chosen_block(page, work):
    """A click at a block shows what it did in all frames, and gives it as a file; a click beside it ends that."""
    page.evaluate(f"dda.player.go({FRAMES})")
    shown = lambda: page.evaluate("!document.getElementById('chosen').hidden")
    place = on_screen(page, 5, 0.3)
    page.drag(place, (place[0] + 40, place[1]))
    assert not shown(), "a drag is no click"
    page.press("0")
    page.drag(place, place)
    assert shown() and page.evaluate("dda.chosen.block") == FRAME_BLOCK
    assert page.evaluate("document.getElementById('chosen-title').textContent") == "frame"
    units = page.evaluate("dda.chosen.panels.map(panel => panel.columns[0].unit)")
    assert sorted(units) == ["Pa", "m", "m/s"], units
    with tempfile.TemporaryDirectory() as folder:
        page.save_into(folder)
        page.evaluate("document.getElementById('chosen-csv').click()")
        saved = saved_file(pathlib.Path(folder), ".csv")
        assert saved.name == "frame.csv"
        head, *rows = rows_of(saved)
    assert head[0] == "time [s]" and len(rows) == FRAMES + 1
    column = next(i for i, name in enumerate(head) if name.startswith("Vertical stress") or "\u03c3yy" in name)
    for frame, row in enumerate(rows):
        disk = VtpFrame(f"{work}/frames/{frame:06}.vtp")
        stresses = [disk.stress_yy(block) for block in range(page.evaluate("dda.run.blocks"))]
        near(float(row[column]), stresses[FRAME_BLOCK], (max(stresses) - min(stresses)) / 65534, f"frame {frame} of the file")
    page.drag(on_screen(page, 5, 1), on_screen(page, 5, 1))  # in the hole of the block
    assert not shown()


def check_files(page, work):
    with tempfile.TemporaryDirectory() as folder:
        page.save_into(folder)
        page.evaluate("document.getElementById('measured-csv').click()")
        saved = rows_of(saved_file(pathlib.Path(folder), ".csv"))
        written = rows_of(pathlib.Path(work, "histories.csv"))
        assert saved[0] == written[0], saved[0]
        assert [[float(value) for value in row] for row in saved[1:]] == [[float(value) for value in row] for row in written[1:]]
        page.press("p")
        width, height, rows = pixels(saved_file(pathlib.Path(folder), ".png").read_bytes())
    canvas = page.evaluate("[dda.stage.canvas.width, dda.stage.canvas.height]")
    assert width > canvas[0] and height > canvas[1], (width, height, canvas)
    # Where the block lies the picture has its colour, below the title.
    ratio = canvas[0] / page.evaluate("dda.stage.camera.width")
    x, y = page.evaluate("(() => { const [x0, y0] = dda.run.header.origin; return dda.stage.camera.toScreen(4.25 - x0, 0.7 - y0); })()")
    found = colour_at((width, height, rows), ratio * x, ratio * y + height - canvas[1])
    colour = page.evaluate(f"dda.stage.colourOf({FRAME_BLOCK})")
    assert found == tuple(int(colour[i:i + 2], 16) for i in (1, 3, 5)), (found, colour)


# Rock under stress, of which each joint carries the same.
STRESSED = {
    "dda": 1, "title": "Stressed", "materials": {"rock": {"density": 2500, "young": "10 GPa", "poisson": 0.2}},
    "joints": {"default": {"friction_angle": "30 deg"}},
    "blocks": {"grid": {"columns": 6, "rows": 6, "block_width": 1, "block_height": 1,
                        "initial_stress": {"xx": "-1 MPa", "yy": "-1 MPa"}}},
    "loads": [{"edge": "outside", "traction": "in-situ"}], "supports": [{"point": [0, 0]}, {"point": [6, 0], "hold": "y"}],
    "steps": {"dt": "0.1 ms", "duration": "1 ms"},
}


def check_stressed_rock(program, work, page):
    """Forces that are everywhere are not drawn over the colours until asked for."""
    folder = pathlib.Path(work, "stressed")
    folder.mkdir(exist_ok=True)
    scene = folder / "scene.json"
    scene.write_text(json.dumps(STRESSED))
    page.open(make_run(program, scene, folder))
    page.settle()
    assert page.evaluate("[dda.stage.show.forces, document.getElementById('forces').value]") == ["none", "none"]
    page.press("f")
    assert page.evaluate("dda.stage.show.forces") == "joints" and page.evaluate("dda.stage.lines.length") > 0
