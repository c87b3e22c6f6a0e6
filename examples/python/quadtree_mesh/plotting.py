"""Pictures by matplotlib."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

_MOST_TRIANGLES_WITH_EDGES = 20_000


def _numbers(mesh: Any, color: Any) -> Any:
    """What colors show, a number for each triangle, and its name."""
    if not isinstance(color, str):
        return np.asarray(color), ''
    if color == 'angle':
        return mesh.angles().min(axis=1), 'least angle in degrees'
    if color == 'area':
        return mesh.areas(), 'area'
    if color == 'region':
        values = mesh.values_of_triangles(missing=np.nan) if mesh.region_values.dtype.kind in 'if' else None
        return (mesh.regions, 'region') if values is None or len(mesh.region_values) == 0 else (values, 'region')
    raise ValueError(f"color must be 'angle', 'region', 'area', None or an array, not {color!r}")


def plot_mesh(mesh: Any, ax: Any = None, *, color: Any = 'angle', edges: Optional[bool] = None,
              **kwargs: Any) -> Any:
    """See `Mesh.plot`."""
    import matplotlib.pyplot as plt

    ax = plt.gca() if ax is None else ax
    x, y = mesh.vertices.T
    has_edges = len(mesh.triangles) <= _MOST_TRIANGLES_WITH_EDGES if edges is None else edges
    if color is not None and len(mesh.triangles) > 0:
        numbers, name = _numbers(mesh, color)
        if has_edges:
            kwargs = dict(edgecolors='white', linewidth=0.2) | kwargs
        colors = ax.tripcolor(x, y, mesh.triangles, facecolors=np.asarray(numbers, float), **kwargs)
        ax.figure.colorbar(colors, ax=ax, label=name)
    elif has_edges and len(mesh.triangles) > 0:
        ax.triplot(x, y, mesh.triangles, **(dict(linewidth=0.4) | kwargs))
    plot_segments(ax, mesh.vertices, mesh.segments)
    # A degree of longitude is shorter than one of latitude.
    middle = (y.min() + y.max()) / 2 if len(y) > 0 else 0
    ax.set_aspect('equal' if mesh.places is None else 1 / np.cos(np.radians(middle)))
    return ax


def plot_segments(ax: Any, vertices: np.ndarray, segments: np.ndarray) -> None:
    """Draws segments as thin dark lines."""
    from matplotlib.collections import LineCollection

    ax.add_collection(LineCollection(vertices[segments], colors='black', linewidths=0.5))
    ax.autoscale_view()
