#!/usr/bin/env python3
# Copyright (c) 2026 The Quadtree_mesh_2 authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Quadtree_mesh_2 authors
"""Makes the tables of the documents from the figures of the benchmarks.

usage: tables.py print FIGURES                prints all tables
       tables.py write FIGURES                puts them into the documents, between `<!-- table: NAME -->` and
                                              `<!-- end of table -->`
       tables.py check FIGURES                fails if a document has others
       tables.py stamp FIGURES REPETITIONS    writes down there which machine, commit and day the figures are of

FIGURES is the folder of the files that `benchmark/run.sh` has the benchmarks write; for the documents doc/figures.
"""

import datetime
import json
import os
import re
import subprocess
import sys
from pathlib import Path

from table_texts import graphs, points, quadtrees, theorem_5
from table_texts.layout import Figures, fixed, measured, table, wrapped

ROOT = Path(__file__).resolve().parent.parent
DOCUMENTS = [ROOT / "README.md", *sorted((ROOT / "doc").glob("*.md"))]


def compile_times(figures):
    rows = [
        [f["what"], f["flags"].split()[0], fixed(f["seconds"], 1), fixed(f["bytes"] / 1e6, 2)]
        for f in figures("compile_times")["figures"]
    ]
    return f'By {figures("compile_times")["compiler"]}:\n\n' + table(
        ["what", "flags", "processor seconds", "object in MB"], rows)


def stamp_sentence(figures):
    s = figures("stamp")
    runs = "one run each" if s["repetitions"] == 1 else f'medians of {s["repetitions"]} runs'
    return wrapped(f'{measured(s)}, CGAL {figures("maps")["cgal"]}; {runs}, alternately where there are peers.')


TABLES = {
    "stamp": stamp_sentence,
    "readme": graphs.readme,
    "number of triangles": graphs.number_of_triangles,
    "maps": lambda figures: graphs.mesh_table(figures("maps")["comparisons"]),
    "synthetic": lambda figures: graphs.mesh_table(figures("synthetic")["comparisons"]),
    "world": graphs.world,
    "bounds": lambda figures: graphs.mesh_table(figures("bounds")["comparisons"], has_bound=True),
    "wide angles": graphs.wide_angles,
    "phases": graphs.phases,
    "threads": graphs.threads,
    "growth": graphs.growth,
    "parts": graphs.parts,
    "parts by superstep": graphs.parts_by_superstep,
    "separations": theorem_5.separations,
    "trees": theorem_5.trees,
    "separation phases": theorem_5.separation_phases,
    "separation rounds": theorem_5.separation_rounds,
    "neighbors": theorem_5.neighbors,
    "point modes": points.point_modes,
    "which point mesh": points.which_point_mesh,
    "near points": points.near_points,
    "point peers": points.point_peers,
    "quadtrees": quadtrees.quadtrees,
    "quadtree rounds": quadtrees.quadtree_rounds,
    "compile times": compile_times,
}
BLOCK = re.compile(r"(<!-- table: ([^>]*?) -->\n).*?(<!-- end of table -->)", re.DOTALL)


def with_tables(text, figures):
    return BLOCK.sub(lambda match: match[1] + "\n" + TABLES[match[2]](figures) + "\n\n" + match[3], text)


def stamp(folder, repetitions):
    def output(*command):
        try:
            return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout.strip()
        except (OSError, subprocess.CalledProcessError):
            return ""

    cpu = re.search(r"^model name\s*: (.*)$", Path("/proc/cpuinfo").read_text(), re.MULTILINE)
    commit = output("git", "rev-parse", "--short=10", "HEAD") or "unknown"
    if output("git", "status", "--porcelain", "--", "include", "benchmark"):
        commit += " with changes"
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    figures = {
        "date": datetime.date.today().isoformat(),
        "commit": commit,
        "machine": cpu[1].strip() if cpu else os.uname().machine,
        "cores": os.cpu_count(),
        "memory_gb": round(memory / 2**30),
        "compiler": (output(os.environ.get("CXX", "g++"), "--version").splitlines() or ["unknown"])[0],
        "repetitions": int(repetitions),
    }
    (Path(folder) / "stamp.json").write_text(json.dumps(figures, indent=2) + "\n")


def main(arguments):
    if len(arguments) < 2 or arguments[0] not in ("print", "write", "check", "stamp"):
        print(__doc__, file=sys.stderr)
        return 2
    if arguments[0] == "stamp":
        stamp(*arguments[1:])
        return 0
    figures = Figures(arguments[1])
    if arguments[0] == "print":
        for name, make in TABLES.items():
            print(f"### {name}\n\n{make(figures)}\n")
        return 0
    status = 0
    for document in DOCUMENTS:
        text = document.read_text()
        made = with_tables(text, figures)
        if made == text:
            continue
        if arguments[0] == "write":
            document.write_text(made)
        else:
            print(f"error: {document}: tables are not those of {arguments[1]}: benchmark/run.sh --docs", file=sys.stderr)
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
