"""Sizes that change from place to place."""

from __future__ import annotations

from typing import Any, Callable, Sequence, Union

import numpy as np

from ._core import SizeGrid, SizePoints

__all__ = ['SizeGrid', 'SizePoints', 'size_grid']


def size_grid(function: Callable[[np.ndarray, np.ndarray], Any], bounds: Sequence[float],
              spacing: Union[float, Sequence[float]]) -> SizeGrid:
    """A function of the place as a `SizeGrid`. The mesher asks for sizes often, and arrays answer faster than Python.

    Parameters
    ----------
    function : callable
        Called once with two (rows, columns) arrays, x and y. Returns an array of that shape, or a number: the longest
        edge wanted there, in the units of the coordinates, positive.
    bounds : (xmin, ymin, xmax, ymax)
        What the grid covers, such as ``geometry.bounds`` of shapely.
    spacing : float or (float, float)
        The distances of neighbors in x and y, positive.
    """
    xmin, ymin, xmax, ymax = map(float, bounds)
    dx, dy = map(float, np.broadcast_to(spacing, 2))
    if not (dx > 0 and dy > 0):
        raise ValueError('the spacing must be positive')
    x = xmin + dx * np.arange(max(int(np.ceil((xmax - xmin) / dx)), 0) + 1)
    y = ymin + dy * np.arange(max(int(np.ceil((ymax - ymin) / dy)), 0) + 1)
    sizes = np.broadcast_to(function(*np.meshgrid(x, y)), (len(y), len(x)))
    return SizeGrid(sizes, (xmin, ymin), (dx, dy))
