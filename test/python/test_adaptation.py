"""Meshes refined and adapted."""

import os

import numpy as np
import pytest

import quadtree_mesh
from quadtree_mesh import triangle

FULL = 'QUADTREE_MESH_FULL_TESTS' in os.environ
SQUARE = dict(vertices=[[0, 0], [1, 0], [1, 1], [0, 1]], segments=[[0, 1], [1, 2], [2, 3], [3, 0]])
TWO = dict(vertices=[[0, 0], [1, 0], [1, 1], [0, 1]], triangles=[[0, 1, 2], [0, 2, 3]])


def check_kept(new, old_vertices):
    """Vertices of the old mesh come first, in order, bit for bit."""
    kept = new.old_vertices[new.old_vertices >= 0]
    assert (new.old_vertices[:len(kept)] == kept).all() and (np.diff(kept) > 0).all()
    assert (new.vertices[:len(kept)] == np.asarray(old_vertices, float)[kept]).all()


def test_refine_keeps_all_vertices():
    old = quadtree_mesh.mesh(**SQUARE, max_area=0.01, regions=[[0.5, 0.5, 7]], segment_markers=[1, 2, 3, 4])
    new = quadtree_mesh.refine(old, max_area=0.002)
    assert new.report and (new.old_vertices >= 0).sum() == len(old.vertices)
    check_kept(new, old.vertices)
    assert new.areas().max() <= 0.002 and new.angles().min() >= 20.7
    assert (new.values_of_triangles() == 7).all()
    assert set(new.segment_origins) == {0, 1, 2, 3}
    assert (new.segment_markers == new.segment_origins + 1).all()
    assert new.number_of_input_vertices == 4
    again = quadtree_mesh.refine(new, max_area=0.001)
    check_kept(again, new.vertices)


def test_areas_bound_what_lies_in_triangles():
    new = quadtree_mesh.refine(TWO, areas=[0.001, -1])
    below = new.vertices[new.triangles].mean(axis=1)
    is_below = below[:, 0] > below[:, 1]
    assert new.areas()[is_below].max() <= 0.001 < new.areas()[~is_below].max()
    with pytest.raises(quadtree_mesh.GraphError, match='areas must have 2 numbers, one each, not 3') as error:
        quadtree_mesh.refine(TWO, areas=[1, 1, 1])
    assert error.value.kind == 'array_length'


def test_attributes_and_segments_of_triangles():
    new = quadtree_mesh.refine(dict(TWO, triangle_attributes=[5, 9], segments=[[0, 2], [1, 2]], segment_markers=[3, 4]),
                               max_area=0.01)
    centers = new.vertices[new.triangles].mean(axis=1)
    assert (new.values_of_triangles() == np.where(centers[:, 0] > centers[:, 1], 5, 9)).all()
    assert set(new.segment_markers) == {0, 3, 4}
    assert set(new.segment_origins) == {-1, 0, 1}


def test_adapt_refines_and_coarsens():
    finest = 0.02 if FULL else 0.1
    old = quadtree_mesh.mesh(**SQUARE, max_edge=2.5 * finest)
    new = quadtree_mesh.adapt(old, sizes=finest + 0.4 * old.vertices[:, 0])
    check_kept(new, old.vertices)
    assert new.report and new.angles().min() >= 20.7
    assert 0 < (new.old_vertices >= 0).sum() < len(old.vertices)
    values = new.carry_over(np.column_stack([old.vertices[:, 0], 3 - old.vertices[:, 1]]))
    assert np.abs(values - np.column_stack([new.vertices[:, 0], 3 - new.vertices[:, 1]])).max() < 1e-12
    same = quadtree_mesh.adapt(new, sizes=finest + 0.4 * new.vertices[:, 0])
    assert (same.old_vertices >= 0).mean() > 0.9
    coarse = quadtree_mesh.adapt(old)
    assert len(coarse.triangles) < 10
    triangles = quadtree_mesh.adapt(dict(vertices=old.vertices, triangles=old.triangles))
    assert len(triangles.triangles) < 10
    with pytest.raises(ValueError, match='only a mesh by refine'):
        old.carry_over(old.vertices[:, 0])


def test_refine_where_and_threads():
    def is_large(corners):
        x, y = corners.mean(axis=0)
        return x + y < 0.3 and np.ptp(corners[:, 0]) > 0.05

    old = quadtree_mesh.mesh(**SQUARE, max_edge=0.2)
    one, all_threads = (quadtree_mesh.refine(old, refine_where=is_large, threads=n) for n in (1, 4))
    assert len(one.vertices) > len(old.vertices)
    assert (one.vertices == all_threads.vertices).all() and (one.triangles == all_threads.triangles).all()


@pytest.mark.parametrize('change, text', [
    (dict(triangles=[[0, 1, 2], [0, 3, 2]]), r'triangle 1 \(0 3 2\) is clockwise'),
    (dict(triangles=[[0, 1, 2], [0, 2, 9]]), r'names vertex 9, but there are 4 vertices'),
    (dict(triangles=[[0, 1, 2], [1, 2, 3]]), r'triangle 0 .* and triangle 1 .*'),
    (dict(segments=[[1, 3]]), r'segment 0 from vertex 1 to vertex 3 is not an edge of a triangle'),
])
def test_what_is_no_mesh(change, text):
    with pytest.raises(quadtree_mesh.GraphError, match=text) as error:
        quadtree_mesh.refine(dict(TWO, **change))
    assert error.value.kind == 'invalid_mesh'


def test_degrees_are_refused():
    old = quadtree_mesh.mesh(**SQUARE, project='mercator')
    with pytest.raises(ValueError, match='a mesh in degrees cannot be refined'):
        quadtree_mesh.refine(old)


def test_stand_in_for_triangle():
    box = triangle.triangulate(SQUARE, 'pqa0.1')
    n = len(box['triangles'])
    areas = np.full(n, -1.0)
    areas[0] = 0.001
    finer = triangle.triangulate(dict(box, triangle_max_area=areas), 'rpqa')
    assert len(finer['triangles']) > n
    assert (finer['vertices'][:len(box['vertices'])] == box['vertices']).all()
    without = triangle.triangulate(dict(box, triangle_max_area=areas), 'rpq')
    assert len(without['triangles']) == n
    with pytest.raises(quadtree_mesh.GraphError, match='areas must have'):
        triangle.triangulate(dict(box, triangle_max_area=areas[1:]), 'rpqa')


def test_mesh_of_points_is_refined_and_adapted():
    points = np.random.default_rng(1).random((200 if FULL else 40, 2))
    largest = 0.001 if FULL else 0.01
    coarse = quadtree_mesh.mesh_points(points)
    fine = quadtree_mesh.refine(coarse, max_area=largest)
    assert fine.areas().max() <= largest
    assert (fine.vertices[:len(coarse.vertices)] == coarse.vertices).all()
    assert quadtree_mesh.adapt(fine, sizes=np.full(len(fine.vertices), 0.3)).areas().sum() == pytest.approx(
        coarse.areas().sum())


def test_refining_knows_the_bounds_of_mesh():
    square = dict(vertices=[[0, 0], [1, 0], [1, 1], [0, 1]], triangles=[[0, 1, 2], [0, 2, 3]])
    mesh = quadtree_mesh.refine(square, areas=[0.001, -1], max_angle=110, gradation=0.5)
    assert mesh.report and mesh.angles().max() <= 110 + 1e-9
    assert not quadtree_mesh.refine(square, max_area=0.001, max_vertices=400).report


def test_wrong_arguments_are_named():
    fine = quadtree_mesh.refine(TWO, max_area=0.1)
    for values in (np.zeros(3), np.zeros(5), np.zeros((3, 2)), 1.0):
        with pytest.raises(ValueError, match='values must have 4 rows, one for each vertex of the old mesh, not '):
            fine.carry_over(values)
    with pytest.raises(TypeError, match='mesh must be a Mesh or a dict with vertices and triangles, not NoneType'):
        quadtree_mesh.refine(None)
    with pytest.raises(ValueError, match='mesh has no triangles'):
        quadtree_mesh.adapt(dict(vertices=[[0, 0]]))
    for sizes in ([1, 0, 0, 1], [1, -1, 1, 1], [1, np.nan, 0, 1]):
        with pytest.raises(ValueError, match='the size at vertex 1 is not a positive number'):
            quadtree_mesh.adapt(TWO, sizes=sizes)


def test_areas_beyond_the_memory_are_refused():
    with pytest.raises(quadtree_mesh.GraphError, match='most of all for that of triangle 1, 1e-15') as error:
        quadtree_mesh.refine(TWO, areas=[1e-10, 1e-15])
    assert error.value.kind == 'too_many_triangles' and error.value.triangles == [1]


def test_sharp_corners_of_arrays_are_excused():
    wedge = dict(vertices=[[0.1, 0.1], [3, 1], [3, 1.001]], segments=[[0, 1], [1, 2], [2, 0]])
    first = quadtree_mesh.mesh(**wedge)
    assert first.report
    second = quadtree_mesh.refine(dict(vertices=first.vertices, triangles=first.triangles))
    assert second.report
    assert (second.vertices == first.vertices).all() and (second.triangles == first.triangles).all()
    third = quadtree_mesh.adapt(second)
    assert third.report and third.is_input.sum() == third.number_of_input_vertices
    # What is input is known by its index from then on.
    again = quadtree_mesh.adapt(third)
    assert again.report and len(again.triangles) <= len(third.triangles)


def test_six_nodes_in_the_stand_in_for_triangle():
    box = triangle.triangulate(dict(SQUARE, vertex_attributes=[[1.], [2.], [3.], [4.]]), 'pqa0.1o2')
    n = box['triangles'][:, :3].max() + 1
    assert len(box['vertices']) > n
    same = triangle.triangulate(box, 'rpq')
    assert (same['vertices'] == box['vertices'][:n]).all()
    assert (same['triangles'] == box['triangles'][:, :3]).all()
    assert (same['vertex_attributes'][:4, 0] == [1, 2, 3, 4]).all()
