# Copyright (c) 2026 The Quadtree_mesh_2 authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Quadtree_mesh_2 authors
"""Cells, rows and tables of Markdown, and the figures that they are made from."""

import json
import sys
import textwrap
from pathlib import Path

WIDTH = 110  # of text, as of code


def significant(value, digits=3):
    """A number with so many digits that count, none left out before the point."""
    if value is None:
        return "-"
    if value <= 0:
        return "0"
    places = digits - 1
    scaled = value
    while scaled >= 10 and places > 0:
        scaled, places = scaled / 10, places - 1
    while scaled < 1 and places < 9:
        scaled, places = scaled * 10, places + 1
    return f"{value:.{places}f}"


def fixed(value, places):
    return "-" if value is None else f"{value:.{places}f}"


def ratio(ours, theirs):
    return fixed(ours / theirs, 3) if ours is not None and theirs else "-"


def table(titles, rows):
    lines = [titles, ["---"] * len(titles), *rows]
    return "\n".join("| " + " | ".join(str(cell) for cell in line) + " |" for line in lines)


class Figures:
    """The files of a folder, each read once."""

    def __init__(self, folder):
        self.folder, self.files = Path(folder), {}

    def file(self, name):
        return self.folder / f"{name}.json"

    def __contains__(self, name):
        return self.file(name).exists()

    def __call__(self, name):
        file = self.file(name)
        if not file.exists():
            sys.exit(f"error: there is no {file}: benchmark/run.sh --docs")
        if name not in self.files:
            self.files[name] = json.loads(file.read_text())
        return self.files[name]


def by_mesher(comparison):
    """Meshers by name; without those that made no mesh."""
    return {m["mesher"]: m for m in comparison["meshers"] if "triangles" in m}


def peers(comparisons):
    return [m["mesher"] for m in comparisons[0]["meshers"] if not m["mesher"].startswith("ours")]


def value(mesher, key):
    return mesher[key] if mesher else None


def wrapped(sentences):
    return textwrap.fill(sentences, WIDTH, break_on_hyphens=False)


def measured(s):
    return (
        f'Measured on {s["date"]} at commit {s["commit"]}: {s["machine"]}, {s["cores"]} cores, {s["memory_gb"]} GB, '
        f'{s["compiler"]}'
    )
