#!/usr/bin/env python3
"""Writes great_lakes.poly.gz: the five Great Lakes with their islands as holes, from the GSHHG shorelines.

Needs Debian's gmt and gmt-gshhg-full. Run once by hand; users of the package never need it.
"""
import gzip
import math
import re
import subprocess
import tempfile
from collections import defaultdict

REGION = "-93/-75/41/50"
CENTER = math.radians(45.0), math.radians(-84.5)
EARTH_RADIUS = 6371007.2  # meters; the sphere with the area of the ellipsoid
LAKES = 3  # as sheets of water: Superior, Michigan and Huron are one
TOLERANCE = 70  # meters that a shoreline may move to have fewer vertices


def gmt(*arguments, lines=None):
    """Runs GMT, which leaves a history file where it runs; returns its output in blocks of a header and lines."""
    with tempfile.TemporaryDirectory() as folder:
        text = subprocess.run(["gmt", *arguments, "--FORMAT_FLOAT_OUT=%.10g"], cwd=folder, check=True, text=True,
                              capture_output=True, input=lines and "\n".join(lines)).stdout
    blocks = [block.strip().split("\n") for block in text.split(">")[1:]]
    return [(header, [tuple(row.split("\t")) for row in rows]) for header, *rows in blocks if rows]


def shore_pieces(level):
    """The shorelines of a level (2: lakes, 3: islands in lakes), which GMT gives cut at the borders of its tiles."""
    pieces = gmt("coast", f"-R{REGION}", "-Df", "-W", "-M")
    return [piece for header, piece in pieces if int(re.search(r"Level (\d)", header).group(1)) == level]


def closed_rings(pieces):
    """Joins pieces at equal ends; rings that leave the region stay open and are dropped."""
    rings = [piece[:-1] for piece in pieces if piece[0] == piece[-1]]
    starts = {piece[0]: piece for piece in pieces if piece[0] != piece[-1]}
    while starts:
        first, ring = next(iter(starts.items()))
        del starts[first]
        while ring[-1] in starts:
            ring = ring + starts.pop(ring[-1])[1:]
        if ring[0] == ring[-1]:
            rings.append(ring[:-1])
    return rings


def simplify(rings):
    """Drops vertices by Douglas and Peucker's method; rings with less than three left go."""
    lines = [line for ring in rings for line in [">", *map("\t".join, ring + ring[:1])]]
    simple = [ring[:-1] for _, ring in gmt("simplify", f"-T{TOLERANCE}e", lines=lines)]
    return [ring for ring in simple if len(ring) > 2]


def project(ring):
    """Lambert's azimuthal equal-area projection, to whole meters; drops repeated points."""
    lat0, lon0 = CENTER
    points = []
    for lon, lat in ((math.radians(float(x)), math.radians(float(y))) for x, y in ring):
        cosine = math.sin(lat0) * math.sin(lat) + math.cos(lat0) * math.cos(lat) * math.cos(lon - lon0)
        scale = EARTH_RADIUS * math.sqrt(2 / (1 + cosine))
        x = scale * math.cos(lat) * math.sin(lon - lon0)
        y = scale * (math.cos(lat0) * math.sin(lat) - math.sin(lat0) * math.cos(lat) * math.cos(lon - lon0))
        point = round(x), round(y)
        if not points or points[-1] != point:
            points.append(point)
    while len(points) > 1 and points[0] == points[-1]:
        points.pop()
    return points


def edges(ring):
    return zip(ring, ring[1:] + ring[:1])


def area(ring):
    return abs(sum(a[0] * b[1] - a[1] * b[0] for a, b in edges(ring))) / 2


def cuts_at(ring, y):
    """The abscissas, ascending, where a ring crosses the horizontal line at y, which holds none of its vertices."""
    return sorted(a[0] + (y - a[1]) * (b[0] - a[0]) / (b[1] - a[1]) for a, b in edges(ring) if (a[1] < y) != (b[1] < y))


def point_inside(ring):
    """The middle of the widest chord at half height."""
    ys = sorted({y for _, y in ring})
    y = ys[len(ys) // 2] - 0.5
    cuts = cuts_at(ring, y)
    _, left, right = max((right - left, left, right) for left, right in zip(cuts[::2], cuts[1::2]))
    return (left + right) / 2, y


def contains(ring, point):
    return sum(x < point[0] for x in cuts_at(ring, point[1])) % 2 == 1


def check_disjoint(rings):
    """Fails if a vertex occurs twice or two edges without a common end meet."""
    def side(a, b, c):
        d = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        return (d > 0) - (d < 0)

    vertices = [p for ring in rings for p in ring]
    assert len(set(vertices)) == len(vertices), "a vertex occurs twice"
    cell, grid = 5000, defaultdict(list)
    for a, b in (e for ring in rings for e in edges(ring)):
        for i in range(min(a[0], b[0]) // cell, max(a[0], b[0]) // cell + 1):
            for j in range(min(a[1], b[1]) // cell, max(a[1], b[1]) // cell + 1):
                grid[i, j].append((a, b))
    for bucket in grid.values():
        for k, (a, b) in enumerate(bucket):
            for c, d in bucket[:k]:
                if {a, b} & {c, d}:
                    continue
                apart = side(a, b, c) * side(a, b, d) > 0 or side(c, d, a) * side(c, d, b) > 0
                assert apart or side(a, b, c) == side(a, b, d) == side(c, d, a) == 0, f"{a} {b} meets {c} {d}"


def main():
    lakes = sorted(map(project, simplify(closed_rings(shore_pieces(2)))), key=area, reverse=True)[:LAKES]
    islands = list(map(project, simplify(closed_rings(shore_pieces(3)))))
    islands = [ring for ring in islands if any(contains(lake, point_inside(ring)) for lake in lakes)]
    rings = lakes + islands
    check_disjoint(rings)

    count = sum(map(len, rings))
    lines = ["# The Great Lakes and their islands, from GSHHG 2.3.7 (LGPL), by make_great_lakes.py; meters", f"{count} 2 0 0"]
    lines += [f"{i} {x} {y}" for i, (x, y) in enumerate(p for ring in rings for p in ring)]
    lines.append(f"{count} 0")
    first = 0
    for ring in rings:
        for i in range(len(ring)):
            lines.append(f"{first + i} {first + i} {first + (i + 1) % len(ring)}")
        first += len(ring)
    lines.append(str(len(islands)))
    for i, (x, y) in enumerate(map(point_inside, islands)):
        lines.append(f"{i} {x:.1f} {y:.1f}")
    with open("great_lakes.poly.gz", "wb") as file:
        file.write(gzip.compress(("\n".join(lines) + "\n").encode(), 9, mtime=0))
    print(f"{count} vertices, lakes of {[round(area(r) / 1e6) for r in lakes]} km2, {len(islands)} islands")


if __name__ == "__main__":
    main()
