"""What checks of the page share: the run that it shows, and where things are on it."""

import pathlib
import subprocess

FRAMES = 8
FRAME_BLOCK = 1  # of scene.json: a square with a square hole


def make_run(program, scene, work):
    subprocess.run([program, "run", scene, "--out", work, "--frames", str(FRAMES), "--quiet"], check=True)
    page = pathlib.Path(work, "view.html")
    page.unlink(missing_ok=True)
    subprocess.run([program, "view", work, "--quantity", "stress_yy"], check=True, stdout=subprocess.DEVNULL)
    return page.resolve().as_uri()


def colour_at(image, x, y):
    width, height, rows = image
    assert 0 <= x < width and 0 <= y < height, f"({x}, {y}) is outside the picture"
    return tuple(rows[int(y)][3 * int(x):3 * int(x) + 3])


def on_screen(page, x, y):
    return page.evaluate(
        f"(() => {{ const [x0, y0] = dda.run.header.origin; const box = dda.stage.canvas.getBoundingClientRect();"
        f"const [px, py] = dda.stage.camera.toScreen({x} - x0, {y} - y0); return [px + box.left, py + box.top]; }})()")
