# Copyright (c) 2026 The Quadtree_mesh_2 authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Quadtree_mesh_2 authors
"""Tables of quadtrees."""

from .layout import fixed, significant, table


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
