"""A stand-in for the package triangle (drufat/triangle): ``from quadtree_mesh import triangle``.

`triangulate()` takes its dictionaries and switches. doc/python.md lists where results differ.
"""

from __future__ import annotations

import re
from typing import Any, Dict, Iterator, Tuple

import numpy as np

from ._arguments import marker_array, point_array
from ._core import convex_hull as _hull_corners
from .errors import GraphError
from .adaptation import refine as _refine
from .meshing import mesh as _mesh

__all__ = ['triangulate', 'delaunay', 'convex_hull', 'plot', 'compare']

# What only says how to compute, print or count has no meaning here.
_IGNORED = set('zQVCXiFlsBPNEIgj')
_UNSUPPORTED = {
    'u': 'use size or refine_where of quadtree_mesh.mesh()',
    'v': 'there is no Voronoi diagram; mesh.neighbors has the dual graph, and quality_mesh writes x.cells.geojson',
}
_KEYS = {'vertices', 'vertex_attributes', 'vertex_markers', 'segments', 'segment_markers', 'holes', 'regions',
         'triangles', 'triangle_attributes', 'triangle_max_area', 'neighbors', 'edges', 'edge_markers'}


def _switches(opts: str) -> Iterator[Tuple[str, str]]:
    """Letters with the numbers behind them."""
    for letter, number in re.findall(r'([A-Za-z])([0-9.]*)|\S', opts.replace('-', '')):
        if letter in _UNSUPPORTED:
            raise ValueError(f"switch '{letter}' is not supported: {_UNSUPPORTED[letter]}")
        if letter not in _IGNORED and letter not in set('pqaAcrnejSODoY'):
            raise ValueError(f"unknown switch '{letter}'" if letter else f'unknown switches in {opts!r}')
        if letter == 'o' and number != '2':
            raise ValueError("switch 'o' is not supported without a 2: triangles have three nodes, or six with o2")
        yield letter, number


def _border_edges(triangles: np.ndarray, neighbors: np.ndarray) -> np.ndarray:
    """The sides without a neighbor."""
    t, k = np.nonzero(neighbors < 0)
    return np.stack([triangles[t, (k + 1) % 3], triangles[t, (k + 2) % 3]], axis=1)


def _is_among(edges: np.ndarray, others: np.ndarray) -> np.ndarray:
    """Whether each edge, in any direction, is one of others."""
    def key(e: np.ndarray) -> np.ndarray:
        e = np.sort(e.astype(np.int64), axis=1)
        return (e[:, 0] << 32) | e[:, 1]
    return np.isin(key(edges), key(others))


def _without_middle_nodes(tri: Dict[str, Any]) -> Dict[str, Any]:
    """A mesh of six nodes for each triangle without the nodes in the middle of edges."""
    triangles = np.asarray(tri.get('triangles', np.empty((0, 3), np.int64)))
    if triangles.ndim != 2 or triangles.shape[1] != 6:
        return tri
    n = len(tri['vertices'])
    if triangles.min(initial=0) < 0 or triangles.max(initial=-1) >= n:
        raise GraphError(f'a triangle names vertex {triangles.max()}, but there are {n} vertices', 'invalid_mesh')
    is_kept = np.ones(n, bool)
    is_kept[triangles[:, 3:]] = False
    is_kept[triangles[:, :3]] = True
    new_index = np.where(is_kept, np.cumsum(is_kept) - 1, -1)
    result = dict(tri, triangles=new_index[triangles[:, :3]])
    for name in ('vertices', 'vertex_markers', 'vertex_attributes'):
        if name in tri:
            result[name] = np.asarray(tri[name])[is_kept]
    if len(tri.get('segments', ())) > 0:
        result['segments'] = new_index[np.asarray(tri['segments'])]
    return result


def _given_mesh(tri: Dict[str, Any], switches: Dict[str, str]) -> Dict[str, Any]:
    """The mesh to refine, by the letter r, and bounds of area for its triangles."""
    if 'triangles' not in tri:
        raise ValueError('r refines a mesh, and there are no triangles')
    result = dict(vertices=tri['vertices'], triangles=tri['triangles'])
    if 'vertex_markers' in tri:
        result['vertex_markers'] = tri['vertex_markers']
    if 'p' in switches and len(tri.get('segments', ())) > 0:
        result['segments'] = tri['segments']
        if 'segment_markers' in tri:
            result['segment_markers'] = tri['segment_markers']
    if 'triangle_attributes' in tri:
        attributes = np.asarray(tri['triangle_attributes'], float)
        result['triangle_attributes'] = attributes.reshape(len(attributes), -1)[:, 0]
    return result


def _input(tri: Dict[str, Any], switches: Dict[str, str]) -> Dict[str, Any]:
    """The graph to mesh, by the letters p and c."""
    vertices = point_array(tri['vertices'], 'vertices')
    segments, markers = np.empty((0, 2), np.int64), np.empty(0, np.int32)
    if 'p' in switches:
        segments = np.asarray(tri.get('segments', segments)).reshape(-1, 2)
        markers = marker_array(tri.get('segment_markers', np.zeros(len(segments))), len(segments), 'segment_markers')
    if 'c' in switches or 'p' not in switches:
        corners = _hull_corners(vertices)
        border = np.stack([corners, np.roll(corners, -1)], axis=1)
        segments = np.concatenate([segments, border])
        markers = np.concatenate([markers, np.zeros(len(border), np.int32)])
    result: Dict[str, Any] = dict(vertices=vertices, segments=segments, segment_markers=markers,
                                  vertex_markers=tri.get('vertex_markers'))
    if 'p' in switches and 'O' not in switches:
        result['holes'] = tri.get('holes')
    if 'p' in switches and len(tri.get('regions', ())) > 0:
        regions = np.array(tri['regions'], float).reshape(len(tri['regions']), -1)
        regions = np.pad(regions, [(0, 0), (0, max(0, 4 - regions.shape[1]))])
        # Triangle has areas of regions only with an a that has no number, and negative ones for none.
        regions[:, 3] = np.maximum(regions[:, 3], 0) if 'regions' in switches else 0
        result['regions'] = regions
    return result


def triangulate(tri: Dict[str, Any], opts: str = '') -> Dict[str, np.ndarray]:
    """Triangulates by the dictionaries and switches of the package triangle.

    Parameters
    ----------
    tri : dict
        ``vertices`` (n, 2); optional ``segments`` (m, 2), ``holes`` (h, 2), ``regions`` (r, 4) with x, y, attribute
        and largest area, ``vertex_markers``, ``segment_markers``, ``vertex_attributes``; with r ``triangles`` (t, 3) or (t, 6),
        whose nodes in the middle of edges are left out, ``triangle_attributes`` and, if there is an a without a number, ``triangle_max_area``: bounds for what lies in each,
        none where they are negative.
    opts : str
        p (segments), r (refine), q or q30 (least angle, 20 by default and at most 34), a0.1 (largest area), a (areas of
        regions), A (attributes of regions), c (convex hull), D (conforming Delaunay), S100 (most new vertices),
        Y (no new vertices on the boundary), YY (none on any segment), n (neighbors), e (edges), o2 (six nodes for each
        triangle), j (no unused vertices), O (no holes). Letters that choose algorithms or what is printed have no
        effect. u and v are a ValueError.

    Returns
    -------
    dict
        ``vertices``, ``vertex_markers`` (n, 1), ``triangles`` (t, 3), with o2 (t, 6): behind the corners are the nodes
        opposite to them, which follow the vertices; with p ``segments`` and ``segment_markers``; with
        A ``triangle_attributes`` (t, 1), 0 without a region; with n ``neighbors``; with e ``edges`` and
        ``edge_markers``. ``vertex_attributes`` of new vertices are not-a-number.

    Raises
    ------
    quadtree_mesh.GraphError
        (a ValueError) For what cannot be meshed; segments that cross are split.
    """
    switches: Dict[str, str] = {}
    for letter, number in _switches(opts):
        if letter == 'a' and not number:
            switches['regions'] = ''
            number = switches.get('a', '')
        if letter == 'Y' and 'Y' in switches:
            number = 'all'
        switches[letter] = number
    unknown = set(tri) - _KEYS
    if unknown:
        raise KeyError(sorted(unknown)[0])
    n = len(point_array(tri.get('vertices', []), 'vertices'))
    if n < 3:
        raise ValueError('Input must have at least three vertices.')
    attributes = len(tri['vertex_attributes']) if 'vertex_attributes' in tri else n
    if attributes != n:
        raise GraphError(f'vertex_attributes must have {n} rows, one each, not {attributes}', 'array_length')
    bounds: Dict[str, Any] = dict(min_angle=float(switches['q'] or 20) if 'q' in switches else 0,
                                  max_area=float(switches['a']) if switches.get('a') else None,
                                  max_steiner=int(switches['S']) if switches.get('S') else None,
                                  keep_borders=(switches['Y'] or 'boundary') if 'Y' in switches else 'none')
    if 'r' in switches:
        tri = _without_middle_nodes(tri)
        areas = np.ravel(tri['triangle_max_area']) if 'regions' in switches and 'triangle_max_area' in tri else None
        made = _refine(_given_mesh(tri, switches), areas=areas, conforming='D' in switches, **bounds)
    else:
        made = _mesh(**_input(tri, switches), repair=True, conforming='D' in switches,
                     coarsen='q' in switches or 'a' in switches, **bounds)
    if 'j' in switches:
        made = made.compacted()
    return _output(tri, switches, made)


def _output(tri: Dict[str, Any], switches: Dict[str, str], made: Any) -> Dict[str, np.ndarray]:
    result = dict(vertices=made.vertices, vertex_markers=made.vertex_markers[:, None], triangles=made.triangles)
    if 'vertex_attributes' in tri and 'j' not in switches and made.report.repair is None:
        given = np.asarray(tri['vertex_attributes'], float)
        given = given.reshape(len(given), -1)
        result['vertex_attributes'] = np.full((len(made.vertices), given.shape[1]), np.nan)
        if made.old_vertices is None:
            result['vertex_attributes'][:len(given)] = given
        else:
            is_old = made.old_vertices >= 0
            result['vertex_attributes'][is_old] = given[made.old_vertices[is_old]]
    if 'A' in switches:
        result['triangle_attributes'] = made.values_of_triangles(missing=0.0)[:, None]
    if 'n' in switches:
        result['neighbors'] = made.neighbors
    border = _border_edges(made.triangles, made.neighbors)
    markers = np.where((made.segment_markers == 0) & _is_among(made.segments, border), 1, made.segment_markers)
    if 'p' in switches or 'c' in switches or 'r' in switches:
        result['segments'] = np.ascontiguousarray(made.segments)
        result['segment_markers'] = markers.astype(np.int32)[:, None]
    if 'e' in switches:
        edges = made.edges()
        result['edges'] = edges
        result['edge_markers'] = _edge_markers(edges, made.segments, markers)[:, None]
    for name in ('holes', 'regions'):
        if name in tri and 'p' in switches:
            result[name] = np.asarray(tri[name], float)
    if 'o' in switches:
        result['vertices'], result['triangles'], all_markers = _six_nodes(made, markers, border)
        result['vertex_markers'] = all_markers[:, None]
        if 'vertex_attributes' in result:
            given = result['vertex_attributes']
            blank = np.full((len(result['vertices']) - len(given), given.shape[1]), np.nan)
            result['vertex_attributes'] = np.concatenate([given, blank])
    return result


def _six_nodes(made: Any, markers: np.ndarray, border: np.ndarray) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """New places in the middle of edges, behind the vertices; triangles with the nodes opposite their corners; and the
    markers of all, those of the edges for the new ones."""
    n, edges = len(made.vertices), made.edges()
    key = (edges[:, 0].astype(np.int64) << 32) | edges[:, 1]
    sides = np.sort(made.triangles[:, [[1, 2], [2, 0], [0, 1]]].astype(np.int64), axis=2)
    nodes = n + np.searchsorted(key, (sides[..., 0] << 32) | sides[..., 1])
    of_edges = _edge_markers(edges, made.segments, markers)
    of_edges[(of_edges == 0) & _is_among(edges, border)] = 1
    return (np.concatenate([made.vertices, made.vertices[edges].mean(axis=1)]),
            np.concatenate([made.triangles, nodes.astype(made.triangles.dtype)], axis=1),
            np.concatenate([made.vertex_markers, of_edges]))


def _edge_markers(edges: np.ndarray, segments: np.ndarray, markers: np.ndarray) -> np.ndarray:
    """The markers of segments, for edges in lexicographic order; 0 for the others."""
    key = (edges[:, 0].astype(np.int64) << 32) | edges[:, 1]
    ends = np.sort(segments.astype(np.int64), axis=1)
    result = np.zeros(len(edges), np.int32)
    if len(ends) > 0:
        result[np.searchsorted(key, (ends[:, 0] << 32) | ends[:, 1])] = markers
    return result


def delaunay(pts: Any) -> np.ndarray:
    """The Delaunay triangulation of points, a (t, 3) array of indices."""
    return triangulate({'vertices': pts})['triangles']


def convex_hull(pts: Any) -> np.ndarray:
    """The edges of the convex hull of points, an (e, 2) array of indices."""
    made = triangulate({'vertices': pts}, 'n')
    return _border_edges(made['triangles'], made['neighbors'])


def plot(ax: Any, **kw: Any) -> None:
    """Draws what a dictionary has: vertices, segments, triangles, holes."""
    from .plotting import plot_segments

    vertices = np.asarray(kw['vertices'], float)
    if 'triangles' in kw and len(kw['triangles']) > 0:
        ax.triplot(vertices[:, 0], vertices[:, 1], kw['triangles'], linewidth=0.5)
    if 'segments' in kw and len(kw['segments']) > 0:
        plot_segments(ax, vertices, np.asarray(kw['segments']))
    if len(vertices) <= 1000:
        ax.plot(vertices[:, 0], vertices[:, 1], 'o', markersize=3)
    if 'holes' in kw and len(kw['holes']) > 0:
        ax.plot(*np.asarray(kw['holes'], float).T, 'rx')
    ax.set_aspect('equal')


def compare(plt: Any, A: Dict[str, Any], B: Dict[str, Any], figsize: Tuple[float, float] = (6, 3)) -> None:
    """Draws two dictionaries side by side."""
    _, axes = plt.subplots(1, 2, figsize=figsize, sharex=True, sharey=True)
    for ax, one in zip(axes, (A, B)):
        plot(ax, **one)
    plt.tight_layout()
