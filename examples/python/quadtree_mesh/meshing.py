"""Meshes of graphs, polygons and points."""

from __future__ import annotations

from typing import Any, Callable, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arguments import callable_or_none, count, graph_arrays, length, point_array, size_list, word
from .geometry import column, features_of, is_geographic, warn_of_degrees
from .results import Mesh, Report

__all__ = ['mesh', 'mesh_points']

Progress = Callable[[float], Optional[bool]]


def mesh(geometry: Any = None, *, vertices: Optional[ArrayLike] = None, segments: Optional[ArrayLike] = None,
         holes: Optional[ArrayLike] = None, regions: Optional[ArrayLike] = None,
         vertex_markers: Optional[ArrayLike] = None, segment_markers: Optional[ArrayLike] = None,
         min_angle: float = 20.7, max_area: Any = None, max_edge: Optional[float] = None,
         min_edge: Optional[float] = None, size: Any = None, gradation: Optional[float] = None,
         max_edge_ratio: Optional[float] = None, max_angle: Optional[float] = None, region: Any = None,
         refine_where: Optional[Callable[[np.ndarray], bool]] = None, domain: str = 'enclosed',
         max_vertices: Optional[int] = None, max_steiner: Optional[int] = None, conforming: bool = False,
         keep_borders: str = 'none', smooth: int = 0, thin: int = 0, coarsen: bool = True,
         separation: str = 'on_demand', project: str = 'auto', repair: Optional[bool] = None,
         threads: Optional[int] = None, progress: Optional[Progress] = None) -> Mesh:
    """Meshes polygons, or a planar straight-line graph, by triangles without small angles.

    No triangle has an angle below `min_angle`, except in corners where the input is sharper, and those that
    ``mesh.report.unmet`` lists with the reason. Input vertices keep their coordinates bit for bit. The mesh is the same
    for any number of threads. Expected O(n log n + t) time for t triangles.

    Parameters
    ----------
    geometry : shapely geometry, list of these, GeoSeries or GeoDataFrame, optional
        Polygons make up the domain, and the gaps between them are holes. Lines become segments, and points vertices.
        Heights are dropped. See `graph()`.
    vertices : (n, 2) array of float
        The graph, in place of `geometry`: places in any unit of length. Vertices at one place count as one.
    segments : (m, 2) array of int
        Indices of vertices, from 0.
    holes : (h, 2) array of float
        A point in each component that is not meshed.
    regions : (r, 2), (r, 3) or (r, 4) array of float
        A point in each region; its attribute, free to use; the largest area of a triangle there, 0 for no bound.
    vertex_markers : (n,) array of int
        Free to use, 0 for none.
    segment_markers : (m,) array of int
        Likewise; ``mesh.segment_markers`` has them for the pieces.
    min_angle : float
        In degrees, from 0 to 34. Up to 20.7 it is met wherever coordinates have room, as far as tests show; above it is
        tried. ``mesh.report.unmet`` lists what is left.
    max_area : float, str or array, optional
        The largest area of a triangle, in squared units of the input. With `geometry` also a column of the data frame,
        or an array with a number for each geometry; 0 and not-a-number are no bound.
    max_edge : float, optional
        The longest edge, in the units of the input.
    min_edge : float, optional
        No new vertex is nearer than this to another one in sight. What misses a bound for this reason is reported.
    size : SizeGrid, SizePoints, float or a list of these, optional
        The longest edge wanted at a place. Of several the least counts. `size_grid()` makes a grid of a function.
    gradation : float, optional
        How fast edges grow, at most 1: each edge is at most as long as `max_edge_ratio` times any other one, plus
        `gradation` times the distance between their nearest ends. 0.1 to 0.3 is usual for flow. It does not hold near
        corners sharper than `min_angle`. What misses it is in ``mesh.report.unmet``.
    max_edge_ratio : float, optional
        By which factor edges with a common end may differ; at least 3, which is the default with `gradation`.
    max_angle : float, optional
        The greatest angle wanted, in degrees, at least 105 and below 180. It is tried, after all other bounds, but in
        corners sharper than `min_angle`. What is left is in ``mesh.report.unmet``.
    region : str or array, optional
        With `geometry`: the column of the data frame, or the array, whose values are ``mesh.region_values``. By default
        these are the data frame's index, or the numbers of the geometries. ``mesh.regions`` has the geometry of each
        triangle, the first of those that cover it.
    refine_where : callable, optional
        Whether to refine a triangle that meets all other bounds, of its corners, a (3, 2) array. It must always give
        the same answer. Some 10 microseconds a call, and several calls for each triangle.
    domain : 'enclosed', 'marked' or 'parity'
        What is meshed: all that segments enclose but holes; components with a point of `regions`; components
        behind an odd number of borders, so that islands in holes are meshed without points in holes.
    max_vertices : int, optional
        Refinement stops there, and what is left is reported.
    max_steiner : int, optional
        Likewise, for vertices that are not of the input; it may be 0.
    conforming : bool
        Whether segments are split until all triangles are Delaunay, so that no circumcenter is outside; with
        `project`, in the plane of the projection.
    keep_borders : 'none', 'boundary', 'marked' or 'all'
        Which segments get no vertices: those with the domain on one side only, those whose marker is not 0, or all.
        What misses a bound for this reason is reported, with the segment. Not with a projection, nor with 'theorem_5'.
    smooth, thin : int
        Rounds of smoothing and thinning. Each gives some percent fewer triangles for the time of refinement.
    coarsen : bool
        Whether superfluous new vertices are removed at the end.
    separation : 'on_demand' or 'theorem_5'
        By refinement, or by the quadtrees of Bern, Eppstein and Teng.
    project : 'auto', 'none', 'mercator' or 'lambert'
        The conformal projection in which longitudes and latitudes are meshed, so that angles are those on the ground,
        and lengths and areas are meters and square meters there. The mesh is in degrees. With 'auto', frames whose
        reference system is geographic are projected by what suits their latitudes, and all else is meshed as it is.
        'mercator' and 'lambert' take any input for degrees. Sizes then hold at places in degrees.
    repair : bool, optional
        Whether crossing segments are split, with vertices and segments renumbered; ``mesh.report.repair`` tells how. By
        default so with `geometry`. Without, they are an error.
    threads : int, optional
        At most so many; by default as many as there are.
    progress : callable, optional
        Called some 20 times a second, by the calling thread, with the share of work done, from 0 to 1. If it returns
        False, the mesh so far is returned, and ``mesh.report.is_cancelled`` is set.

    Returns
    -------
    Mesh

    Raises
    ------
    GraphError
        (a ValueError) If the graph cannot be meshed; it has the indices of the vertices or segments at fault.
    ValueError, TypeError
        If an argument is out of its range.
    KeyboardInterrupt
        After Ctrl-C.

    Examples
    --------
    >>> import quadtree_mesh
    >>> m = quadtree_mesh.mesh(vertices=[[0, 0], [1, 0], [1, 1], [0, 1]], segments=[[0, 1], [1, 2], [2, 3], [3, 0]],
    ...                        max_area=0.01, min_angle=25)
    >>> bool(m.report), bool(m.angles().min() >= 25), bool(m.areas().max() <= 0.01)
    (True, True, True)
    """
    if (geometry is None) == (vertices is None):
        raise TypeError('mesh() needs either a geometry or vertices')
    options = dict(min_angle=float(min_angle), max_edge=length(max_edge), min_edge=length(min_edge),
                   gradation=length(gradation), max_edge_ratio=length(max_edge_ratio),
                   max_angle=length(max_angle), size=size_list(size),
                   refine_where=callable_or_none(refine_where, 'refine_where'),
                   domain=word(domain, 'domain'),
                   max_vertices=count(max_vertices, 'max_vertices'),
                   max_steiner=None if max_steiner is None else count(max_steiner, 'max_steiner'),
                   conforming=bool(conforming), keep_borders=word(keep_borders, 'keep_borders'), smooth=count(smooth, 'smooth'),
                   thin=count(thin, 'thin'), coarsen=bool(coarsen), separation=word(separation, 'separation'),
                   threads=count(threads, 'threads'), progress=callable_or_none(progress, 'progress'),
                   project=word(project, 'project'), repair=geometry is not None if repair is None else bool(repair))
    if geometry is not None:
        given = dict(segments=segments, holes=holes, regions=regions, vertex_markers=vertex_markers,
                     segment_markers=segment_markers)
        for name, value in given.items():
            if value is not None:
                raise TypeError(f'{name} goes with vertices, not with a geometry')
        return _mesh_features(geometry, options, max_area, region)
    if region is not None or (max_area is not None and np.ndim(max_area) > 0) or isinstance(max_area, str):
        raise TypeError('values by region go with a geometry; of vertices and segments they are columns of regions')
    if options['project'] == 'auto':
        options['project'] = 'none'
    arrays = graph_arrays(vertices, segments, holes, regions, vertex_markers, segment_markers)
    return _run(arrays, dict(options, max_area=length(max_area)), arrays['regions'][:, 2])


def _mesh_features(geometry: Any, options: dict, max_area: Any, region: Any) -> Mesh:
    features = features_of(geometry)
    are_degrees = is_geographic(features.crs)
    if are_degrees and options['project'] == 'none':
        warn_of_degrees(features.crs)
    if not are_degrees and options['project'] == 'auto':
        options = dict(options, project='none')
    arrays = dict(features.arrays, vertex_markers=np.empty(0, np.int32), segment_markers=np.empty(0, np.int32))
    rows = arrays['regions'][:, 2].astype(np.intp)
    areas = column(features, max_area, 'max_area')
    if areas is not None:
        areas = areas.astype(float)
        if (areas < 0).any():
            raise ValueError('the largest area must not be negative')
        arrays['regions'][:, 3] = np.nan_to_num(areas[rows])
    values = column(features, region, 'region')
    if values is None:
        if region is not None:
            raise TypeError('region must be the name of a column, or an array')
        values = features.frame.index.to_numpy() if features.frame is not None else \
            np.arange(features.number_of_geometries)
    result = _run(arrays, dict(options, max_area=length(max_area if areas is None else None)), values, features.crs)
    # The regions of components become those of geometries.
    result.regions[:] = np.append(rows, -1)[result.regions]
    return result


def _run(arrays: dict, options: dict, region_values: np.ndarray, crs: Any = None) -> Mesh:
    values = _core.mesh_graph(arrays, options)
    values['report'] = Report(dict(values['report'], repair=values.pop('repair')))
    result = Mesh(values, region_values=region_values, crs=crs)
    if result.places is not None:
        unmet = result.report.unmet
        centroids = result.vertices[result.triangles[unmet['triangle']]].mean(axis=1)
        unmet['x'], unmet['y'] = centroids[:, 0], centroids[:, 1]
    return result


def mesh_points(points: ArrayLike, *, angles: Union[str, Tuple[float, float]] = (36, 80), domain: str = 'row',
                effort: int = 2, threads: Optional[int] = None, progress: Optional[Progress] = None) -> Mesh:
    """Meshes points so that all angles are in a range, or all are acute.

    Every point is a vertex, with its coordinates bit for bit; equal points count once. The mesh covers squares or a box
    around the points. Expected O(n log n + t) time for t triangles.

    Parameters
    ----------
    points : (n, 2) array of float
        In any unit of length.
    angles : (float, float), 'acute', 'least' or 'warped'
        The least angle, up to 37.5, and the largest, from 78.6 to 89.5 degrees; or all angles below 90 degrees, by O(n)
        triangles; or all at least 20.7 degrees, with the fewest triangles; or the classical construction by squares,
        with angles from 22.47 to 112.63 degrees.
    domain : 'row' or 'square'
        With a range of angles: a row of squares along the points, or a square.
    effort : int
        How much work goes into removing vertices, from 0 to 3.
    threads : int, optional
        At most so many; by default as many as there are.
    progress : callable, optional
        As for `mesh()`. After it returns False no more vertices are removed; the mesh is valid, but larger.

    Returns
    -------
    Mesh

    Raises
    ------
    PointError
        (a ValueError) If a coordinate is not a finite number, or two points are too near to each other.
    KeyboardInterrupt
        After Ctrl-C.
    """
    least, largest = 36.0, 80.0
    mode = angles
    if not isinstance(angles, str):
        mode = 'bounded'
        least, largest = map(float, angles)
    elif mode == 'bounded':
        mode = ''
    options = dict(mode=mode, least=least, largest=largest, domain=word(domain, 'domain'),
                   effort=count(effort, 'effort'), threads=count(threads, 'threads'),
                   progress=callable_or_none(progress, 'progress'))
    values = _core.mesh_points(point_array(points), options)
    values['report'] = Report(values['report'])
    return Mesh(values)
