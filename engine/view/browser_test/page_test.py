#!/usr/bin/env python3
"""Opens the page that `dda view` makes of a small run in headless Chromium and checks what it shows.

page_test.py DDA WORK: runs scene.json with the program DDA into the folder WORK, and compares the page with the frames.
Fails, and does not skip, where Chromium is missing.
"""

import json
import math
import pathlib
import sys

from chromium import Chromium, pixels
from page_files import check_chosen_block, check_files, check_stressed_rock
from page_support import FRAMES, FRAME_BLOCK, colour_at, make_run, on_screen
from vtp_frame import VtpFrame, near, outline_on_page

SMALLER = 0.5  # screenshots


def check_frame(page, work, frame, blocks):
    """Every block is where its frame says, and has the value of its frame, to half a step of 16 bits and a float."""
    disk = VtpFrame(f"{work}/frames/{frame:06}.vtp")
    page.evaluate(f"dda.player.go({frame})")
    page.settle()
    extent = max(abs(value) for value in disk.arrays["Points/Points"])
    moved = disk.arrays["PointData/displacement [m]"]
    step = (max(moved) - min(moved)) / 65534
    stresses = [disk.stress_yy(block) for block in range(blocks)]
    for block in range(blocks):
        found = outline_on_page(page, block)
        expected = disk.outline(block)
        assert len(found) == len(expected), f"block {block} has {len(found)} vertices"
        for point, wanted in zip(found, expected):
            for axis in (0, 1):
                near(point[axis], wanted[axis], step + extent * 2**-22, f"frame {frame}, block {block}")
        value = page.evaluate(f"dda.run.value(dda.run.quantityIndex('stress_yy'), {frame}, {block})")
        near(value, stresses[block], (max(stresses) - min(stresses)) / 65534, f"stress of block {block}")


def inside(outline):
    """A point 0.15 m inside the first edge; material lies on the left of every edge."""
    (ax, ay), (bx, by) = outline[:2]
    length = math.hypot(bx - ax, by - ay)
    return (ax + bx) / 2 - 0.15 * (by - ay) / length, (ay + by) / 2 + 0.15 * (bx - ax) / length


def expected_colour(page, value):
    """By the map of the page, but by a calculation of our own."""
    scale = page.evaluate("dda.run.quantities[dda.run.quantityIndex('stress_yy')].scale")
    share = min(max((value - scale["low"]) / (scale["high"] - scale["low"]), 0), 1)
    share = 1 - share if scale["dark_low"] and not scale["diverging"] else share
    name = "diverging" if scale["diverging"] else "sequential"
    colour = page.evaluate(f"dda.run.header.maps.{name}[{math.floor(255 * share + 0.5)}]")
    return tuple(int(colour[i:i + 2], 16) for i in (1, 3, 5))


def check_colours(page, work, frame, blocks):
    """What is on the screen inside each block is the colour of its stress, and in a hole nothing."""
    page.evaluate("document.getElementById('forces').value = 'none';"
                  "document.getElementById('forces').dispatchEvent(new Event('input'))")
    page.evaluate(f"dda.player.go({frame})")
    page.settle()
    image = pixels(page.screenshot(SMALLER))
    disk = VtpFrame(f"{work}/frames/{frame:06}.vtp")
    colours = set()
    for block in range(blocks):
        found = colour_at(image, *(SMALLER * place for place in on_screen(page, *inside(disk.outline(block)))))
        wanted = expected_colour(page, disk.stress_yy(block))
        # One step of the map, where rounding may fall on the other side.
        assert max(abs(a - b) for a, b in zip(found, wanted)) <= 3, f"block {block} is {found}, expected {wanted}"
        colours.add(found)
    assert len(colours) >= 5, f"only {len(colours)} colours: the stresses of the courses differ"
    in_the_hole = disk.outline(FRAME_BLOCK)[4:]
    middle = [sum(point[axis] for point in in_the_hole) / 4 for axis in (0, 1)]
    found = colour_at(image, *(SMALLER * place for place in on_screen(page, *middle)))
    assert found == (255, 255, 255), f"the hole is {found}"


def check_forces(page, work, frame):
    """Contacts, forces and status are those of the frame; forces are drawn in their colour."""
    page.evaluate(f"dda.player.go({frame})")
    contacts = page.evaluate("dda.stage.contacts")
    disk = VtpFrame(f"{work}/contacts/{frame:06}.vtp").arrays
    statuses = disk["PointData/status"]
    assert len(contacts) == len(statuses) > 10
    for number, name in enumerate(("locked", "sliding", "open")):
        assert sum(contact["status"] == name for contact in contacts) == statuses.count(number) > 0, name
    force = disk["PointData/force [N/m]"]
    for axis, name in ((0, "fx"), (1, "fy")):
        near(sum(contact[name] for contact in contacts), sum(force[axis::3]),
             len(contacts) * max(map(abs, force)) / 32767 / 2, f"sum of {name}")
    places = sorted((force[3 * i + 1], disk["Points/Points"][3 * i]) for i in range(len(statuses)))
    largest = max(contacts, key=lambda contact: contact["fy"])
    tied = [x for fy, x in places if fy >= places[-1][0] * (1 - 1e-3)]
    x = largest["x"] + page.evaluate("dda.run.header.origin[0]")
    assert min(abs(x - other) for other in tied) < 1e-3, "the largest force is elsewhere"

    def red_pixels():
        page.settle()
        _, _, rows = pixels(page.screenshot(SMALLER))
        return sum(row[i] > 180 and row[i + 1] < 60 and row[i + 2] < 90 for row in rows for i in range(0, len(row), 3))

    assert red_pixels() < 10
    page.press("f")  # none -> joints
    joints = red_pixels()
    assert joints > 60, f"{joints} pixels of forces"
    assert page.evaluate("dda.stage.show.forces") == "joints"
    assert page.evaluate("dda.stage.lines.length") > 10
    assert "kN/m" in page.evaluate("document.getElementById('keys').textContent")


CONDITIONS = ("elastic", "yielded", "broken")
BOLT_COLOURS = {"elastic": (0, 122, 61), "yielded": (240, 138, 0)}


def check_bolts(page, work):
    """Bolts lie where their frame says, with its force and condition; drawn in its colour, and named under the pointer."""
    seen = set()
    for frame in range(FRAMES + 1):
        disk = VtpFrame(f"{work}/bolts/{frame:06}.vtp")
        page.evaluate(f"dda.player.go({frame})")
        page.settle()
        bolts = page.evaluate("dda.stage.bolts")
        assert [bolt["name"] for bolt in bolts] == ["pin"] * 4 + ["tie"], bolts
        forces = disk.arrays["CellData/axial_force [N]"]
        points = disk.arrays["Points/Points"]
        moved = disk.arrays["PointData/displacement [m]"]
        step = (max(moved) - min(moved)) / 65534 + max(map(abs, points)) * 2**-22
        origin = page.evaluate("dda.run.header.origin")
        for i, (bolt, cell) in enumerate(zip(bolts, disk.cells("Lines"))):
            near(bolt["force"], forces[i], (max(forces) - min(forces)) / 65534, f"force of {bolt['name']}")
            assert bolt["condition"] == CONDITIONS[disk.arrays["CellData/status"][i]]
            seen.add(bolt["condition"])
            assert len(bolt["path"]) == 2 * len(cell)
            for j, point in enumerate(cell):
                for axis in (0, 1):
                    near(bolt["path"][2 * j + axis] + origin[axis], points[3 * point + axis], step, "place of a bolt")
        if frame in (0, 3, FRAMES):
            image = pixels(page.screenshot())
            # In the air between frame and stone, and in the wall above a joint.
            check_bolt_on_screen(page, image, bolts[4], 0.5)
            check_bolt_on_screen(page, image, bolts[2], 0.25)
    assert seen == set(CONDITIONS), seen
    page.evaluate(f"dda.player.go({FRAMES})")
    page.settle()
    keys = "document.getElementById('keys').textContent"
    for text in ("Axial force", "kN", "broken"):
        assert text in page.evaluate(keys), text
    page.press("b")
    assert page.evaluate("dda.stage.bolts.length") == 0
    assert "Bolt" not in page.evaluate(keys)
    page.press("b")
    assert page.evaluate("dda.stage.bolts.length") == 5


def check_bolt_on_screen(page, image, bolt, share):
    """At a share of the first piece of the bolt's line."""
    path = bolt["path"]
    origin = page.evaluate("dda.run.header.origin")
    x, y = on_screen(page, *(origin[axis] + path[axis] + share * (path[2 + axis] - path[axis]) for axis in (0, 1)))
    colour = colour_at(image, x, y)
    if bolt["condition"] in BOLT_COLOURS:
        wanted = BOLT_COLOURS[bolt["condition"]]
        # Blended with the halo at the border of a thin line.
        assert max(abs(a - b) for a, b in zip(colour, wanted)) < 90, f"{bolt['name']} is {colour}, expected {wanted}"
    page.move(x, y)
    text = page.evaluate("document.getElementById('readout').textContent")
    assert text.startswith(f"{bolt['name']}: axial force ") and text.endswith(bolt["condition"]), text


def check_controls(page):
    state = lambda: page.evaluate("[dda.player.frame, dda.player.playing, dda.stage.show.quantity]")
    page.press("Home")
    assert state()[0] == 0
    page.press("ArrowRight")
    assert state()[0] == 1
    page.press("End")
    assert state()[0] == FRAMES
    page.press("q")
    assert state()[2] == page.evaluate("dda.run.quantityIndex('stress_yy')") + 1
    assert "\u03c3xy" in page.evaluate("document.getElementById('bar-title').textContent")
    page.press("Q")
    page.evaluate("document.getElementById('speed').value = 60;"
                  "document.getElementById('speed').dispatchEvent(new Event('input'))")
    page.press(" ")
    assert state()[1] or state()[0] == FRAMES
    page.evaluate("new Promise(done => { const wait = () => dda.player.playing ? setTimeout(wait, 20) : done(); wait(); })")
    assert state()[:2] == [FRAMES, False], "play stops at the last frame"
    page.evaluate("document.getElementById('slider').value = 3;"
                  "document.getElementById('slider').dispatchEvent(new Event('input'))")
    assert state()[0] == 3
    for key, box in (("x", "crosses"), ("c", "status"), ("o", "outlines")):
        before = page.evaluate(f"dda.stage.show.{box}")
        page.press(key)
        assert page.evaluate(f"dda.stage.show.{box}") != before, key
        page.press(key)

    scale = page.evaluate("dda.stage.camera.scale")
    page.press("+")
    near(page.evaluate("dda.stage.camera.scale"), 1.25 * scale, 1e-9 * scale, "zoom")
    before = on_screen(page, 5, 0.3)
    page.drag(before, (before[0] + 40, before[1] + 25))
    after = on_screen(page, 5, 0.3)
    near(after[0] - before[0], 40, 0.01, "drag")
    near(after[1] - before[1], 25, 0.01, "drag")
    page.press("0")
    near(page.evaluate("dda.stage.camera.scale"), scale, 1e-9 * scale, "fit")
    page.move(*on_screen(page, 5, 0.3))
    assert page.evaluate("document.getElementById('readout').textContent").startswith("frame: stress")
    page.move(*on_screen(page, 5, 1))  # in the hole of block 1
    assert page.evaluate("document.getElementById('readout').textContent") == ""


def check_deformation_scale(page, work):
    disk = VtpFrame(f"{work}/frames/{FRAMES:06}.vtp")
    moved = disk.arrays["PointData/displacement [m]"]
    page.evaluate(f"dda.player.go({FRAMES}); document.getElementById('deformation').value = 3;"
                  "document.getElementById('deformation').dispatchEvent(new Event('input'))")
    assert page.evaluate("dda.stage.show.deformationScale") == 1000
    points = page.evaluate("Array.from(dda.stage.points)")
    reference = page.evaluate("Array.from(dda.run.reference)")
    farthest = max(range(len(points)), key=lambda i: abs(points[i] - reference[i]))
    largest = max(abs(value) for value in moved)
    near(abs(points[farthest] - reference[farthest]), 1000 * largest, 1000 * largest / 65534 + 1e-5, "deformation x 1000")


def check_summary(page, work):
    summary = json.loads(pathlib.Path(work, "summary.json").read_text())
    assert page.evaluate("document.getElementById('title').textContent") == summary["title"]
    table = page.evaluate("document.getElementById('summary').textContent")
    for text in (f"Steps{summary['steps']}", f"Blocks{summary['blocks']}", "Statusok", "Energy residual"):
        assert text in table, f"{text} not in {table}"
    names = page.evaluate("document.getElementById('panels').textContent")
    for column in summary["histories"][0]["columns"][1:]:
        assert column["name"] in names, column["name"]


def check_sizes(page):
    """From a phone to a desktop, light and dark: nothing wider than the window, and no blank picture."""
    for width, height, dark in ((360, 740, False), (768, 900, True), (1440, 900, False)):
        page.size(width, height, dark)
        page.settle()
        page.settle()
        assert page.evaluate("document.documentElement.scrollWidth") <= width, f"wider than {width}"
        seen, tall, rows = pixels(page.screenshot(0.25))
        assert (seen, tall) == (width / 4, height / 4)
        colours = {bytes(row[i:i + 3]) for row in rows for i in range(0, len(row), 3)}
        assert len(colours) > 30, f"{len(colours)} colours at {width} px: the page is blank"
        background = rows[2][0]
        assert (background < 60) == dark, "light and dark"


# Settles for at most 100 s, then swings for 0.2 s under a load.
SETTLING = {
    "dda": 1, "title": "Settles and swings", "gravity": 10,
    "materials": {"rock": {"density": 2500, "young": "0.1 GPa", "poisson": 0}}, "joints": {"default": {"bonded": True}},
    "blocks": {"bar": {"length": 4, "height": 1, "block_length": 1}},
    "supports": [{"edge": "left"}],
    "loads": [{"edge": "right", "force": ["10 kN", 0], "history": {"sine": {"frequency": "10 Hz", "start": "100 s"}}}],
    "measurements": [{"name": "end", "quantity": "displacement_x", "point": [4, 0.5]}],
    "steps": [{"name": "settle", "integrator": "static", "equilibrium": 1e-9, "dt": 1, "duration": 100,
               "kinematics": "small"},
              {"name": "swing", "dt": "1 ms", "duration": "0.2 s", "kinematics": "small"}],
}


def check_settling(program, work, page):
    """A stage that settles is a strip of the plots however long it lasts, and the clock tells frames apart."""
    pathlib.Path(work).mkdir(exist_ok=True)
    scene = pathlib.Path(work, "settling.json")
    scene.write_text(json.dumps(SETTLING))
    page.open(make_run(program, scene, f"{work}/settling"))
    page.settle()
    assert page.evaluate("dda.run.frames") == FRAMES + 2
    axis = "dda.panels[0].axis"
    # 3 % of the axis for 100 s, the rest for 0.2 s.
    for time, share in ((0, 0), (50, 0.015), (100, 0.03), (100.1, 0.515), (100.2, 1)):
        near(page.evaluate(f"{axis}.shareOf({time})"), share, 1e-9, f"place of {time} s")
        near(page.evaluate(f"{axis}.timeAt({share})"), time, 1e-9, f"time at {share}")
    ticks = page.evaluate(f"{axis}.ticks(1, 8).values")
    assert len(ticks) >= 4 and all(100 - 1e-9 <= tick <= 100.2 + 1e-9 for tick in ticks), ticks
    clock = []
    for frame in range(FRAMES + 2):
        page.evaluate(f"dda.player.go({frame})")
        clock.append(page.evaluate("document.getElementById('time').textContent"))
    assert len(set(clock)) == FRAMES + 2, clock
    # A click in the middle of the plot is a frame in the middle of the motion.
    x, y = page.evaluate("(() => { const panel = dda.panels[0]; const box = panel.canvas.getBoundingClientRect();"
                         "return [box.left + panel.x(100.1), box.top + 40]; })()")
    page.drag((x, y), (x, y))
    near(page.evaluate("dda.run.times[dda.player.frame]"), 100.1, 0.2 / FRAMES / 2 + 1e-3, "time of the frame clicked at")


def check_coming_and_going(program, work, page):
    """Blocks that a stage takes out and a later one adds again are in the frames between which they are there."""
    settling = {"integrator": "static", "dt": 0.01, "duration": 0.04}
    going = {"dt": 0.01, "duration": 0.04}
    scene = {
        "dda": 1, "gravity": 10, "fixed": ["floor"],
        "materials": {"stone": {"density": 2600, "young": "1 MPa", "poisson": 0.2}},
        "joints": {"default": {"friction_angle": "40 deg"}},
        "blocks": [{"polygon": {"name": name, "vertices": [[x, y], [x + width, y], [x + width, y + 1], [x, y + 1]]}}
                   for name, x, y, width in (("floor", 0, -1, 3), ("post", 0, 0, 1), ("prop", 1, 0, 1), ("load", 0, 1, 2))],
        "steps": [settling | {"name": "settle"}, going | {"name": "gone", "remove": ["prop"]},
                  going | {"name": "back", "add": ["prop"]}, going | {"name": "gone again", "remove": ["prop"]}]}
    folder = pathlib.Path(work, "coming")
    folder.mkdir(exist_ok=True)
    pathlib.Path(folder, "scene.json").write_text(json.dumps(scene))
    page.open(make_run(program, f"{folder}/scene.json", f"{folder}/run"))
    page.settle()
    prop, seen = 2, []
    for frame in range(page.evaluate("dda.run.frames")):
        disk = VtpFrame(f"{folder}/run/frames/{frame:06}.vtp")
        there = set(disk.arrays["CellData/block"])
        shown = {block for block in range(4) if page.evaluate(f"dda.run.isPresent({frame}, {block})")}
        assert shown == there, f"frame {frame} shows blocks {shown}, and has {there}"
        page.evaluate(f"dda.player.go({frame})")
        page.settle()
        for block in there:
            for point, wanted in zip(outline_on_page(page, block), disk.outline(block)):
                for axis in (0, 1):
                    near(point[axis], wanted[axis], 1e-4, f"frame {frame}, block {block}")
        if not seen or seen[-1] != (prop in there):
            seen.append(prop in there)
    assert seen == [True, False, True, False], seen


def main():
    program, work = sys.argv[1:]
    url = make_run(program, pathlib.Path(__file__).with_name("scene.json"), work)
    with Chromium() as page:
        page.size(1000, 700)
        page.open(url)
        page.settle()
        blocks = json.loads(pathlib.Path(work, "summary.json").read_text())["blocks"]
        assert page.evaluate("dda.run.blocks") == blocks
        assert page.evaluate("dda.run.frames") == FRAMES + 1
        check_summary(page, work)
        for frame in (0, 3, FRAMES):
            check_frame(page, work, frame, blocks)
        check_colours(page, work, FRAMES, blocks)
        check_forces(page, work, FRAMES)
        check_bolts(page, work)
        check_controls(page)
        check_chosen_block(page, work)
        check_files(page, work)
        check_deformation_scale(page, work)
        check_sizes(page)
        page.size(1000, 700)
        check_settling(program, work, page)
        check_coming_and_going(program, work, page)
        check_stressed_rock(program, work, page)
        assert not page.problems, page.problems
    print(f"{blocks} blocks, {FRAMES + 1} frames: the page shows what the frames hold")


if __name__ == "__main__":
    main()
