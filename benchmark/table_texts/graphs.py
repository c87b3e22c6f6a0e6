# Copyright (c) 2026 The Quadtree_mesh_2 authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Quadtree_mesh_2 authors
"""Tables of meshes of graphs, beside peers and in their phases."""

from .layout import by_mesher, fixed, measured, peers, ratio, significant, table, value, wrapped


NAMES = {
    "great_lakes": "The Great Lakes (GSHHG)",
    "us_states_10m": "Borders of the US states (US Census)",
    "gshhg_aegean_h": "Coasts of the Aegean (GSHHG)",
    "gshhg_norway_f": "Coasts of Norway (GSHHG, full resolution)",
    "syn_holes_400": "A plate with 400 hexagonal holes",
    "syn_comb": "A comb of 500 thin teeth",
    "syn_wedge_0.01deg": "A corner of 0.01 degrees in a box",
}


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
    names = peers(figures("maps")["comparisons"])
    rows = []
    for key, name in NAMES.items():
        if key in comparisons:
            c = comparisons[key]
            rows.append([name, c["vertices"], *figures_beside_peers(c, "triangles", str, names)])
            rows[-1] += figures_beside_peers(c, "cpu_seconds", significant, names)
    titles = ["input", "vertices", *titles_beside_peers("triangles", names)]
    return table([*titles, *titles_beside_peers("CPU s", names)], rows)


def number_of_triangles(figures):
    comparisons = [c for c in figures("maps")["comparisons"] if not c["input"].startswith("syn_")]
    names = peers(comparisons)
    rows = [[c["input"], c["vertices"], *figures_beside_peers(c, "triangles", str, names)] for c in comparisons]
    return table(["input", "vertices", *titles_beside_peers("triangles", names)], rows)


def wide_angles(figures):
    """Meshes without and with a bound on the greatest angle, the same for all of them."""
    comparisons = figures("max_angle")["comparisons"]
    bound = f'{comparisons[0]["max_angle_bound"]:g}'
    rows = []
    for c in comparisons:
        meshers = by_mesher(c)
        pair = [meshers["ours"], meshers[f"ours, no angle above {bound}"]]
        row = [c["input"], *(m["triangles"] for m in pair), ratio(pair[1]["triangles"], pair[0]["triangles"])]
        row += [m["above_max_angle"] for m in pair]
        row += [fixed(m["max_exempt_angle"], 1) if m["exempt"] else "-" for m in pair]
        rows.append(row + [significant(m["cpu_seconds"]) for m in pair])
    titles = ["input", "triangles without the bound", "with it", "with / without", f"above {bound} degrees without it"]
    titles += ["with it", "greatest exempt angle without it", "with it", "CPU s without it", "with it"]
    return table(titles, rows)


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
    size = f'{words["input_vertices"]} vertices and {words["input_segments"]} segments.'
    return (
        wrapped(f'{size} {measured(figures("world/stamp"))}; one run.')
        + "\n\n"
        + table(["mesher", "triangles", "below the bound", "CPU s", "GB"], rows)
    )


def parts(figures):
    rows = [
        [f["input"], f["parts"], f["rounds"], fixed(f["mean_messages"], 0), f["most_messages"],
         significant(f["mean_bytes"] / 1e3), significant(f["most_bytes"] / 1e3), f["most_triangles"],
         fixed(100 * f["share_worked_on_again"], 1)]
        for f in figures("parts")["parts"]
    ]
    titles = ["input", "parts", "rounds", "messages: mean", "most", "kB: mean", "most"]
    return table([*titles, "triangles held at most", "worked on again, %"], rows)


def parts_by_superstep(figures):
    """Of the coast in 24 parts, for each part on average."""
    f = next(f for f in figures("parts")["parts"] if f["input"] == "coast:3e5" and f["parts"] == 24)
    rows = [
        [s["superstep"], s["supersteps"], significant(s["messages"] / 24), significant(s["bytes"] / 24e3)]
        for s in f["supersteps"]
    ]
    return table(["superstep", "of them", "messages", "kB"], rows)
