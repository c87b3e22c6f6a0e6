"""Arguments that users give, as the arrays that the extension module wants, and errors that name them."""

from __future__ import annotations

import numbers
import operator
from typing import Any, Dict, List, Optional

import numpy as np

from ._core import SizeGrid, SizePoints
from .errors import GraphError


def point_array(points: Any, name: str = 'points') -> np.ndarray:
    """An (n, 2) array of float64, row by row. It is the argument itself where it is that already."""
    if np.ma.is_masked(points):
        raise ValueError(f'{name} must not be masked')
    array = np.ascontiguousarray(points, dtype=np.float64)
    if array.size == 0:
        return np.empty((0, 2))
    if array.ndim == 1 and array.size == 2 and name != 'vertices':
        array = array.reshape(1, 2)
    if array.ndim != 2 or array.shape[1] != 2:
        raise ValueError(f'{name} must be an array of shape (n, 2), not {array.shape}')
    return array


def index_array(indices: Any, name: str = 'segments') -> np.ndarray:
    """An (n, 2) array of int64. Floats are accepted if they are whole numbers."""
    array = np.asarray(indices)
    if array.size == 0:
        return np.empty((0, 2), np.int64)
    if array.ndim != 2 or array.shape[1] != 2:
        raise ValueError(f'{name} must be an array of shape (n, 2), not {array.shape}')
    return whole_numbers(array, np.int64, name)


def whole_numbers(array: np.ndarray, dtype: type, name: str) -> np.ndarray:
    """The same numbers as integers of a type. Floats are accepted if they are whole."""
    is_whole = array.dtype.kind in 'iub' or (
        array.dtype.kind == 'f' and np.isfinite(array).all() and (array == np.floor(array)).all())
    if not is_whole:
        raise ValueError(f'{name} must be whole numbers')
    limits = np.iinfo(dtype)
    least, most = array.min(initial=0), array.max(initial=0)
    # Compared as Python's numbers, which have no bounds: those of NumPy would be rounded.
    if int(least) < limits.min or int(most) > limits.max:
        raise ValueError(f'{name} must be whole numbers of up to {limits.bits} bits')
    return np.ascontiguousarray(array, dtype=dtype)


def marker_array(markers: Any, count: int, name: str) -> np.ndarray:
    """An int32 for each of `count` things, or none."""
    if markers is None:
        return np.empty(0, np.int32)
    array = np.ravel(np.asarray(markers))
    if len(array) != count:
        raise GraphError(f'{name} must have {count} numbers, one each, not {len(array)}', 'array_length')
    return whole_numbers(array, np.int32, name)


def region_array(regions: Any) -> np.ndarray:
    """An (r, 4) array: x, y, attribute, largest area. The last two columns may be missing."""
    array = np.asarray([] if regions is None else regions, dtype=np.float64)
    if array.size == 0:
        return np.empty((0, 4))
    if array.ndim == 1:
        array = array.reshape(1, -1)
    if array.ndim != 2 or not 2 <= array.shape[1] <= 4:
        raise ValueError(f'regions must be an array of shape (r, 2), (r, 3) or (r, 4), not {array.shape}')
    result = np.zeros((len(array), 4))
    result[:, :array.shape[1]] = array
    return result


def size_list(size: Any) -> List[Any]:
    """Sizes, of which the least counts."""
    if size is None:
        return []
    sizes = list(size) if isinstance(size, (list, tuple)) else [size]
    for one in sizes:
        if not isinstance(one, (SizeGrid, SizePoints, numbers.Real)):
            hint = ', such as size_grid(function, bounds, spacing)' if callable(one) else ''
            raise TypeError(f'a size must be a SizeGrid, SizePoints or a number{hint}, not {type(one).__name__}')
    return sizes


def length(value: Optional[float]) -> float:
    """None is no bound."""
    return 0.0 if value is None else float(value)


def count(value: Optional[int], name: str) -> int:
    """A number that is not negative, and fits into 31 bits; None is 0."""
    number = 0 if value is None else operator.index(value)
    if number < 0:
        raise ValueError(f'{name} must not be negative')
    if number >= 2**31:
        raise ValueError(f'{name} must be less than 2**31')
    return number


def word(value: str, name: str) -> str:
    """One of the words that the extension module knows; the program's have hyphens."""
    if not isinstance(value, str):
        raise TypeError(f'{name} must be a word, not {type(value).__name__}')
    return value.replace('-', '_')


def callable_or_none(function: Any, name: str) -> Any:
    """The function, where there is one."""
    if function is not None and not callable(function):
        raise TypeError(f'{name} must be a function, not {type(function).__name__}')
    return function


def graph_arrays(vertices: Any, segments: Any, holes: Any, regions: Any, vertex_markers: Any,
                 segment_markers: Any) -> Dict[str, np.ndarray]:
    """The arrays of a graph, checked but for their numbers."""
    result = dict(vertices=point_array(vertices, 'vertices'),
                  segments=index_array([] if segments is None else segments),
                  holes=point_array([] if holes is None else holes, 'holes'),
                  regions=region_array(regions))
    result['vertex_markers'] = marker_array(vertex_markers, len(result['vertices']), 'vertex_markers')
    result['segment_markers'] = marker_array(segment_markers, len(result['segments']), 'segment_markers')
    return result
