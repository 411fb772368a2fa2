#!/usr/bin/env python3
"""ezdxf, a program that is not ours, reads the DXF that dda cut exports, finds nothing to mend in it, and the same blocks.

Usage: exported_dxf_test.py PROGRAM EXAMPLES. Every example with rock is exported; what ezdxf reads is compared with the GeoJSON of
the same blocks. The file that ezdxf writes of it is cut again. Exit code 77, skipped, without ezdxf (Debian: python3-ezdxf).
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import ezdxf
except ImportError:
    print("no ezdxf")
    sys.exit(77)


def cut(program, source, folder, exported):
    result = subprocess.run(
        [program, "cut", str(source), "--out", str(folder), "--export", str(exported)], capture_output=True, text=True
    )
    if result.returncode != 0:
        raise SystemExit(f"{source}: {result.stderr}")
    return json.loads((folder / "scene.json").read_text())


def has_rock(scene):
    blocks = scene.get("blocks", [])
    return any("rock" in entry for entry in (blocks if isinstance(blocks, list) else [blocks]))


def drawn(scene):
    """What a drawing can say of blocks; stresses at the start are not among it."""
    kept = ("name", "group", "vertices", "holes")
    blocks = [{key: entry["polygon"].get(key) for key in kept} for entry in scene["blocks"]]
    return blocks, scene.get("joint_lines")


def rings_of_dxf(document):
    entities = document.modelspace().query("POLYLINE")
    return sorted([(vertex.dxf.location.x, vertex.dxf.location.y) for vertex in line.vertices] for line in entities)


def rings_of_geojson(file):
    shapes = [feature["geometry"] for feature in json.loads(file.read_text())["features"]]
    polygons = [shape["coordinates"] for shape in shapes if shape["type"] == "Polygon"]
    return sorted([tuple(position) for position in ring[:-1]] for rings in polygons for ring in rings)


def compare(program, source, folder):
    dxf, geojson = folder / "blocks.dxf", folder / "blocks.geojson"
    first = cut(program, source, folder / "first", dxf)
    cut(program, source, folder / "first", geojson)
    document = ezdxf.readfile(dxf)
    audit = document.audit()
    assert not audit.has_errors and not audit.has_fixes, f"{source}: {audit.errors} {audit.fixes}"
    assert rings_of_dxf(document) == rings_of_geojson(geojson), f"{source}: other blocks in DXF than in GeoJSON"
    for version in ("R12", "R2010"):
        document.dxfversion = version
        document.saveas(folder / f"{version}.dxf")
        again = cut(program, folder / f"{version}.dxf", folder / version, folder / f"again_{version}.dxf")
        assert drawn(again) == drawn(first), f"{source}: other blocks from the file of ezdxf, {version}"


def main():
    program, examples = sys.argv[1:]
    compared = 0
    for source in sorted(Path(examples).glob("*.json")):
        if not has_rock(json.loads(source.read_text())):
            continue
        with tempfile.TemporaryDirectory() as folder:
            compare(program, source, Path(folder))
        compared += 1
    print(f"{compared} rocks are the same to ezdxf")
    return 0 if compared else 1


if __name__ == "__main__":
    sys.exit(main())
