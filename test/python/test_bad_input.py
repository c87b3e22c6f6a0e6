import numpy as np
import pytest
import quadtree_mesh as qm
from shapes import SQUARE

NAN, INF = float('nan'), float('inf')


def changed(**changes):
    return {**SQUARE, **changes}


@pytest.mark.parametrize('graph, kind, parts', [
    (changed(vertices=[[0, 0], [1, 0], [1, NAN], [0, 1]]), 'not_finite', dict(vertices=[2])),
    (changed(vertices=[[0, 0], [1, 0], [1, 1], [INF, 1]]), 'not_finite', dict(vertices=[3])),
    (changed(vertices=[[0, 0], [1, 0], [1, 1e300], [0, 1]]), 'too_near', dict(vertices=[0, 1, 3])),
    (changed(segments=[[0, 1], [1, 2], [2, 3], [3, 4]]), 'no_such_vertex', dict(segments=[3])),
    (changed(segments=[[0, 1], [-1, 2], [2, 3], [3, 0]]), 'no_such_vertex', dict(segments=[1])),
    (changed(segments=[[0, 1], [1, 2], [2, 3], [3, 2**32]]), 'no_such_vertex', dict(segments=[3])),
    (changed(segments=[[0, 2], [1, 3]]), 'crossing', dict(segments=[1, 0])),
    (changed(segments=[[0, 1], [1, 2], [2, 3]]), 'no_domain', dict(vertices=[0, 3])),
    (changed(segments=[]), 'no_domain', {}),
    (changed(holes=[[0.5, 0.5]]), 'no_domain', {}),
    (changed(holes=[[0.5, NAN]]), 'not_finite', dict(holes=[0])),
    (changed(regions=[[0.5, 0.5], [INF, 0]]), 'not_finite', dict(regions=[1])),
    (changed(holes=[[1, 0.5]]), 'ambiguous_seed', dict(holes=[0], segments=[1])),
    (changed(vertices=[[0, 0], [1, 1], [2, 2], [3, 3]]), 'no_area', {}),
    (dict(vertices=[], segments=[]), 'no_area', {}),
    (dict(vertices=[[1, 2]], segments=[]), 'no_area', dict(vertices=[0])),
    (changed(segment_markers=[1, 2]), 'array_length', {}),
    (changed(vertex_markers=[1, 2, 3, 4, 5]), 'array_length', {}),
])
def test_graphs_that_cannot_be_meshed(graph, kind, parts):
    with pytest.raises(qm.GraphError) as error:
        qm.mesh(**graph)
    assert isinstance(error.value, ValueError) and isinstance(error.value, qm.MeshingError)
    assert error.value.kind == kind, str(error.value)
    for name, indices in parts.items():
        assert getattr(error.value, name) == indices, str(error.value)


@pytest.mark.parametrize('name, values', [
    ('vertex_markers', [1, 2, 3, 2**31]),
    ('vertex_markers', [1, 2, 3, -2**31 - 1]),
    ('segment_markers', [2**40 + 7] * 4),
    ('segment_markers', [2.0**33] * 4),
    ('segment_markers', [0, NAN, 0, 0]),
    ('segment_markers', [0, INF, 0, 0]),
    ('segments', [[0, 1], [1, 2], [2, 3], [3, 2**63]]),
    ('vertices', np.ma.masked_invalid([[0, 0], [1, 0], [1, NAN], [0, 1]])),
])
def test_numbers_that_would_not_be_kept(name, values):
    with pytest.raises(ValueError, match=name):
        qm.mesh(**changed(**{name: values}))


def test_markers_of_32_bits_are_kept():
    least, most = -2**31, 2**31 - 1
    mesh = qm.mesh(**changed(segment_markers=[least, most, 0, 1]))
    assert set(mesh.segment_markers) == {least, most, 0, 1}


def test_a_needle_that_asks_for_too_much():
    above = 0.5 + 1e-9
    graph = dict(vertices=[[0, 0], [1, 0], [1, 1], [0, 1], [0.2, 0.5], [0.8, 0.5], [0.2, above], [0.8, above]],
                 segments=[[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [6, 7]])
    with pytest.raises(qm.GraphError) as error:
        qm.mesh(**graph)
    assert error.value.kind == 'too_many_triangles' and sorted(error.value.segments) == [4, 5]


@pytest.mark.parametrize('kwargs, error, text', [
    (dict(min_angle=40), ValueError, '34'),
    (dict(min_angle=-1), ValueError, '0'),
    (dict(min_angle=NAN), ValueError, 'angle'),
    (dict(min_angle='wide'), ValueError, 'float'),
    (dict(threads=10**30), ValueError, 'threads'),
    (dict(max_vertices=2**31), ValueError, 'max_vertices'),
    (dict(progress=1), TypeError, 'progress'),
    (dict(refine_where=1), TypeError, 'refine_where'),
    (dict(max_area=-1), ValueError, 'area'),
    (dict(max_edge=-1), ValueError, 'edge'),
    (dict(min_edge=-1), ValueError, 'edge'),
    (dict(smooth=-1), ValueError, 'smooth'),
    (dict(thin=-1), ValueError, 'thin'),
    (dict(thin=0.5), TypeError, 'integer'),
    (dict(domain=1), TypeError, 'domain'),
    (dict(domain='all'), ValueError, "'enclosed' 'marked' 'parity'"),
    (dict(separation='none'), ValueError, 'theorem_5'),
    (dict(size=-1), ValueError, 'positive'),
    (dict(size=lambda x, y: 1), TypeError, 'size_grid'),
    (dict(size='small'), TypeError, 'SizeGrid'),
    (dict(max_area=[1, 2]), TypeError, 'regions'),
    (dict(region='name'), TypeError, 'geometry'),
    (dict(max_aera=1), TypeError, 'max_aera'),
    (dict(gradation=1.5), ValueError, 'gradation'),
    (dict(gradation=-0.1), ValueError, 'gradation'),
    (dict(max_edge_ratio=2), ValueError, 'at least 3'),
    (dict(max_angle=104), ValueError, 'at least 105'),
    (dict(max_angle=180), ValueError, 'below 180'),
    (dict(threads=-1), ValueError, 'threads'),
    (dict(max_vertices=-1), ValueError, 'max_vertices'),
])
def test_options_out_of_range(kwargs, error, text):
    with pytest.raises(error, match=text):
        qm.mesh(**SQUARE, **kwargs)


@pytest.mark.parametrize('kwargs, text', [
    (dict(vertices=[[0, 0, 0]], segments=[]), 'vertices'),
    (dict(vertices=[0, 1, 2], segments=[]), 'vertices'),
    (dict(vertices=SQUARE['vertices'], segments=[[0, 1, 2]]), 'segments'),
    (dict(vertices=SQUARE['vertices'], segments=[[0, 0.5]]), 'whole'),
    (dict(vertices=SQUARE['vertices'], segments=[['a', 'b']]), 'whole'),
    (changed(holes=[[1, 2, 3]]), 'holes'),
    (changed(regions=[[1, 2, 3, 4, 5]]), 'regions'),
    (changed(segment_markers=[0.5] * 4), 'segment_markers'),
    (changed(vertices=[['a', 'b']]), ''),
])
def test_arrays_of_wrong_shapes(kwargs, text):
    with pytest.raises(ValueError, match=text):
        qm.mesh(**kwargs)


def test_nothing_and_too_much():
    with pytest.raises(TypeError, match='geometry or vertices'):
        qm.mesh()
    with pytest.raises(TypeError):
        qm.mesh(SQUARE['vertices'], vertices=SQUARE['vertices'])


@pytest.mark.parametrize('arguments, text', [
    ((np.ones(3), (0, 0), (1, 1)), 'rows'),
    ((np.ones((0, 3)), (0, 0), (1, 1)), 'sizes'),
    ((np.zeros((2, 2)), (0, 0), (1, 1)), 'positive'),
    ((np.ones((2, 2)), (0, 0), (0, 1)), 'spacing'),
    ((np.ones((2, 2)), (NAN, 0), (1, 1)), 'spacing'),
])
def test_bad_grids(arguments, text):
    with pytest.raises(ValueError, match=text):
        qm.SizeGrid(*arguments)


@pytest.mark.parametrize('arguments, text', [
    (([], []), 'needs a point'),
    (([[0, 0]], [1, 2]), 'each point'),
    (([[0, 0]], [0]), 'positive'),
    (([[0, 0]], [1], -1), 'gradation'),
    (([[0, 0, 0]], [1]), 'columns'),
])
def test_bad_size_points(arguments, text):
    with pytest.raises(ValueError, match=text):
        qm.SizePoints(*arguments)


def test_bad_size_functions():
    with pytest.raises(ValueError, match='spacing'):
        qm.size_grid(lambda x, y: x, (0, 0, 1, 1), 0)
    with pytest.raises(ValueError):
        qm.size_grid(lambda x, y: [1, 2, 3], (0, 0, 1, 1), 1)


@pytest.mark.parametrize('points, kind, indices', [
    ([[0, 0], [1, NAN]], 'not_finite', [1]),
    ([[0, 0], [1, 1], [1e-200, 1e-200]], 'indistinguishable', [0, 2]),
])
def test_points_of_which_there_is_no_quadtree(points, kind, indices):
    for make in (qm.Quadtree, qm.mesh_points):
        with pytest.raises(qm.PointError) as error:
            make(points)
        assert (sorted(error.value.points), isinstance(error.value, ValueError)) == (indices, True)
        if make is qm.Quadtree:
            assert error.value.kind == kind


@pytest.mark.parametrize('kwargs, error', [
    (dict(angles='obtuse'), ValueError), (dict(angles='bounded'), ValueError), (dict(angles=(40, 80)), ValueError),
    (dict(angles=(30, 70)), ValueError), (dict(effort=7), ValueError), (dict(domain='disk'), ValueError),
    (dict(angles=(1, 2, 3)), ValueError)])
def test_bad_options_of_points(kwargs, error):
    with pytest.raises(error):
        qm.mesh_points([[0, 0], [1, 1]], **kwargs)


def test_bad_quadtrees():
    with pytest.raises(ValueError, match='balance'):
        qm.Quadtree([[0, 0]], balance='all')
    with pytest.raises(ValueError, match='max_points_per_leaf'):
        qm.Quadtree([[0, 0]], max_points_per_leaf=0)
    tree = qm.Quadtree([[0, 0], [1, 1]], balance='none')
    with pytest.raises(ValueError, match='balanced'):
        tree.neighbors()
    with pytest.raises(ValueError, match='balanced'):
        tree.near_neighbors()
    with pytest.raises(ValueError, match='shape'):
        tree.locate([[0, 0, 0]])
