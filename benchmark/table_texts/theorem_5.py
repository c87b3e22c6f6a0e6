# Copyright (c) 2026 The Quadtree_mesh_2 authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Quadtree_mesh_2 authors
"""Tables of the separation by quadtrees (Theorem 5), beside that on demand, and of what finds its neighbors."""

from pathlib import Path

from .layout import fixed, significant, table, value


def separation_of(comparison):
    return {o["separation"]: o for o in comparison["outcomes"] if "triangles" in o}


def separations(figures):
    ways = ["on demand", "on demand, smoothed and thinned", "Theorem 5", "Theorem 5, all rounds"]
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
    ways = ["thinned", "Theorem 5", "all rounds"]
    titles = ["input", "without removal: on demand", "Theorem 5", "triangles: on demand", *ways]
    titles += ["CPU s: on demand", *ways, "MB: on demand", "Theorem 5"]
    return table(titles, rows)


def trees(figures):
    rows = []
    for c in figures("separation")["comparisons"]:
        made, of_all_rounds = (separation_of(c).get(way) for way in ("Theorem 5", "Theorem 5, all rounds"))
        if not made or not of_all_rounds:
            continue
        t = made["trees"]
        # By default no T_B is made.
        row = [c["input"], of_all_rounds["trees"]["leaves_of_points"], t["leaves_of_vertices"], t["leaves_of_pieces"], t["leaves_of_edges"]]
        row += [t["triangles"], t["missed_by_rule"], fixed(100 * t["missed_by_rule"] / t["triangles"], 2)]
        rows.append([*row, t["placed"], t["kept"], of_all_rounds["trees"]["rounds"]])
    titles = ["input", "T_B", "T_B'", "T_B''", "T_B*", "triangles of the rule", "below the bound", "%"]
    return table([*titles, "vertices placed", "in the mesh", "rounds until none is missed"], rows)


def separation_phases(figures):
    rows = []
    for c in figures("separation")["comparisons"]:
        all_ways = separation_of(c)
        names = ["Theorem 5", "Theorem 5, distances by trapezoids", "Theorem 5, centroid trees"]
        made = [all_ways.get(name) for name in names]
        if None in made:
            continue
        row = [c["input"], *(significant(m["phases"]["trees"]) for m in made)]
        row += [significant(made[i]["phases"]["construct"]) for i in (0, 2)]
        rows.append([*row, significant(made[0]["phases"]["refine"] + made[0]["phases"]["coarsen"])])
    titles = ["input", "trees", "trees, distances by trapezoids", "trees, edges by centroid trees"]
    titles += ["placing", "the same, by centroid trees", "refinement and removal in blocks"]
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
