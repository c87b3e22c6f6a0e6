"""Graphs from shapely geometries and GeoPandas' frames."""

from __future__ import annotations

import os
import warnings
from typing import Any, Dict, Iterator, List, NamedTuple, Optional, Tuple, Union

import numpy as np

from . import _core
from .errors import DegreesWarning, GraphError

__all__ = ['graph', 'read']

_POINT, _LINE, _OUTER_RING, _INNER_RING = range(4)


class Features(NamedTuple):
    """A graph, and what it is made of."""

    arrays: Dict[str, np.ndarray]
    number_of_geometries: int
    frame: Any  # the data frame, or None
    crs: Any


def _coordinates(ring: Any) -> np.ndarray:
    """Places in x and y; heights are dropped."""
    return np.asarray(ring.coords, dtype=np.float64)[:, :2]


def _parts(geometry: Any) -> Iterator[Tuple[int, np.ndarray]]:
    """The points, lines and rings of a geometry, the inner rings of a polygon after its outer one."""
    if geometry is None or geometry.is_empty:
        return
    kind = geometry.geom_type
    if kind == 'Polygon':
        yield _OUTER_RING, _coordinates(geometry.exterior)
        for ring in geometry.interiors:
            yield _INNER_RING, _coordinates(ring)
    elif kind in ('LineString', 'LinearRing'):
        yield _LINE, _coordinates(geometry)
    elif kind == 'Point':
        yield _POINT, _coordinates(geometry)
    else:  # collections
        for part in geometry.geoms:
            yield from _parts(part)


def _list_of_geometries(geometry: Any) -> Tuple[List[Any], Any, Any]:
    """Geometries, the data frame if it is one, and the reference system."""
    if hasattr(geometry, 'geom_type') and not hasattr(geometry, 'crs'):
        return [geometry], None, None
    if hasattr(geometry, 'geometry') and hasattr(geometry, 'columns'):
        return list(geometry.geometry), geometry, geometry.crs
    if hasattr(geometry, 'crs') and hasattr(geometry, 'values'):
        return list(geometry.values), None, geometry.crs
    if isinstance(geometry, (str, bytes)) or not hasattr(geometry, '__iter__'):
        raise TypeError('geometry must be a shapely geometry, a list of these, a GeoSeries or a GeoDataFrame, not '
                        f'{type(geometry).__name__}; arrays go into vertices and segments')
    geometries = list(geometry)
    for i, one in enumerate(geometries):
        if one is not None and not hasattr(one, 'geom_type'):
            raise TypeError(f'geometry {i} must be a shapely geometry, not {type(one).__name__}')
    return geometries, None, None


def features_of(geometry: Any) -> Features:
    """The graph of geometries. Its regions have the number of the geometry as their attribute."""
    geometries, frame, crs = _list_of_geometries(geometry)
    parts = [(kind, row, xy) for row, one in enumerate(geometries) for kind, xy in _parts(one)]
    if not parts:
        raise GraphError('there are no geometries to mesh', 'no_domain')
    ends = np.cumsum([len(xy) for _, _, xy in parts])
    table = np.array([(kind, row, end) for (kind, row, _), end in zip(parts, ends)], dtype=np.int64)
    arrays = _core.graph_of_features(np.concatenate([xy for _, _, xy in parts]), table)
    return Features(arrays, len(geometries), frame, crs)


def graph(geometry: Any) -> Dict[str, np.ndarray]:
    """The planar straight-line graph of shapely geometries, in arrays that `mesh()` takes: ``mesh(**graph(geometry))``.

    Vertices at one place become one, and a piece of border that two polygons share becomes one segment. What segments
    enclose and no polygon covers gets a hole. Where polygons cover each other the first one counts. O(n log n) time.

    Parameters
    ----------
    geometry : shapely geometry, list of these, GeoSeries or GeoDataFrame
        Polygons make up the domain. Lines become segments, and points vertices. Heights are dropped. Without polygons
        the domain is what lines enclose.

    Returns
    -------
    dict
        ``vertices`` (n, 2), ``segments`` (m, 2), ``holes`` (h, 2), and ``regions`` (r, 4): a point in each component
        that a polygon covers, the number of the polygon's geometry, and 0.

    Raises
    ------
    GraphError
        If a coordinate is not a finite number, or a line or ring has too few places.
    """
    return features_of(geometry).arrays


def read(file: Union[str, os.PathLike], *, region: str = '', marker: str = '') -> Dict[str, np.ndarray]:
    """Reads a graph from a file, in arrays that `mesh()` takes: ``mesh(**read('lakes.poly.gz'))``.

    Parameters
    ----------
    file : str or path
        Triangle's .poly and .poly.gz, .geojson and .json, or .wkt. doc/file_formats.md says what is read. GeoPandas
        reads other formats.
    region : str
        Of GeoJSON: the property, a number, that is the attribute of regions.
    marker : str
        Of GeoJSON: the property, a whole number, that is the marker of lines and of borders of polygons.

    Returns
    -------
    dict
        ``vertices`` (n, 2), ``segments`` (m, 2), ``holes`` (h, 2), ``regions`` (r, 4) and, if there are any,
        ``vertex_markers`` (n,) and ``segment_markers`` (m,). Indices count from 0.

    Raises
    ------
    GraphError
        If the file cannot be read; the text has the line.
    ValueError
        If the name has another ending, or a property has names.
    """
    return _core.read_graph(os.fspath(file), region, marker)


def column(features: Features, values: Any, name: str) -> Optional[np.ndarray]:
    """A value for each geometry: a column of the data frame by its name, or an array; None for a number or None."""
    if isinstance(values, str):
        if features.frame is None:
            raise TypeError(f'{name}={values!r} needs a GeoDataFrame with such a column')
        if values not in features.frame.columns:
            raise ValueError(f'{name}={values!r}: the data frame has no such column')
        return features.frame[values].to_numpy()
    if values is None or np.ndim(values) == 0:
        return None
    array = np.asarray(values)
    if array.shape != (features.number_of_geometries,):
        raise ValueError(f'{name} must have a value for each of {features.number_of_geometries} geometries, not shape '
                         f'{array.shape}')
    return array


def is_geographic(crs: Any) -> bool:
    """Whether coordinates are longitudes and latitudes."""
    return crs is not None and bool(getattr(crs, 'is_geographic', False))


def warn_of_degrees(crs: Any) -> None:
    """Says that angles of the mesh are not those on the ground."""
    warnings.warn(f'coordinates are degrees ({getattr(crs, "name", crs)}): lengths, areas and angles are those of the '
                  "plane of longitude and latitude, not those on the ground, as project='auto' has them",
                  DegreesWarning, stacklevel=4)
