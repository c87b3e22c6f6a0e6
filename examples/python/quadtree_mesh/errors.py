"""What is raised for input that cannot be meshed: kinds of ValueError, with the indices of what is at fault."""

from __future__ import annotations

from typing import Sequence

__all__ = ['MeshingError', 'GraphError', 'PointError', 'DegreesWarning']


class MeshingError(ValueError):
    """Input that cannot be meshed.

    Attributes
    ----------
    kind : str
        What is wrong, in a word for programs: see `GraphError` and `PointError`.
    """

    kind: str

    def __init__(self, text: str, kind: str = '') -> None:
        super().__init__(text)
        self.kind = kind


class GraphError(MeshingError):
    """A graph that cannot be meshed. Indices count from 0, in the order in which the text names them.

    Attributes
    ----------
    kind : str
        'unreadable', 'array_length', 'no_such_vertex', 'not_finite', 'out_of_range', 'no_area', 'zero_length',
        'crossing', 'too_near', 'ambiguous_seed', 'no_domain', 'too_many_triangles',
        'invalid_mesh' (what is to be refined) or 'rounding'.
    vertices, segments, holes, regions, triangles : list of int
        What is at fault.
    """

    def __init__(self, text: str, kind: str = '', vertices: Sequence[int] = (), segments: Sequence[int] = (),
                 holes: Sequence[int] = (), regions: Sequence[int] = (), triangles: Sequence[int] = ()) -> None:
        super().__init__(text, kind)
        self.vertices = list(vertices)
        self.segments = list(segments)
        self.holes = list(holes)
        self.regions = list(regions)
        self.triangles = list(triangles)

    def __reduce__(self):
        return (type(self), (str(self), self.kind, self.vertices, self.segments, self.holes, self.regions,
                            self.triangles))


class PointError(MeshingError):
    """Points of which no mesh or quadtree can be made.

    Attributes
    ----------
    kind : str
        'not_finite', 'out_of_range', 'indistinguishable' or 'too_near'.
    points : list of int
        The indices of one point or two.
    """

    def __init__(self, text: str, kind: str = '', points: Sequence[int] = ()) -> None:
        super().__init__(text, kind)
        self.points = list(points)

    def __reduce__(self):
        return (type(self), (str(self), self.kind, self.points))


class DegreesWarning(UserWarning):
    """Coordinates are degrees of longitude and latitude, and angles and areas are those of such a map."""
