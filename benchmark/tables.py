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
import textwrap
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
WIDTH = 110  # of text, as of code
DOCUMENTS = [ROOT / "README.md", *sorted((ROOT / "doc").glob("*.md"))]
NAMES = {
    "great_lakes": "The Great Lakes (GSHHG)",
    "us_states_10m": "Borders of the US states (US Census)",
    "gshhg_aegean_h": "Coasts of the Aegean (GSHHG)",
    "gshhg_norway_f": "Coasts of Norway (GSHHG, full resolution)",
    "syn_holes_400": "A plate with 400 hexagonal holes",
    "syn_comb": "A comb of 500 thin teeth",
    "syn_wedge_0.01deg": "A corner of 0.01 degrees in a box",
}


# ---- text


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


# ---- meshes of graphs


def figures_beside_peers(comparison, key, text, names):
    """Cells of ours and of the peers, then the ratios."""
    meshers = by_mesher(comparison)
    ours = value(meshers.get("ours"), key)
    theirs = [value(meshers.get(name), key) for name in names]
    shown = [text(v) if v is not None else "-" for v in (ours, *theirs)]
    return shown + [ratio(ours, v) for v in theirs]


def titles_beside_peers(what, names):
    return [f"{what}: ours", *names, *(f"ours / {name}" for name in names)]


def mesh_table(comparisons, has_bound=False):
    names = peers(comparisons)
    titles = ["bound"] * has_bound + ["input", "vertices", *titles_beside_peers("triangles", names)]
    titles += ["below the bound: ours", *names, *titles_beside_peers("CPU s", names)]
    titles += ["to a CGAL triangulation, CPU s", "MB: ours", *names]
    rows = []
    for c in comparisons:
        meshers = by_mesher(c)
        all_meshers = [meshers.get(name) for name in ("ours", *names)]
        row = [f'{c["min_angle_bound"]:g}'] * has_bound + [c["input"], c["vertices"]]
        row += figures_beside_peers(c, "triangles", str, names)
        row += ["-" if m is None else m["below_bound"] for m in all_meshers]
        row += figures_beside_peers(c, "cpu_seconds", significant, names)
        row.append(significant(value(meshers.get("ours"), "to_triangulation_seconds")))
        row += [fixed(value(m, "peak_memory_mb"), 0) for m in all_meshers]
        rows.append(row)
    return table(titles, rows)


def readme(figures):
    comparisons = {c["input"]: c for c in figures("maps")["comparisons"]}
    rows = []
    for key, name in NAMES.items():
        if key in comparisons:
            c = comparisons[key]
            meshers = by_mesher(c)
            row = [name, c["vertices"], *figures_beside_peers(c, "triangles", str, ["Mesh_2"])]
            row += figures_beside_peers(c, "cpu_seconds", significant, ["Mesh_2"])
            row += [fixed(value(meshers.get(m), "peak_memory_mb"), 0) for m in ("ours", "Mesh_2")]
            rows.append(row)
    titles = ["input", "vertices", "triangles, ours", "Mesh_2", "ratio", "processor seconds, ours", "Mesh_2", "ratio"]
    return table([*titles, "peak memory in MB, ours", "Mesh_2"], rows)


def number_of_triangles(figures):
    comparisons = [c for c in figures("maps")["comparisons"] if not c["input"].startswith("syn_")]
    names = peers(comparisons)
    rows = [[c["input"], c["vertices"], *figures_beside_peers(c, "triangles", str, names)] for c in comparisons]
    return table(["input", "vertices", *titles_beside_peers("triangles", names)], rows)


def phases(figures):
    rows, titles = [], []
    for c in figures("maps")["comparisons"] + figures("synthetic")["comparisons"]:
        ours = by_mesher(c).get("ours")
        if ours and ours["triangles"] >= 10000:
            titles = list(ours["phases"])
            unit = 1e6 / ours["triangles"]
            rows.append([c["input"], fixed(unit * ours["cpu_seconds"], 3)])
            rows[-1] += [fixed(unit * seconds, 3) for seconds in ours["phases"].values()]
    return table(["input", "µs per triangle", *titles], rows)


def threads(figures):
    rows = []
    for c in figures("threads")["comparisons"]:
        meshers = by_mesher(c)
        for name, m in meshers.items():
            speedup = meshers["ours"]["wall_seconds"] / m["wall_seconds"]
            rows.append([c["input"], name, m["triangles"], significant(m["wall_seconds"])])
            rows[-1] += [significant(m["cpu_seconds"]), fixed(speedup, 2)]
    return table(["input", "mesher", "triangles", "wall s", "CPU s", "speedup over the sequential mesher"], rows)


def growth(figures):
    rows, unit, last = [], 0, ""
    for c in figures("growth")["comparisons"]:
        ours = by_mesher(c).get("ours")
        if not ours:
            continue
        family, time = c["input"].split(":")[0], 1e6 * ours["cpu_seconds"] / ours["triangles"]
        unit, last = (unit, last) if family == last else (time, family)
        rows.append([family, c["vertices"], ours["triangles"], significant(ours["cpu_seconds"])])
        rows[-1] += [fixed(time, 3), fixed(time / unit, 2)]
    titles = ["family", "vertices", "triangles", "CPU s", "µs per triangle", "relative to the smallest"]
    return table(titles, rows)


# ---- Theorem 5


def separation_of(comparison):
    return {o["separation"]: o for o in comparison["outcomes"] if "triangles" in o}


def separations(figures):
    ways = ["on demand", "on demand, smoothed and thinned", "Theorem 5"]
    rows = []
    for c in figures("separation")["comparisons"]:
        all_ways = separation_of(c)
        made = [all_ways.get(way) for way in ways]
        row = [c["input"]]
        row += ["-" if made[i] is None else made[i]["triangles_without_removal"] for i in (0, 2)]
        row += ["-" if m is None else m["triangles"] for m in made]
        row += [significant(value(m, "cpu_seconds")) for m in made]
        row += [fixed(value(made[i], "peak_memory_mb"), 0) for i in (0, 2)]
        rows.append(row)
    titles = ["input", "without removal: on demand", "Theorem 5", "triangles: on demand", "with rounds", "Theorem 5"]
    titles += ["CPU s: on demand", "with rounds", "Theorem 5", "MB: on demand", "Theorem 5"]
    return table(titles, rows)


def trees(figures):
    rows = []
    for c in figures("separation")["comparisons"]:
        made = separation_of(c).get("Theorem 5")
        if not made:
            continue
        t = made["trees"]
        row = [c["input"], t["leaves_of_points"], t["leaves_of_vertices"], t["leaves_of_pieces"], t["leaves_of_edges"]]
        row += [t["rounds"], t["triangles"], t["missed_by_rule"], fixed(100 * t["missed_by_rule"] / t["triangles"], 2)]
        rows.append([*row, t["left_out"], t["missed"]])
    titles = ["input", "T_B", "T_B'", "T_B''", "T_B*", "rounds", "triangles of the rule", "below the bound", "%"]
    return table([*titles, "left out", "not cured"], rows)


def separation_phases(figures):
    rows = []
    for c in figures("separation")["comparisons"]:
        all_ways = separation_of(c)
        names = ["Theorem 5", "Theorem 5, neighbors by trapezoids", "Theorem 5, centroid trees"]
        made = [all_ways.get(name) for name in names]
        if None in made:
            continue
        row = [c["input"], *(significant(m["phases"]["trees"]) for m in made)]
        row += [significant(made[i]["phases"]["construct"]) for i in (0, 2)]
        rows.append([*row, significant(made[0]["phases"]["coarsen"])])
    titles = ["input", "trees", "trees, neighbors by trapezoids", "trees, edges by centroid trees"]
    titles += ["rounds of placing and splitting", "the same, by centroid trees", "smoothing, thinning, removal"]
    return table(titles, rows)


def separation_rounds(figures):
    keys = ["input", "vertices", "leaves", "triangles", "of_points", "of_neighbors", "splits", "centroid_height"]
    keys += ["subdivisions", "placings", "all"]
    rows = [
        [*(r[key] for key in keys), fixed(r["bound"], 0), fixed(r["all"] / r["bound"], 2)]
        for r in figures("separation_rounds")["rounds"]
    ]
    titles = ["input", "n", "leaves of T_B*", "k", "T_B", "neighbors", "splits", "centroid tree's height"]
    return table([*titles, "subdivisions", "placings", "all", "log2 k log2 n", "all / that"], rows)


def neighbors(figures):
    by_input = {}
    for n in figures("neighbors")["neighbors"]:
        by_input.setdefault(n["input"], []).append(n)
    rows = []
    for name, methods in by_input.items():
        cgal = next(n["wall_seconds"] for n in methods if n["method"] == "CGAL")
        for n in methods:
            how = n["method"] + {0: "", 1: ", 1 thread"}.get(n["threads"], f', {n["threads"]} threads')
            wall = n["wall_seconds"]
            rows.append([Path(name).name.split(".poly")[0], n["vertices"], how, significant(1e3 * wall)])
            rows[-1] += [fixed(1e6 * wall / n["vertices"], 2), fixed(wall / cgal, 2)]
    return table(["input", "vertices", "by", "wall, ms", "µs a vertex", "to CGAL's"], rows)


def world(figures):
    """The coasts of the world; over words there are only the program's own figures. Not every machine has the memory."""
    if "world/world" not in figures:
        return "There are no figures yet: `benchmark/world.sh --docs` writes them here."
    rows = []
    for c in figures("world/world")["comparisons"]:
        for name, m in by_mesher(c).items():
            row = [name, m["triangles"], m["below_bound"], fixed(m["cpu_seconds"], 0)]
            rows.append([*row, fixed(m["peak_memory_mb"] / 1e3, 1)])
    words = figures("world/words")
    row = ["ours over 64-bit words", words["triangles"], words["unmet_triangles"], fixed(words["seconds"]["mesh"], 0)]
    rows.insert(1, [*row, fixed(words["peak_memory_mb"] / 1e3, 1)])
    return (
        f'{words["input_vertices"]} vertices and {words["input_segments"]} segments. {measured(figures("world/stamp"))}; '
        "one run.\n\n" + table(["mesher", "triangles", "below the bound", "CPU s", "GB"], rows)
    )


# ---- points

MODES = {
    "bounded:0": "bounded, effort 0",
    "bounded:1": "bounded, effort 1",
    "bounded": "bounded, effort 2",
    "bounded:3": "bounded, effort 3",
    "tight": "37.5 to 78.6",
    "wide": "30 to 89.5",
}


def point_modes(figures):
    rows = []
    for c in figures("points_modes")["comparisons"]:
        for name, m in by_mesher(c).items():
            n, least = c["points"], c["least_length"]
            row = [MODES.get(name, name), fixed(m["triangles"] / n, 1)]
            row.append(fixed(m["triangles_before_coarsening"] / n, 1))
            row.append(f'{m["min_angle"]:.1f}..{m["max_angle"]:.1f}')
            row.append(fixed(m["total_length"] / least, 1) if least > 0 else "-")
            rows.append([*row, significant(m["cpu_seconds"]), fixed(m["peak_memory_mb"], 0)])
    titles = ["mode", "triangles per point", "before coarsening", "angles", "length / lower bound", "CPU s", "MB"]
    return table(titles, rows)


WHICH_MESH = [
    ("bounded", "`bounded_angles(36, 80)`", "all angles in the range; down to [37.5, 78.6]", "interpolation, superconvergence"),
    ("wide", "`bounded_angles(30, 89.5)`", "the same; wide ranges need fewer triangles", "finite volumes"),
    (
        "acute",
        "`acute()`",
        "all angles less than 90 degrees, O(n) triangles whatever the points' distances",
        "finite volumes, maximum principles; the dual is a Voronoi diagram with all centers inside",
    ),
    (
        "points",
        "`least_angle()`",
        "all angles at least 20.7 degrees, fewest triangles",
        "finite elements; nothing is said about large angles but that they are less than 138.6",
    ),
    ("warped", "`warped_squares()`", "all angles in [22.47, 112.63]", "the classical construction, fast and simple; a reference"),
]


def which_point_mesh(figures):
    c = figures("points_modes")["comparisons"][0]
    meshers = by_mesher(c)
    rows = []
    for key, name, promise, use in WHICH_MESH:
        count = value(meshers.get(key), "triangles")
        rows.append([name, promise, "-" if count is None else fixed(count / c["points"], 1), use])
    return table(["mode", "promise", f'triangles for each of {c["points"]} uniform points', "what it is for"], rows)


def near_points(figures):
    rows = []
    for c in figures("points_near")["comparisons"]:
        m = by_mesher(c).get("acute")
        if m:
            n = c["points"]
            row = [c["input"], n, fixed(m["triangles"] / n, 1), fixed(m["triangles_before_coarsening"] / n, 0)]
            rows.append([*row, m["clusters"], significant(m["cpu_seconds"])])
    return table(["family", "points", "triangles per point", "before coarsening", "clusters", "CPU s"], rows)


def point_peers(figures):
    rows, titles = [], []
    for c in figures("points_peers")["comparisons"]:
        meshers = by_mesher(c)
        ours = meshers.pop("points", None)
        for name, peer in meshers.items():
            row = [c["points"], name]
            for key, text in (("triangles", str), ("cpu_seconds", significant)):
                row += [text(ours[key]) if ours else "-", text(peer[key]), ratio(value(ours, key), peer[key])]
            rows.append([*row, fixed(value(ours, "peak_memory_mb"), 0), fixed(peer["peak_memory_mb"], 0)])
    titles = ["points", "peer", "triangles: ours", "peer", "ratio", "CPU s: ours", "peer", "ratio", "MB: ours", "peer"]
    return table(titles, rows)


# ---- quadtrees


def quadtree_stages(comparison):
    """Of each method the stage in which it has made something: (method, made) -> (method's figures, stage)."""
    return {(m["method"], s["made"]): (m, s) for m in comparison["methods"] for s in m["stages"]}


def quadtrees(figures):
    rows = []
    for c in figures("quadtree")["comparisons"]:
        for (name, made), (m, stage) in quadtree_stages(c).items():
            is_last = stage is m["stages"][-1]
            seconds = stage["wall_seconds_until"] if m["threads"] > 0 else stage["cpu_seconds_until"]
            row = [c["input"], made, name, stage["size"], significant(seconds), fixed(1e9 * seconds / c["points"], 0)]
            crowded = m["leaves_with_several_points"]
            rows.append([*row, fixed(m["memory_mb"], 0) if is_last else "", crowded if is_last and crowded else ""])
    titles = ["points", "made", "by", "size", "seconds", "ns per point", "MB", "leaves with several points"]
    return table(titles, rows)


def quadtree_rounds(figures):
    rows = []
    for r in figures("quadtree_rounds")["rounds"]:
        work, path = r["work_seconds"], r["path_seconds"]
        row = [f'{r["points"]} {r["input"]}', r["schedule"], r["steps"], significant(1e3 * work)]
        rows.append([*row, significant(1e3 * path), significant(work / path, 2)])
    return table(["points", "schedule", "steps", "work, ms", "path, ms", "work / path"], rows)


# ---- documents


def compile_times(figures):
    rows = [
        [f["what"], f["flags"].split()[0], fixed(f["seconds"], 1), fixed(f["bytes"] / 1e6, 2)]
        for f in figures("compile_times")["figures"]
    ]
    return f'By {figures("compile_times")["compiler"]}:\n\n' + table(
        ["what", "flags", "processor seconds", "object in MB"], rows)


def measured(s):
    return (
        f'Measured on {s["date"]} at commit {s["commit"]}: {s["machine"]}, {s["cores"]} cores, {s["memory_gb"]} GB, '
        f'{s["compiler"]}'
    )


def stamp_sentence(figures):
    s = figures("stamp")
    runs = "one run each" if s["repetitions"] == 1 else f'medians of {s["repetitions"]} runs'
    sentence = f'{measured(s)}, CGAL {figures("maps")["cgal"]}; {runs}, alternately where there are peers.'
    return textwrap.fill(sentence, WIDTH, break_on_hyphens=False)


TABLES = {
    "stamp": stamp_sentence,
    "readme": readme,
    "number of triangles": number_of_triangles,
    "maps": lambda figures: mesh_table(figures("maps")["comparisons"]),
    "synthetic": lambda figures: mesh_table(figures("synthetic")["comparisons"]),
    "world": world,
    "bounds": lambda figures: mesh_table(figures("bounds")["comparisons"], has_bound=True),
    "phases": phases,
    "threads": threads,
    "growth": growth,
    "separations": separations,
    "trees": trees,
    "separation phases": separation_phases,
    "separation rounds": separation_rounds,
    "neighbors": neighbors,
    "point modes": point_modes,
    "which point mesh": which_point_mesh,
    "near points": near_points,
    "point peers": point_peers,
    "quadtrees": quadtrees,
    "quadtree rounds": quadtree_rounds,
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
