"""Meshes that exist, refined, or adapted to sizes."""

from __future__ import annotations

from typing import Any, Callable, Dict, Mapping, Optional

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arguments import callable_or_none, count, index_array, length, marker_array, point_array, size_list, \
    whole_numbers, word
from .errors import GraphError
from .results import Mesh, Report

__all__ = ['refine', 'adapt']


def refine(mesh: Any, *, areas: Optional[ArrayLike] = None, min_angle: float = 20.7, max_area: Optional[float] = None,
           max_edge: Optional[float] = None, min_edge: Optional[float] = None, size: Any = None,
           gradation: Optional[float] = None, max_edge_ratio: Optional[float] = None,
           max_angle: Optional[float] = None, refine_where: Optional[Callable[[np.ndarray], bool]] = None,
           max_vertices: Optional[int] = None, max_steiner: Optional[int] = None, conforming: bool = False,
           keep_borders: str = 'none', threads: Optional[int] = None,
           progress: Optional[Callable[[float], Optional[bool]]] = None) -> Mesh:
    """Inserts vertices into a mesh until its triangles meet the bounds.

    Its own vertices stay, bit for bit and in order. Only those on two segments at a corner sharper than `min_angle`, in
    triangles between the two, are placed anew, mostly where they were.

    Parameters
    ----------
    mesh : Mesh, or dict
        A mesh by this package; or ``vertices`` (n, 2) and ``triangles`` (t, 3), counterclockwise, of any origin, and
        optionally ``segments`` (s, 2), which are sides of triangles, ``segment_markers`` (s,), ``vertex_markers`` (n,)
        and ``triangle_attributes`` (t,). The border is a segment in any case, and so are edges between attributes.
        Triangles may meet without common vertices: of vertices at one place the first one is used, and a triangle with
        a vertex in the middle of a side is cut there. Such edges are segments, too.
    areas : (t,) array of float, optional
        For each triangle of the mesh the largest area of a new triangle with its centroid in it; no bound where it is
        not positive.
    min_angle, max_area, max_edge, min_edge, size, gradation, max_edge_ratio, max_angle, refine_where, max_vertices
        As for `mesh()`.
    max_steiner, conforming, keep_borders, threads, progress
        Likewise.

    Returns
    -------
    Mesh
        With ``old_vertices``, and `Mesh.carry_over()` for values at vertices.

    Raises
    ------
    GraphError
        (a ValueError) If triangles are clockwise, overlap, or name vertices that do not exist: ``kind`` is
        'invalid_mesh', and it has their indices. Or if arrays have a wrong length. Or if `areas` ask for a mesh beyond
        the memory or `max_vertices`: ``kind`` is 'too_many_triangles', with the triangle that asks for most.
    TypeError
        If `mesh` is neither a Mesh nor a dict.

    Examples
    --------
    >>> import quadtree_mesh
    >>> square = dict(vertices=[[0, 0], [1, 0], [1, 1], [0, 1]], triangles=[[0, 1, 2], [0, 2, 3]])
    >>> m = quadtree_mesh.refine(square, areas=[0.01, -1])
    >>> m.old_vertices[:5].tolist()
    [0, 1, 2, 3, -1]
    """
    arrays = _arrays(mesh)
    arrays['areas'] = _numbers(areas, len(arrays['triangles']), 'areas')
    return _run(mesh, arrays, _options(
        min_angle=min_angle, max_area=max_area, max_edge=max_edge, min_edge=min_edge, size=size, gradation=gradation,
        max_edge_ratio=max_edge_ratio, max_angle=max_angle, refine_where=refine_where, max_vertices=max_vertices,
        max_steiner=max_steiner, conforming=conforming, keep_borders=keep_borders, threads=threads, progress=progress,
        coarsens=False))


def adapt(mesh: Any, *, sizes: Optional[ArrayLike] = None, min_angle: float = 20.7, max_area: Optional[float] = None,
          max_edge: Optional[float] = None, min_edge: Optional[float] = None, size: Any = None,
          gradation: Optional[float] = None, max_edge_ratio: Optional[float] = None,
          max_angle: Optional[float] = None, refine_where: Optional[Callable[[np.ndarray], bool]] = None,
          max_vertices: Optional[int] = None, keep_borders: str = 'none', threads: Optional[int] = None,
          progress: Optional[Callable[[float], Optional[bool]]] = None) -> Mesh:
    """Refines a mesh where triangles miss the bounds, and coarsens it where they are needlessly small.

    Vertices stay, bit for bit and in order, where a mesh made afresh would have triangles of about the same size.

    Parameters
    ----------
    mesh : Mesh, or dict
        As for `refine()`. Of a dict the vertices inside of attributes and of straight segments may go.
    sizes : (n,) array of float, optional
        The longest edge wanted at each vertex of the mesh, linear between them.
    min_angle, max_area, max_edge, min_edge, size, gradation, max_edge_ratio, max_angle, refine_where, max_vertices
        As for `mesh()`.
    keep_borders, threads, progress
        Likewise.

    Returns
    -------
    Mesh
        With ``old_vertices``, and `Mesh.carry_over()` for values at vertices.

    Raises
    ------
    GraphError, ValueError, TypeError
        As for `refine()`; and a ValueError that names the first vertex whose size is not positive.

    Examples
    --------
    >>> import quadtree_mesh
    >>> fine = quadtree_mesh.mesh(vertices=[[0, 0], [1, 0], [1, 1], [0, 1]],
    ...                           segments=[[0, 1], [1, 2], [2, 3], [3, 0]], max_edge=0.05)
    >>> m = quadtree_mesh.adapt(fine, sizes=0.05 + 0.5 * fine.vertices[:, 0])
    >>> values = m.carry_over(fine.vertices[:, 0])
    >>> bool(abs(values - m.vertices[:, 0]).max() < 1e-12), len(m.vertices) < len(fine.vertices)
    (True, True)
    """
    arrays = _arrays(mesh)
    arrays['sizes'] = _numbers(sizes, len(arrays['vertices']), 'sizes')
    if not isinstance(mesh, Mesh):
        arrays['vertices_may_go'] = True
    return _run(mesh, arrays, _options(
        min_angle=min_angle, max_area=max_area, max_edge=max_edge, min_edge=min_edge, size=size, gradation=gradation,
        max_edge_ratio=max_edge_ratio, max_angle=max_angle, refine_where=refine_where, max_vertices=max_vertices,
        max_steiner=None, conforming=False, keep_borders=keep_borders, threads=threads, progress=progress,
        coarsens=True))


def _numbers(values: Optional[ArrayLike], wanted: int, name: str) -> np.ndarray:
    """One number each, or none."""
    if values is None:
        return np.empty(0)
    array = np.ravel(np.asarray(values, float))
    if len(array) != wanted:
        raise GraphError(f'{name} must have {wanted} numbers, one each, not {len(array)}', 'array_length')
    return array


def _options(*, min_angle: float, max_area: Any, max_edge: Any, min_edge: Any, size: Any, gradation: Any,
             max_edge_ratio: Any, max_angle: Any, refine_where: Any, max_vertices: Any, max_steiner: Any, conforming: bool,
             keep_borders: str, threads: Any, progress: Any, coarsens: bool) -> Dict[str, Any]:
    return dict(min_angle=float(min_angle), max_area=length(max_area), max_edge=length(max_edge),
                min_edge=length(min_edge), gradation=length(gradation), max_edge_ratio=length(max_edge_ratio),
                max_angle=length(max_angle), size=size_list(size),
                refine_where=callable_or_none(refine_where, 'refine_where'), domain='enclosed',
                max_vertices=count(max_vertices, 'max_vertices'),
                max_steiner=None if max_steiner is None else count(max_steiner, 'max_steiner'),
                conforming=bool(conforming), keep_borders=word(keep_borders, 'keep_borders'), smooth=0, thin=0,
                coarsen=True, separation='on_demand', threads=count(threads, 'threads'),
                progress=callable_or_none(progress, 'progress'), coarsens=coarsens)


def _arrays(mesh: Any) -> Dict[str, Any]:
    """What the extension module wants to know of a mesh."""
    result: Dict[str, Any] = dict(areas=np.empty(0), sizes=np.empty(0), vertices_may_go=False)
    if isinstance(mesh, Mesh):
        if mesh.places is not None:
            raise ValueError('a mesh in degrees cannot be refined: bring the data into a projected system first, '
                             'for example by to_crs() of GeoPandas, and mesh them again')
        if len(mesh.segments) == 0:  # a mesh of points
            return _arrays(dict(vertices=mesh.vertices, triangles=mesh.triangles))
        has_regions = (mesh.regions >= 0).any()
        return dict(result, vertices=mesh.vertices, triangles=mesh.triangles, segments=mesh.segments,
                    segment_markers=mesh.segment_markers, segment_origins=mesh.segment_origins,
                    vertex_markers=mesh.vertex_markers, is_input=mesh.is_input.astype(np.int8),
                    attributes=mesh.regions.astype(float) if has_regions else np.empty(0))
    if not isinstance(mesh, Mapping):
        raise TypeError(f'mesh must be a Mesh or a dict with vertices and triangles, not {type(mesh).__name__}')
    for name in ('vertices', 'triangles'):
        if name not in mesh:
            raise ValueError(f'mesh has no {name}')
    vertices = point_array(mesh['vertices'], 'vertices')
    triangles = np.asarray(mesh['triangles'])
    if triangles.ndim != 2 or triangles.shape[1] != 3:
        raise ValueError(f'triangles must be an array of shape (t, 3), not {triangles.shape}')
    segments = index_array(mesh.get('segments', []))
    attributes = mesh.get('triangle_attributes')
    return dict(result, vertices=vertices, triangles=whole_numbers(triangles, np.int64, 'triangles'), segments=segments,
                segment_markers=marker_array(mesh.get('segment_markers'), len(segments), 'segment_markers'),
                segment_origins=np.arange(len(segments), dtype=np.int32),
                vertex_markers=marker_array(mesh.get('vertex_markers'), len(vertices), 'vertex_markers'),
                is_input=np.empty(0, np.int8),
                attributes=_numbers(attributes, len(triangles), 'triangle_attributes'))


def _run(mesh: Any, arrays: Dict[str, Any], options: Dict[str, Any]) -> Mesh:
    is_mesh = isinstance(mesh, Mesh)
    region_values = mesh.region_values if is_mesh else np.empty(0)
    crs = mesh.crs if is_mesh else None
    if not is_mesh and len(arrays['attributes']) > 0:
        region_values, numbers = np.unique(arrays['attributes'], return_inverse=True)
        arrays = dict(arrays, attributes=numbers.reshape(-1).astype(float))
    values = _core.adapt_mesh(arrays, options)
    values['report'] = Report(dict(values['report'], repair=None))
    values['number_of_old_vertices'] = len(arrays['vertices'])
    return Mesh(values, region_values=region_values, crs=crs)
