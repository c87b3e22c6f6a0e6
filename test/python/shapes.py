"""Small inputs, and what has to hold for every mesh: by code that shares nothing with the mesher."""

import os

import numpy as np

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
GREAT_LAKES = os.path.join(ROOT, 'examples', 'data', 'great_lakes.poly.gz')
SQUARE = dict(vertices=[[0, 0], [1, 0], [1, 1], [0, 1]], segments=[[0, 1], [1, 2], [2, 3], [3, 0]])


def ring(radius, count, first=0):
    """A regular polygon around the origin, and the segments of its vertices, which are numbered from `first`."""
    i = np.arange(count)
    angle = 2 * np.pi * i / count
    return (radius * np.stack([np.cos(angle), np.sin(angle)], axis=1),
            first + np.stack([i, (i + 1) % count], axis=1))


def annulus():
    outer, outer_segments = ring(1.4, 30)
    inner, inner_segments = ring(0.6, 16, first=30)
    return dict(vertices=np.vstack([outer, inner]), segments=np.vstack([outer_segments, inner_segments]),
                holes=[[0, 0]])


def polygon_area(places):
    x, y = np.asarray(places, float).T
    return (x * np.roll(y, -1) - np.roll(x, -1) * y).sum() / 2


def read_poly(lines):
    """The vertices, segments, holes and markers of segments of a .poly file without attributes."""
    rows = [words for words in (line.split('#')[0].split() for line in lines) if words]
    n, _, attributes, markers = map(int, rows[0])
    assert attributes == 0
    first = int(rows[1][0])
    vertices = np.array([row[1:3] for row in rows[1:n + 1]], float)
    m, has_markers = map(int, rows[n + 1])
    table = np.array(rows[n + 2:n + 2 + m], int)
    holes = rows[n + 2 + m + 1:n + 2 + m + 1 + int(rows[n + 2 + m][0])]
    result = dict(vertices=vertices, segments=table[:, 1:3] - first,
                  holes=np.array([row[1:3] for row in holes], float).reshape(-1, 2))
    if has_markers:
        result['segment_markers'] = table[:, 3]
    if markers:
        result['vertex_markers'] = np.array([row[3] for row in rows[1:n + 1]], int)
    return result


def check_mesh(mesh, area=None):
    """Triangles are counterclockwise, meet in whole sides, and know their neighbors; the area is that of the domain."""
    t = np.asarray(mesh.triangles)
    assert (mesh.areas() > 0).all()
    if area is not None:
        assert np.isclose(mesh.areas().sum(), area, rtol=1e-12)
    sides = {}
    for i, k in np.ndindex(t.shape):
        side = (int(t[i, (k + 1) % 3]), int(t[i, (k + 2) % 3]))
        assert side not in sides
        sides[side] = i
    for i, k in np.ndindex(t.shape):
        across = sides.get((int(t[i, (k + 2) % 3]), int(t[i, (k + 1) % 3])), -1)
        assert mesh.neighbors[i, k] == across
    for a, b in np.asarray(mesh.segments).tolist():
        assert (a, b) in sides or (b, a) in sides


def check_segments_are_chains(mesh, graph):
    """The pieces of each input segment add up to its length, and lie on it."""
    vertices, segments = np.asarray(graph['vertices'], float), np.asarray(graph['segments'])
    length = np.linalg.norm(np.diff(vertices[segments], axis=1)[:, 0], axis=1)
    pieces = np.linalg.norm(np.diff(mesh.vertices[mesh.segments], axis=1)[:, 0], axis=1)
    total = np.bincount(mesh.segment_origins, weights=pieces, minlength=len(segments))
    assert np.allclose(total, length, rtol=1e-12)
