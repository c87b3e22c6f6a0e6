"""Meshes and reports: what `mesh()` and `mesh_points()` return."""

from __future__ import annotations

import os
from typing import Any, Dict, Optional, Union

import numpy as np

from . import _core

__all__ = ['Mesh', 'Report']

_UNMET = np.dtype([('triangle', np.int32), ('x', float), ('y', float), ('angle', float), ('reason', 'U12'),
                   ('segment', np.int32), ('greatest_angle', float)])
_UNMET_OF_POINTS = np.dtype([('triangle', np.int32), ('x', float), ('y', float)])
_EXEMPT = np.dtype([('triangle', np.int32), ('corner', np.int32)])


class Report:
    """What a mesher reached. It is true if every triangle meets all bounds or is exempt.

    Attributes
    ----------
    is_met : bool
        Whether every triangle meets all bounds or is exempt: ``bool(report)``.
    is_cancelled : bool
        Whether the progress function stopped the work.
    vertices, triangles : int
        The numbers of vertices that a triangle uses, and of triangles.
    unmet : structured array
        The triangles that miss a bound: ``triangle``, centroid ``x`` and ``y``, and for graphs the least ``angle`` in
        degrees, the ``reason``: 'budget', 'cancelled', 'min_edge', 'kept_segment', 'corner', 'max_angle',
        'coordinates' or 'criteria', the ``segment`` that is in the way because of `keep_borders`, else -1, and the
        ``greatest_angle``.
    seconds, wall_seconds : dict of str to float
        Time of each phase: of processors, and by the clock.

    Of graphs also:

    exempt : structured array
        The triangles below the bound in acute corners of the input: ``triangle``, and the input vertex ``corner``.
    is_budget_exhausted : bool
        Whether `max_vertices` or `max_steiner` stopped refinement.
    encroached_edges : int
        With `conforming`, the edges on segments that could not be made Delaunay.
    merged_vertices, vertices_on_segments : int
        Input vertices at the place of an earlier one, and those inside segments.
    estimated_triangles : float
        The number of triangles, estimated before refinement.
    has_used_quadtrees : bool
        Whether the construction by quadtrees (Theorem 5) was used.
    least_angle_histogram : (60,) array of int
        ``[i]`` triangles have their least angle in [i, i + 1) degrees.
    largest_angle_histogram : (120,) array of int
        ``[i]`` triangles have their largest angle in [60 + i, 61 + i) degrees.
    projection : dict or None
        Of a graph in degrees that was projected: the ``name`` of the projection, its ``central_longitude`` and two
        ``standard_parallels``; ``split_vertices``, by which long segments were split before, as they bend; how many
        ``rounds`` of meshing there were; and ``bent_triangles``, still below the bound because a segment bends.
    repair : dict or None
        What was repaired, if segments crossed: numbers of ``crossings``, ``split_segments``, ``overlapping_segments``,
        ``zero_length_segments``, ``merged_vertices``; ``vertex_map``, for each input vertex its index; and
        ``segment_origins``, for each segment of the repaired graph the input segment it is part of.

    Of point sets also:

    merged_points, clusters, thin_triangles, triangles_before_coarsening : int
        Points at the place of an earlier one; clusters with a quadtree of their own; with 'acute', triangles with an
        angle between 89.5 and 90 degrees; triangles before vertices were removed.
    least_angle, largest_angle : float
        Of all triangles, in degrees.
    """

    is_met: bool
    is_cancelled: bool
    vertices: int
    triangles: int
    unmet: np.ndarray
    exempt: np.ndarray
    seconds: Dict[str, float]
    wall_seconds: Dict[str, float]

    def __init__(self, values: Dict[str, Any]) -> None:
        self.__dict__.update(values)
        is_of_graph = 'exempt' in values
        self.unmet = np.array(values['unmet'], dtype=_UNMET if is_of_graph else _UNMET_OF_POINTS)
        if is_of_graph:
            self.exempt = np.array(values['exempt'], dtype=_EXEMPT)

    def __bool__(self) -> bool:
        return self.is_met

    def __repr__(self) -> str:
        texts = [f'{self.triangles} triangles', f'{self.vertices} vertices', f'{len(self.unmet)} unmet']
        if hasattr(self, 'exempt'):
            texts.append(f'{len(self.exempt)} exempt')
        return f'<Report: {", ".join(texts)}>'


class Mesh:
    """A triangle mesh in arrays, which are views of the mesher's memory.

    The first `number_of_input_vertices` vertices are those of the input, in their order and with their coordinates bit
    for bit. Only in a mesh by `refine()` or `adapt()` of arrays they may be anywhere, as `is_input` tells. Triangles are counterclockwise, and side ``k`` of a triangle is opposite its vertex ``k``.

    Attributes
    ----------
    vertices : (n, 2) array of float64
        In the units of the input. Input vertices that no triangle uses are among them; see `compacted()`.
    triangles : (t, 3) array of int32
        Indices of vertices.
    neighbors : (t, 3) array of int32
        ``neighbors[i, k]`` is the triangle across side ``k`` of triangle ``i``, or -1.
    segments : (s, 2) array of int32
        The edges on input segments. On the border the domain is on their left.
    segment_origins : (s,) array of int32
        The input segment that each of these is part of.
    segment_markers : (s,) array of int32
        The marker of that segment, 0 for none.
    regions : (t,) array of int32
        The region of each triangle: a row of `region_values`, or -1.
    region_values : (r,) array
        What the input has for each region: the attributes of `regions`, or a column of the data frame.
    vertex_markers : (n,) array of int32
        An input vertex keeps its marker. One without gets the first marker of segments there, or else 1 on the border.
    vertex_segments : (n,) array of int32
        The input segment on which a new vertex lies, or -1.
    number_of_input_vertices : int
        How many of the vertices are from the input.
    report : Report
        What was reached.
    crs : object
        The coordinate reference system of the data frame, or None.
    places : (n, 2) array of float64, or None
        If the graph was projected, the vertices in the plane of the projection, in meters.
    scales : (n,) array of float64, or None
        Likewise how many meters of the plane a meter on the ground is at each vertex.
    old_vertices : (n,) array of int32, or None
        Of a mesh by `refine()` or `adapt()`: the vertex of the old mesh that each vertex is, or -1.
    sources, weights : (n, 3) arrays of int32 and float64, or None
        Likewise three vertices of the old mesh, whose values each vertex gets with these weights; see `carry_over()`.
    """

    vertices: np.ndarray
    triangles: np.ndarray
    neighbors: np.ndarray
    segments: np.ndarray
    segment_origins: np.ndarray
    segment_markers: np.ndarray
    regions: np.ndarray
    region_values: np.ndarray
    vertex_markers: np.ndarray
    vertex_segments: np.ndarray
    number_of_input_vertices: int
    report: Report
    crs: Any
    places: Optional[np.ndarray]
    scales: Optional[np.ndarray]
    old_vertices: Optional[np.ndarray]
    sources: Optional[np.ndarray]
    weights: Optional[np.ndarray]

    def __init__(self, values: Dict[str, Any], *, region_values: Optional[np.ndarray] = None, crs: Any = None) -> None:
        self.vertices = values['vertices']
        self.triangles = values['triangles']
        self.neighbors = values['neighbors']
        n, t = len(self.vertices), len(self.triangles)
        self.segments = values.get('segments', np.empty((0, 2), np.int32))
        self.segment_origins = values.get('segment_origins', np.empty(0, np.int32))
        self.segment_markers = values.get('segment_markers', np.empty(0, np.int32))
        self.regions = values['regions'] if 'regions' in values else np.full(t, -1, np.int32)
        self.region_values = np.empty(0) if region_values is None else region_values
        self.vertex_markers = values['vertex_markers'] if 'vertex_markers' in values else np.zeros(n, np.int32)
        self.vertex_segments = values['vertex_segments'] if 'vertex_segments' in values else np.full(n, -1, np.int32)
        self.number_of_input_vertices = values['number_of_input_vertices']
        self.report = values['report']
        self.crs = crs
        self.places, self.scales = values.get('places'), values.get('scales')
        self.old_vertices = values.get('old_vertices')
        self.sources, self.weights = values.get('sources'), values.get('weights')
        self._number_of_old_vertices = values.get('number_of_old_vertices')
        self._is_input = values.get('is_input')

    def __repr__(self) -> str:
        unmet = len(self.report.unmet)
        return (f'<Mesh: {len(self.triangles)} triangles, {len(self.vertices)} vertices'
                f'{f", {unmet} unmet" if unmet else ""}>')

    def _in_plane(self) -> np.ndarray:
        """Where lengths are measured."""
        return self.vertices if self.places is None else self.places

    def carry_over(self, values: Any) -> np.ndarray:
        """Values at the vertices of the old mesh, for those of this one, linear in each old triangle.

        A vertex of the old mesh keeps its value bit for bit.

        Parameters
        ----------
        values : (m,) or (m, ...) array
            One for each vertex of the mesh that `refine()` or `adapt()` got.

        Raises
        ------
        ValueError
            If there are more or fewer values, or the mesh is not one by `refine()` or `adapt()`.
        """
        if self.sources is None or self.weights is None:
            raise ValueError('only a mesh by refine() or adapt() has an old mesh')
        given = np.asarray(values, float)
        if given.ndim == 0 or len(given) != self._number_of_old_vertices:
            raise ValueError(f'values must have {self._number_of_old_vertices} rows, one for each vertex of the old mesh, '
                             f'not {len(given) if given.ndim > 0 else "a single number"}')
        return np.einsum('nk,nk...->n...', self.weights, given[self.sources])

    @property
    def is_input(self) -> np.ndarray:
        """Whether each vertex is one of the input, a (n,) array of bool. Others may be left out by `adapt()`."""
        if self._is_input is not None:
            return self._is_input
        return np.arange(len(self.vertices)) < self.number_of_input_vertices

    def values_of_triangles(self, missing: Any = np.nan) -> np.ndarray:
        """The region's value for each triangle, a (t,) array; `missing` for triangles without a region."""
        if len(self.region_values) == 0:
            return np.full(len(self.triangles), missing)
        values = self.region_values[self.regions]
        outside = self.regions < 0
        if outside.any():
            values = values.astype(np.result_type(values, np.asarray(missing))
                                   if values.dtype != object else object)
            values[outside] = missing
        return values

    def areas(self) -> np.ndarray:
        """The area of each triangle, a (t,) array in squared units of the input.

        If the graph was projected, it is the area on the ground in square meters.
        """
        a, b, c = (self._in_plane()[self.triangles[:, k]] for k in range(3))
        u, v = b - a, c - a
        areas = (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / 2
        return areas if self.scales is None else areas / (self.scales[self.triangles] ** 2).mean(axis=1)

    def angles(self) -> np.ndarray:
        """The angles of each triangle at its vertices, a (t, 3) array in degrees.

        If the graph was projected, these are angles on the ground.
        """
        corners = self._in_plane()[self.triangles]
        result = np.empty(self.triangles.shape)
        for k in range(3):
            u = corners[:, (k + 1) % 3] - corners[:, k]
            v = corners[:, (k + 2) % 3] - corners[:, k]
            result[:, k] = np.arctan2(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0], (u * v).sum(axis=1))
        return np.degrees(result)

    def edges(self) -> np.ndarray:
        """All edges, each once: an (e, 2) array of vertices, the smaller one first, in lexicographic order."""
        sides = np.concatenate([self.triangles[:, [1, 2]], self.triangles[:, [2, 0]], self.triangles[:, [0, 1]]])
        sides.sort(axis=1)
        return np.unique(sides, axis=0)

    def compacted(self) -> 'Mesh':
        """A copy without the vertices that no triangle uses. The others keep their order."""
        is_used = np.zeros(len(self.vertices), bool)
        is_used[self.triangles] = True
        # The places of equal input vertices are those of the first.
        new_index = np.where(is_used, np.cumsum(is_used) - 1, -1).astype(np.int32)
        values = dict(vertices=self.vertices[is_used], triangles=new_index[self.triangles], neighbors=self.neighbors,
                      segments=new_index[self.segments], segment_origins=self.segment_origins,
                      segment_markers=self.segment_markers, regions=self.regions,
                      vertex_markers=self.vertex_markers[is_used], vertex_segments=self.vertex_segments[is_used],
                      number_of_input_vertices=int(is_used[:self.number_of_input_vertices].sum()), report=self.report)
        if self._is_input is not None:
            values.update(is_input=self._is_input[is_used], number_of_input_vertices=int(self._is_input[is_used].sum()))
        if self.places is not None:
            values.update(places=self.places[is_used], scales=self.scales[is_used])
        return Mesh(values, region_values=self.region_values, crs=self.crs)

    def to_meshio(self) -> Any:
        """The mesh for meshio, which writes some thirty formats: ``mesh.to_meshio().write('mesh.vtu')``.

        Cells are triangles, and lines for the edges on input segments. Cell data are ``region`` (-1 for none, and for
        lines) and ``marker`` (0 for triangles); point data are ``marker``. Vertices that no triangle uses are left out.
        Needs the package meshio.
        """
        import meshio

        mesh = self.compacted()
        cells = [('triangle', mesh.triangles), ('line', mesh.segments)]
        region = [mesh.regions, np.full(len(mesh.segments), -1, np.int32)]
        marker = [np.zeros(len(mesh.triangles), np.int32), mesh.segment_markers]
        if len(mesh.segments) == 0:
            cells, region, marker = cells[:1], region[:1], marker[:1]
        return meshio.Mesh(mesh.vertices, [(name, np.ascontiguousarray(cell)) for name, cell in cells],
                           cell_data={'region': region, 'marker': [np.ascontiguousarray(m) for m in marker]},
                           point_data={'marker': mesh.vertex_markers})

    def to_html(self, file: Union[str, os.PathLike], *, title: str = 'mesh', color: Optional[str] = 'angle') -> None:
        """Writes a page that shows the mesh in a browser, with pan and zoom: one file, also of a million triangles.

        The page has a menu of colors with histograms, marks the triangles of `report.unmet`, and tells the angles, the
        size, the region and the vertices of the triangle under the pointer. A mesh that was made in a projection is
        drawn there, with angles and sizes as on the ground, and tells vertices in degrees.

        Parameters
        ----------
        file : path
            Ends in '.html'. It appears when it is complete.
        title : str
            What the page is called.
        color : 'angle', 'largest_angle', 'size', 'region' or None
            What colors stand for at first: the least angle, the largest one, the longest edge, the region, nothing.

        Raises
        ------
        OSError
            If the file cannot be written. An older one is then unchanged.
        """
        is_number = np.issubdtype(self.region_values.dtype, np.number)
        coordinates = None if self.places is None else self.vertices
        arrays = dict(vertices=self._in_plane(), coordinates=coordinates, triangles=self.triangles, segments=self.segments,
                      regions=self.regions if (self.regions >= 0).any() else [],
                      region_values=self.region_values if is_number else [], unmet=self.report.unmet['triangle'])
        _core.write_html(os.fspath(file), arrays, title, color or 'none')

    def to_geopandas(self) -> Any:
        """A GeoDataFrame with a polygon for each triangle, in the mesh's reference system.

        Columns are ``region``, ``value`` (of the region, if there are any) and ``least_angle`` in degrees. Needs the
        packages geopandas and shapely.
        """
        import geopandas
        from shapely.geometry import Polygon

        columns = dict(region=self.regions, least_angle=self.angles().min(axis=1))
        if len(self.region_values) > 0:
            columns['value'] = self.values_of_triangles(missing=None if self.region_values.dtype == object else np.nan)
        polygons = [Polygon(corners) for corners in self.vertices[self.triangles]]
        return geopandas.GeoDataFrame(columns, geometry=polygons, crs=self.crs)

    def plot(self, ax: Any = None, *, color: Any = 'angle', edges: Optional[bool] = None, **kwargs: Any) -> Any:
        """Draws the mesh by matplotlib; in degrees, if it is in these, with the shape that it has on the ground.

        Parameters
        ----------
        ax : matplotlib Axes, optional
            Where to draw; the current ones by default.
        color : 'angle', 'region', 'area', None or (t,) array
            What the colors of triangles show: their least angle in degrees, their region, their area, nothing, or
            numbers of yours.
        edges : bool, optional
            Whether to draw the edges of triangles; by default if there are at most 20 000 triangles.
        **kwargs
            Passed on to `matplotlib.axes.Axes.tripcolor`, or to `triplot` without colors.

        Returns
        -------
        matplotlib Axes
        """
        from .plotting import plot_mesh

        return plot_mesh(self, ax, color=color, edges=edges, **kwargs)
