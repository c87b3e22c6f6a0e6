"""Meshes as the files of Triangle have them, measured by formulas that the page does not use."""

import math
import os
import subprocess

DATA = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), 'data')


def rows(path):
    with open(path, encoding='utf-8') as file:
        return [line.split() for line in file if line.strip() and not line.startswith('#')]


class Mesh:
    """What quality_mesh writes for an input: a page beside `.node`, `.ele` and `.poly`."""

    def __init__(self, folder, name, *arguments, statuses=(0,)):
        stem = os.path.join(folder, 'mesh')
        path = name if os.path.isabs(name) else os.path.join(DATA, name)
        run = subprocess.run([os.environ['QUADTREE_MESH_PROGRAM'], path, '-o', stem + '.html', '-o', stem + '.ele',
                              *arguments], capture_output=True, text=True, check=False)
        if run.returncode not in statuses:
            raise RuntimeError(f'quality_mesh ends with {run.returncode}: {run.stderr}')
        self.page, self.printed = stem + '.html', run.stdout
        nodes = rows(stem + '.node')[1:]
        self.first = int(nodes[0][0])
        self.points = [(float(row[1]), float(row[2])) for row in nodes]
        self.triangles = [tuple(int(v) - self.first for v in row[1:4]) for row in rows(stem + '.ele')[1:]]
        edges = rows(stem + '.poly')[1:]
        self.by_room = None
        self.segments = [tuple(int(v) - self.first for v in row[1:3]) for row in edges[1:1 + int(edges[0][0])]]

    def corners(self, t):
        return [self.points[v] for v in self.triangles[t]]

    def centroid(self, t):
        return tuple(sum(c) / 3 for c in zip(*self.corners(t)))

    def sides(self, t):
        a, b, c = self.corners(t)
        return sorted((math.dist(a, b), math.dist(b, c), math.dist(c, a)))

    def area(self, t):
        (ax, ay), (bx, by), (cx, cy) = self.corners(t)
        return ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2

    def angles(self, t):
        """Least and largest, in degrees, by the law of cosines."""
        a, b, c = self.sides(t)

        def opposite(a, b, c):
            return math.degrees(math.acos(max(-1, min(1, (b * b + c * c - a * a) / (2 * b * c)))))
        return opposite(a, b, c), opposite(c, a, b)

    def inner_radius(self, t):
        return 2 * self.area(t) / sum(self.sides(t))

    def widest(self, n):
        """The triangles in which there is most room for a pointer."""
        self.by_room = self.by_room or sorted(range(len(self.triangles)), key=self.inner_radius, reverse=True)
        return self.by_room[:n]
