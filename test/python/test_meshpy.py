"""The stand-in for meshpy.triangle: its example, retyped."""

import numpy as np
import pytest
import quadtree_mesh
from quadtree_mesh import meshpy as triangle


def round_trip(start, end):
    return [(i, i + 1) for i in range(start, end)] + [(end, start)]


def disk_with_a_square_hole():
    points = [(1, 0), (1, 1), (-1, 1), (-1, -1), (1, -1), (1, 0)]
    facets = round_trip(0, len(points) - 1)
    first = len(points)
    points.extend((3 * np.cos(angle), 3 * np.sin(angle)) for angle in np.linspace(0, 2 * np.pi, 30, endpoint=False))
    facets.extend(round_trip(first, len(points) - 1))
    info = triangle.MeshInfo()
    info.set_points(points)
    info.set_facets(facets, facet_markers=[2] * 6 + [1] * 30)
    return info


def areas_of(mesh):
    a, b, c = np.array(mesh.points)[np.array(mesh.elements)].transpose(1, 0, 2)
    return np.cross(b - a, c - a) / 2


def test_refinement_by_a_function():
    info = disk_with_a_square_hole()
    info.set_holes([(0, 0)])

    def needs_refinement(vertices, area):
        center = np.sum(np.array(vertices), axis=0) / 3
        return bool(area > 0.01 + (np.linalg.norm(center, np.inf) - 1) * 0.1)

    mesh = triangle.build(info, refinement_func=needs_refinement)
    areas = areas_of(mesh)
    assert np.isclose(areas.sum(), 15 * 9 * np.sin(2 * np.pi / 30) - 4)
    for corners, area in zip(np.array(mesh.points)[mesh.elements], areas):
        assert not needs_refinement(corners, area)
    # The point that is given twice is in no triangle, so it is not there.
    assert set(np.array(mesh.elements).ravel()) == set(range(len(mesh.points)))
    assert set(mesh.facet_markers) == {1, 2}


def test_regions_and_areas():
    info = disk_with_a_square_hole()
    info.regions.resize(2)
    info.regions[0] = [0, 0, 1, 0.05]
    info.regions[1] = [2, 0, 7, 0.5]
    mesh = triangle.build(info, volume_constraints=True, attributes=True, max_volume=0.3, min_angle=30,
                          generate_faces=True, generate_neighbor_lists=True)
    areas = areas_of(mesh)
    inner = np.array(mesh.element_attributes) == 1
    assert np.isclose(areas[inner].sum(), 4) and areas[inner].max() <= 0.05 < areas[~inner].max() <= 0.3
    assert set(mesh.element_attributes) == {1, 7}
    assert len(mesh.points) - len(mesh.faces) + len(mesh.elements) == 1
    assert mesh.neighbors.shape == mesh.elements.shape
    assert (np.array(mesh.face_markers) == 1).sum() == (mesh.neighbors == -1).sum()
    coarse = triangle.build(info)
    assert len(coarse.elements) < len(mesh.elements) and len(coarse.faces) == 0


def test_six_nodes():
    mesh = triangle.build(disk_with_a_square_hole(), mesh_order=2, generate_faces=True)
    places = np.array(mesh.points)[mesh.elements]
    assert np.allclose(places[:, 3:], (places[:, [1, 2, 0]] + places[:, [2, 0, 1]]) / 2)
    assert len(mesh.points) == len(mesh.point_markers) == mesh.elements[:, :3].max() + 1 + len(mesh.faces)


def test_boundary_without_new_vertices():
    graph = disk_with_a_square_hole()
    mesh = triangle.build(graph, max_volume=0.05, allow_boundary_steiner=False)
    markers = np.array(mesh.facet_markers)
    assert (markers == 1).sum() == 30 and (markers == 2).sum() > 6  # the circle, and the square in it
    assert (np.array(triangle.build(graph, max_volume=0.05).facet_markers) == 1).sum() > 30


def test_what_is_not_supported():
    for kwargs in (dict(allow_volume_steiner=False), dict(mesh_order=3)):
        with pytest.raises(ValueError):
            triangle.build(disk_with_a_square_hole(), **kwargs)
    with pytest.raises(quadtree_mesh.GraphError):
        triangle.build(triangle.MeshInfo())


def test_subdivided_facets():
    points, facets, markers = triangle.subdivide_facets(3, [(0, 0), (3, 0)], [(0, 1)], [5])
    assert points == [(0, 0), (3, 0), (1, 0), (2, 0)] and facets == [(0, 2), (2, 3), (3, 1)] and markers == [5] * 3
    assert len(triangle.subdivide_facets([1, 2], [(0, 0), (1, 0), (1, 1)], [(0, 1), (1, 2)])[1]) == 3
