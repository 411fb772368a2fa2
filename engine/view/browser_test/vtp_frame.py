"""What a frame on disk holds, read here once more so that the page is judged by it, and what the page shows of it."""

import pathlib
import re
import struct


class VtpFrame:
    """The arrays of a .vtp file."""

    TYPES = {"Float64": "d", "Int32": "i", "Int64": "q"}

    def __init__(self, path):
        content = pathlib.Path(path).read_bytes()
        head, data = content.split(b'<AppendedData encoding="raw">\n_', 1)
        self.arrays, section = {}, None
        for tag in re.findall(r"<(/?\w+)([^>]*)>", head.decode()):
            if tag[0] != "DataArray":
                section = tag[0]
                continue
            attribute = dict(re.findall(r'(\w+)="([^"]*)"', tag[1]))
            offset = int(attribute["offset"])
            size = struct.unpack_from("<Q", data, offset)[0]
            if attribute["type"] == "String":
                continue
            letter = self.TYPES[attribute["type"]]
            count = size // struct.calcsize(letter)
            self.arrays[f"{section}/{attribute['Name']}"] = struct.unpack_from(f"<{count}{letter}", data, offset + 8)

    def cell_of(self, block):
        return self.arrays["CellData/block"].index(block)

    def stress_yy(self, block):
        return self.arrays["CellData/stress_yy [Pa]"][self.cell_of(block)]

    def cells(self, kind):
        offsets = (0,) + self.arrays[f"{kind}/offsets"]
        return [self.arrays[f"{kind}/connectivity"][a:b] for a, b in zip(offsets, offsets[1:])]

    def outline(self, block):
        """All vertices of a block: of its rings, which are closed lines, or of its one polygon."""
        cells = [cell[:-1] for cell in self.cells("Lines")]
        rings = [cell for cell, own in zip(cells, self.arrays["CellData/block"]) if own == block]
        if not rings:
            rings = [self.cells("Polys")[self.cell_of(block) - len(cells)]]
        points = self.arrays["Points/Points"]
        return [(points[3 * i], points[3 * i + 1]) for ring in rings for i in ring]


def near(found, expected, tolerance, what):
    assert abs(found - expected) <= tolerance, f"{what}: {found}, expected {expected} within {tolerance}"


def outline_on_page(page, block):
    return page.evaluate(
        f"dda.run.ringsOf({block}).flatMap(([begin, end]) => Array.from({{length: end - begin}}, (_, i) => ["
        "dda.stage.points[2 * (begin + i)] + dda.run.header.origin[0],"
        "dda.stage.points[2 * (begin + i) + 1] + dda.run.header.origin[1]]))")
