import numpy as np
import pytest
import quadtree_mesh as qm
from shapes import check_mesh

POINTS = np.random.default_rng(5).uniform(-1, 1, (60, 2))


@pytest.mark.parametrize('angles, least, largest', [((36, 80), 36, 80), ((30, 85), 30, 85), ('acute', 0, 90),
                                                    ('least', 20.7, 180), ('warped', 22.4, 112.7)])
def test_angles_of_point_sets(angles, least, largest):
    shares = []
    mesh = qm.mesh_points(POINTS, angles=angles, progress=shares.append)
    check_mesh(mesh)
    assert mesh.report and least <= mesh.angles().min() and mesh.angles().max() <= largest
    assert mesh.vertices[:len(POINTS)].tobytes() == POINTS.tobytes()
    assert set(range(len(POINTS))) <= set(mesh.triangles.ravel().tolist())
    assert np.isclose(mesh.report.least_angle, mesh.angles().min())
    assert shares[-1] == 1


def test_few_points():
    for points in ([], [[1, 2]], [[1, 2], [1, 2]], [1, 2]):
        mesh = qm.mesh_points(points)
        assert len(mesh.vertices) >= len(np.reshape(points, (-1, 2)))
        check_mesh(mesh)


def test_quadtree_separates_points():
    tree = qm.Quadtree(POINTS)
    assert tree.is_valid() and len(tree) == len(tree.boxes) == len(tree.levels)
    assert len(set(tree.leaves_of_points)) == len(POINTS)
    box = tree.boxes[tree.leaves_of_points]
    assert ((box[:, :2] <= POINTS) & (POINTS < box[:, 2:])).all()
    side = tree.boxes[:, 2:] - tree.boxes[:, :2]
    assert (side[:, 0] == side[:, 1]).all()
    root = side[0, 0] * 2.0 ** tree.levels[0]
    assert (side[:, 0] == root / 2.0 ** tree.levels).all() and tree.levels.max() == tree.depth
    assert np.isclose((side[:, 0] ** 2).sum(), root ** 2)


def test_quadtree_is_balanced():
    tree = qm.Quadtree(POINTS)
    begin, leaves = tree.neighbors()
    low, high = tree.boxes[:, None, :2], tree.boxes[:, None, 2:]
    touches = ((low <= high.transpose(1, 0, 2)) & (low.transpose(1, 0, 2) <= high)).all(axis=2)
    np.fill_diagonal(touches, False)
    for i in range(len(tree)):
        own = leaves[begin[i]:begin[i + 1]]
        assert sorted(own) == np.flatnonzero(touches[i]).tolist()
        assert (abs(tree.levels[own] - tree.levels[i]) <= 1).all()


def test_location_and_near_neighbors():
    tree = qm.Quadtree(POINTS)
    assert (tree.locate(POINTS) == tree.leaves_of_points).all()
    assert tree.locate([[100, 100], [np.nan, 0]]).tolist() == [-1, -1]
    near = tree.near_neighbors()
    distance = np.linalg.norm(POINTS[:, None] - POINTS, axis=2)
    np.fill_diagonal(distance, np.inf)
    assert (distance[np.arange(len(POINTS)), near] <= 1.6284 * distance.min(axis=1)).all()


def test_quadtrees_of_sizes():
    size = qm.SizePoints([[0, 0]], [0.01], gradation=0.2)
    tree = qm.Quadtree(POINTS, size=[size, 0.3], max_points_per_leaf=5)
    x, y = (tree.boxes[:, :2] + tree.boxes[:, 2:]).T / 2
    assert (tree.boxes[:, 2] - tree.boxes[:, 0] <= np.minimum(size(x, y), 0.3) * (1 + 1e-12)).all()
    assert tree.is_valid()


def test_quadtree_of_no_points():
    tree = qm.Quadtree([])
    assert len(tree) == 1 and tree.depth == 0 and tree.is_valid()
    assert qm.Quadtree([[1, 1]]).near_neighbors().tolist() == [-1]
    assert len(qm.Quadtree(POINTS, balance='none')) <= len(qm.Quadtree(POINTS, balance='sides')) <= \
        len(qm.Quadtree(POINTS))


def test_quadtree_of_any_number_of_points_per_leaf():
    points = np.random.default_rng(1).random((50, 2))
    assert len(qm.Quadtree(points, max_points_per_leaf=10**30)) == 1
    with pytest.raises(TypeError):
        qm.Quadtree(points, max_points_per_leaf=2.5)
    with pytest.raises(ValueError, match='at least 1'):
        qm.Quadtree(points, max_points_per_leaf=-10**30)
