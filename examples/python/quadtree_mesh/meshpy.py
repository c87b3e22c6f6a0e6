"""A stand-in for meshpy.triangle: ``from quadtree_mesh import meshpy as triangle``.

`MeshInfo`, `build()` and `subdivide_facets()` are as there. Meshes have NumPy arrays. doc/python.md lists where results
differ.
"""

from __future__ import annotations

from typing import Any, Callable, List, Optional, Sequence, Tuple, Union

import numpy as np

from .meshing import mesh as _mesh
from .triangle import _border_edges, _edge_markers, _is_among, _six_nodes

__all__ = ['MeshInfo', 'build', 'subdivide_facets']

Refinement = Callable[[List[Tuple[float, float]], float], bool]


class _Rows(list):
    """A list with the two functions that MeshPy's arrays have besides."""

    def resize(self, count: int) -> None:
        self[:] = (self + [None] * count)[:count]

    def setup(self) -> None:
        pass


class MeshInfo:
    """What `build()` takes and returns.

    Attributes
    ----------
    points : (n, 2); point_markers : (n,)
    facets : (m, 2), segments by indices of points; facet_markers : (m,)
    holes : (h, 2)
    regions : (r, 4), rows of x, y, attribute, largest area
    elements : (t, 3), triangles, (t, 6) with ``mesh_order=2``
    element_attributes : (t,), of regions; neighbors : (t, 3)
    faces : (e, 2), edges; face_markers : (e,)
    """

    def __init__(self) -> None:
        self.points: Any = _Rows()
        self.point_markers: Any = _Rows()
        self.facets: Any = _Rows()
        self.facet_markers: Any = _Rows()
        self.holes: Any = _Rows()
        self.regions: Any = _Rows()
        self.elements: Any = _Rows()
        self.element_attributes: Any = _Rows()
        self.neighbors: Any = _Rows()
        self.faces: Any = _Rows()
        self.face_markers: Any = _Rows()

    def set_points(self, points: Sequence[Any], point_markers: Optional[Sequence[int]] = None) -> None:
        """Sets places (x, y), and their markers."""
        self.points = _Rows(points)
        self.point_markers = _Rows(() if point_markers is None else point_markers)

    def set_facets(self, facets: Sequence[Any], facet_markers: Optional[Sequence[int]] = None) -> None:
        """Sets segments by the indices of their ends, and their markers."""
        self.facets = _Rows(facets)
        self.facet_markers = _Rows(() if facet_markers is None else facet_markers)

    def set_holes(self, hole_starts: Sequence[Any]) -> None:
        """Sets a place in each hole."""
        self.holes = _Rows(hole_starts)


def build(mesh_info: MeshInfo, verbose: bool = False,
          refinement_func: Optional[Refinement] = None,
          attributes: bool = False, volume_constraints: bool = False, max_volume: Optional[float] = None,
          allow_boundary_steiner: bool = True, allow_volume_steiner: bool = True, quality_meshing: bool = True,
          generate_edges: Optional[bool] = None, generate_faces: bool = False, min_angle: Optional[float] = None,
          mesh_order: Optional[int] = None, generate_neighbor_lists: bool = False) -> MeshInfo:
    """Meshes what segments of `mesh_info` enclose, but holes.

    Parameters
    ----------
    refinement_func : callable, optional
        Whether to refine a triangle, of its corners [(x, y), (x, y), (x, y)] and its area. Called several times
        for each: `size` of `quadtree_mesh.mesh` is faster.
    attributes : bool
        Whether triangles have the attributes of regions.
    volume_constraints : bool
        Whether regions bound areas.
    max_volume : float, optional
        The largest area of a triangle.
    allow_boundary_steiner : bool
        Whether the boundary may get new vertices.
    min_angle : float, optional
        In degrees, 20 by default, at most 34; only with `quality_meshing`.
    generate_faces : bool
        Whether edges are returned; `generate_edges` is the same.
    generate_neighbor_lists : bool
        Whether neighbors are returned.
    mesh_order : 1 or 2
        Triangles of three nodes, or of six: behind the corners are the nodes in the middle of the sides opposite to
        them.

    Raises
    ------
    quadtree_mesh.GraphError
        (a ValueError) For what cannot be meshed; segments that cross are split.
    ValueError
        For ``allow_volume_steiner=False``, which is not supported.
    """
    if not allow_volume_steiner:
        raise ValueError('new vertices inside cannot be forbidden')
    if mesh_order not in (None, 1, 2):
        raise ValueError('mesh_order must be 1 or 2')
    regions = np.array(list(mesh_info.regions), float).reshape(-1, 4)
    regions[:, 3] = np.maximum(regions[:, 3], 0) if volume_constraints else 0
    made = _mesh(vertices=mesh_info.points, segments=mesh_info.facets, holes=mesh_info.holes, regions=regions,
                 vertex_markers=mesh_info.point_markers if len(mesh_info.point_markers) else None,
                 segment_markers=mesh_info.facet_markers if len(mesh_info.facet_markers) else None,
                 min_angle=(20 if min_angle is None else min_angle) if quality_meshing else 0,
                 max_area=max_volume, repair=True,
                 keep_borders='none' if allow_boundary_steiner else 'boundary',
                 refine_where=None if refinement_func is None else _criterion(refinement_func)).compacted()
    return _info_of(made, attributes, bool(generate_edges) or generate_faces, generate_neighbor_lists, mesh_order == 2)


def _criterion(function: Refinement) -> Callable[[np.ndarray], bool]:
    """MeshPy's function of corners and area as one of corners."""
    def refine_where(corners: np.ndarray) -> bool:
        (ax, ay), (bx, by), (cx, cy) = corners.tolist()
        area = ((bx - ax) * (cy - ay) - (cx - ax) * (by - ay)) / 2
        return function([(ax, ay), (bx, by), (cx, cy)], area)

    return refine_where


def _info_of(made: Any, attributes: bool, has_faces: bool, has_neighbors: bool, has_six_nodes: bool) -> MeshInfo:
    info = MeshInfo()
    info.points, info.point_markers = made.vertices, made.vertex_markers
    info.elements = made.triangles
    border = _border_edges(made.triangles, made.neighbors)
    on_border = _is_among(made.segments, border)
    info.facets = np.ascontiguousarray(made.segments)
    info.facet_markers = np.where((made.segment_markers == 0) & on_border, 1, made.segment_markers).astype(np.int32)
    if has_six_nodes:
        info.points, info.elements, info.point_markers = _six_nodes(made, info.facet_markers, border)
    if attributes:
        info.element_attributes = made.values_of_triangles(missing=0.0)
    if has_neighbors:
        info.neighbors = made.neighbors
    if has_faces:
        info.faces = made.edges()
        info.face_markers = _edge_markers(info.faces, made.segments, info.facet_markers)
    return info


def subdivide_facets(subdivisions: Union[int, Sequence[int]], points: Sequence[Any], facets: Sequence[Any],
                     facet_markers: Optional[Sequence[int]] = None) -> Tuple[list, ...]:
    """Splits each segment into so many equal pieces. Returns points, segments and, if there are any, markers."""
    counts = np.broadcast_to(subdivisions, len(facets))
    new_points: list = [tuple(p) for p in points]
    new_facets: list = []
    new_markers: list = []
    for i, ((a, b), count) in enumerate(zip(facets, counts)):
        p, q = np.asarray(points[a], float), np.asarray(points[b], float)
        chain = [a]
        for j in range(1, int(count)):
            chain.append(len(new_points))
            new_points.append(tuple(p + (q - p) * (j / count)))
        chain.append(b)
        new_facets += list(zip(chain, chain[1:]))
        if facet_markers is not None:
            new_markers += [facet_markers[i]] * (len(chain) - 1)
    return (new_points, new_facets) if facet_markers is None else (new_points, new_facets, new_markers)
