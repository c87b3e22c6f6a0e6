"""Balanced quadtrees of points."""

from __future__ import annotations

import operator
import sys
from typing import Any, Tuple

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arguments import point_array, size_list, word

__all__ = ['Quadtree']


class Quadtree:
    """The smallest quadtree that separates points and is balanced, by Bern, Eppstein and Teng.

    Neighboring leaves differ by at most a factor of two in size. Leaves are numbered in shuffle order (Morton order).
    Takes O(n + k) time for n points and k squares, not counting sorting, with all threads.

    Parameters
    ----------
    points : (n, 2) array of float
        Equal points count once.
    max_points_per_leaf : int
        At least 1.
    balance : 'corners', 'sides' or 'none'
        Which neighbors may differ by at most a factor of two: across sides and corners, across sides, or none.
    size : SizeGrid, SizePoints, float or a list of these, optional
        The longest side wanted of a leaf with its center at a place, in the units of the points. Of several the least
        counts.

    Attributes
    ----------
    boxes : (k, 4) array of float64
        The leaves: x and y of the lower left corner, then of the upper right one.
    levels : (k,) array of int32
        The levels of the leaves; 0 is the root's, and each level has half the side.
    depth : int
        The level of the smallest leaves.
    leaves_of_points : (n,) array of int32
        The leaf of each point.

    Raises
    ------
    PointError
        If a coordinate is not a finite number, or two points are too near to each other for double precision.
    """

    def __init__(self, points: ArrayLike, *, max_points_per_leaf: int = 1, balance: str = 'corners',
                 size: Any = None) -> None:
        if max_points_per_leaf < 1:
            raise ValueError('max_points_per_leaf must be at least 1')
        most = min(operator.index(max_points_per_leaf), sys.maxsize)
        self._tree = _core.Quadtree(point_array(points), most, word(balance, 'balance'), size_list(size))
        self.boxes = self._tree.boxes()
        self.levels = self._tree.levels()
        self.depth = self._tree.depth()
        self.leaves_of_points = self._tree.leaves_of_points()

    def __len__(self) -> int:
        """The number of leaves."""
        return len(self.boxes)

    def __repr__(self) -> str:
        return f'<Quadtree: {len(self)} leaves, {len(self.leaves_of_points)} points, depth {self.depth}>'

    def neighbors(self) -> Tuple[np.ndarray, np.ndarray]:
        """The leaves that share a part of a side or a corner with each leaf, counterclockwise from the east.

        Returns
        -------
        begin : (k + 1,) array of int64
        leaves : array of int32
            The neighbors of leaf ``i`` are ``leaves[begin[i]:begin[i + 1]]``: ``scipy.sparse.csr_array`` takes both.
        """
        return self._tree.neighbors()

    def locate(self, points: ArrayLike) -> np.ndarray:
        """The leaves that contain points, an (n,) array of int32; -1 for points outside the root."""
        return self._tree.locate(point_array(points))

    def near_neighbors(self) -> np.ndarray:
        """For each point another one, an (n,) array of int32; -1 if there is none.

        It is at most 1.6284 times as far as the nearest one. For points at one place it is the same. Needs
        ``balance='corners'``.
        """
        return self._tree.near_neighbors()

    def is_valid(self) -> bool:
        """Checks links, balance and the leaves of points, in O(n + k) time."""
        return self._tree.is_valid()

    def plot(self, ax: Any = None, **kwargs: Any) -> Any:
        """Draws the leaves by matplotlib; `kwargs` go to `matplotlib.collections.LineCollection`. Returns the Axes."""
        import matplotlib.pyplot as plt
        from matplotlib.collections import LineCollection

        ax = plt.gca() if ax is None else ax
        corners = self.boxes[:, [0, 1, 2, 1, 2, 3, 0, 3, 0, 1]].reshape(-1, 5, 2)
        ax.add_collection(LineCollection(corners, **(dict(linewidths=0.4, colors='tab:blue') | kwargs)))
        ax.autoscale_view()
        ax.set_aspect('equal')
        return ax
