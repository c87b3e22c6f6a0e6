# Copyright (c) 2026 The Quadtree_mesh_2 authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Quadtree_mesh_2 authors
"""Tables of meshes of points."""

from .layout import by_mesher, fixed, ratio, significant, table, value


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
