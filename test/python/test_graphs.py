import gc
import gzip
import os
import pickle
import signal
import threading
import time

import numpy as np
import pytest
import quadtree_mesh as qm
from shapes import (GREAT_LAKES, SQUARE, annulus, check_mesh, check_segments_are_chains, polygon_area, read_poly,
                    ring)


def test_bounds_hold():
    graph = annulus()
    mesh = qm.mesh(**graph, min_angle=25, max_area=0.05)
    area = polygon_area(graph['vertices'][:30]) - polygon_area(graph['vertices'][30:])
    check_mesh(mesh, area)
    check_segments_are_chains(mesh, graph)
    assert mesh.report and mesh.report.is_met and len(mesh.report.unmet) == 0
    assert mesh.angles().min() >= 25
    assert mesh.areas().max() <= 0.05 * (1 + 1e-12)
    assert np.allclose(mesh.angles().sum(axis=1), 180)
    assert mesh.report.triangles == len(mesh.triangles)
    assert mesh.report.least_angle_histogram.sum() == len(mesh.triangles)
    assert mesh.report.largest_angle_histogram.sum() == len(mesh.triangles)


def test_input_vertices_stay():
    rng = np.random.default_rng(1)
    places, segments = ring(1, 12)
    places *= rng.uniform(0.5, 1.5, (12, 1))
    mesh = qm.mesh(vertices=places, segments=segments)
    assert mesh.number_of_input_vertices == 12
    assert mesh.vertices[:12].tobytes() == places.tobytes()
    check_mesh(mesh, polygon_area(places))


def test_without_bounds_there_are_no_new_vertices():
    mesh = qm.mesh(**SQUARE, min_angle=0)
    assert len(mesh.vertices) == 4 and len(mesh.triangles) == 2


@pytest.mark.parametrize('kwargs, largest', [(dict(max_edge=0.1), 0.1), (dict(size=0.1), 0.1)])
def test_edges(kwargs, largest):
    mesh = qm.mesh(**SQUARE, **kwargs)
    edges = mesh.edges()
    assert np.linalg.norm(mesh.vertices[edges[:, 0]] - mesh.vertices[edges[:, 1]], axis=1).max() <= largest * 1.0001
    # Euler: vertices and triangles are edges and one.
    assert len(mesh.vertices) + len(mesh.triangles) == len(edges) + 1


def test_angles_are_not_wide():
    square = dict(vertices=[[0, 0], [6, 0], [6, 6], [0, 6], [4, 4], [4.01, 4.002]],
                  segments=[[0, 1], [1, 2], [2, 3], [3, 0]])
    assert qm.mesh(**square).angles().max() > 120
    mesh = qm.mesh(**square, max_angle=120)
    assert mesh.report and mesh.angles().max() <= 120 and mesh.angles().min() >= 20.7


@pytest.mark.parametrize('kwargs, gradation, ratio', [
    (dict(gradation=0.2), 0.2, 3), (dict(gradation=0.3, max_edge_ratio=5), 0.3, 5), (dict(max_edge_ratio=4), 1, 4)])
def test_edges_grow_slowly(kwargs, gradation, ratio):
    near = dict(vertices=SQUARE['vertices'] + [[0.5, 0.5], [0.51, 0.502]], segments=SQUARE['segments'])

    def excess(mesh):
        """By how much edges are too long, beside the shortest edge at each vertex."""
        edges = mesh.edges()
        lengths = np.linalg.norm(mesh.vertices[edges[:, 0]] - mesh.vertices[edges[:, 1]], axis=1)
        shortest = np.full(len(mesh.vertices), np.inf)
        for k in range(2):
            np.minimum.at(shortest, edges[:, k], lengths)
        apart = np.linalg.norm(mesh.vertices[:, None] - mesh.vertices[None], axis=2)
        allowed = (ratio * shortest + gradation * apart).min(axis=1)
        return (lengths - allowed[edges].min(axis=1)).max()

    mesh = qm.mesh(**near, **kwargs)
    assert mesh.report and excess(mesh) <= 0
    assert excess(qm.mesh(**near)) > 0


def test_sizes_of_which_the_least_counts():
    left = qm.SizePoints([[0, 0.5]], [0.02], gradation=0.3)
    right = qm.size_grid(lambda x, y: 0.3 - 0.25 * x, (0, 0, 1, 1), 0.1)
    mesh = qm.mesh(**SQUARE, size=[left, right, 0.25])
    corners = mesh.vertices[mesh.triangles]
    x, y = corners.mean(axis=1).T
    wanted = np.minimum(np.minimum(left(x, y), right(x, y)), 0.25)
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    assert (longest <= wanted * 1.0001).all()
    assert len(mesh.triangles) > len(qm.mesh(**SQUARE, size=right).triangles)


def test_size_fields():
    grid = qm.SizeGrid([[1, 2, 3], [3, 4, 5]], (10, 20), (1, 2))
    assert grid(10, 20) == 1 and grid(12, 22) == 5 and grid(10.5, 21) == 2.5
    assert grid(-100, -100) == 1 and grid(100, 100) == 5
    assert grid(np.array([10, 11]), np.array([20, 20])).tolist() == [1, 2]
    points = qm.SizePoints([[0, 0], [3, 4]], [1, 2], 0.5)
    assert points(0, 0) == 1 and points(3, 4) == 2 and points(6, 8) == 4.5
    same = qm.size_grid(lambda x, y: x + 10 * y, (1, 1, 3, 2), (1, 0.5))
    assert np.isclose(same(2.25, 1.75), 19.75)


ESRI_GRID = """ncols 3
nrows 2
xllcorner 9.5
yllcorner 19
dx 1
dy 2
NODATA_value -1
3 4 -1
1 2 3
"""


def test_size_grids_of_files(tmp_path):
    file = tmp_path / 'sizes.asc'
    file.write_text(ESRI_GRID)
    for name in (file, str(file)):
        grid = qm.SizeGrid.read(name)
        assert grid(10, 20) == 1 and grid(12, 20) == 3 and grid(11, 22) == 4 and grid(12, 22) == np.inf
    x, y = np.meshgrid([10, 11, 12], [20, 22])
    places = np.column_stack([x.ravel(), y.ravel()])
    apart = np.linalg.norm(places[:, None] - places, axis=2)
    sizes = grid(x, y).ravel()
    wanted = (sizes + 0.25 * apart).min(axis=1)
    assert np.allclose(grid.with_gradation(0.25)(x, y).ravel(), wanted)
    assert np.allclose(qm.SizeGrid.read(file, gradation=0.25)(x, y).ravel(), wanted)
    assert (grid(x, y).ravel() == sizes).all()
    assert (grid.with_gradation(0)(x, y) == 1).all()
    no_bound = qm.SizeGrid(np.full((2, 2), np.inf), (0, 0), (1, 1))
    assert np.isinf(no_bound.with_gradation(0.25)(0.5, 0.5))


def test_size_grids_of_bad_files(tmp_path):
    file = tmp_path / 'sizes.asc'
    with pytest.raises(qm.GraphError, match='sizes.asc'):
        qm.SizeGrid.read(file)
    file.write_text(ESRI_GRID.replace('4', 'four'))
    with pytest.raises(qm.GraphError, match='sizes.asc:8.*four'):
        qm.SizeGrid.read(file)
    file.write_text(ESRI_GRID)
    for gradation in (-1, np.inf, np.nan):
        with pytest.raises(ValueError, match='gradation'):
            qm.SizeGrid.read(file, gradation=gradation)
        with pytest.raises(ValueError, match='gradation'):
            qm.SizeGrid.read(file).with_gradation(gradation)


def test_regions():
    graph = dict(vertices=[[0, 0], [1, 0], [2, 0], [2, 1], [1, 1], [0, 1]],
                 segments=[[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 0], [1, 4]])
    mesh = qm.mesh(**graph, regions=[[1.5, 0.5, 7.5, 0.01], [0.5, 0.5, -3, 0]], max_area=0.2)
    check_mesh(mesh, 2)
    assert mesh.region_values.tolist() == [7.5, -3]
    right = mesh.vertices[mesh.triangles].mean(axis=1)[:, 0] > 1
    assert (mesh.regions == np.where(right, 0, 1)).all()
    assert (mesh.values_of_triangles() == np.where(right, 7.5, -3)).all()
    assert mesh.areas()[right].max() <= 0.01 < mesh.areas()[~right].max() <= 0.2


def test_triangles_without_a_region():
    mesh = qm.mesh(**SQUARE)
    assert (mesh.regions == -1).all() and np.isnan(mesh.values_of_triangles()).all()
    assert (mesh.values_of_triangles(missing=0) == 0).all()


def test_domains():
    outer, segments = ring(3, 20)
    middle, middle_segments = ring(2, 20, 20)
    inner, inner_segments = ring(1, 20, 40)
    graph = dict(vertices=np.vstack([outer, middle, inner]),
                 segments=np.vstack([segments, middle_segments, inner_segments]))
    areas = [polygon_area(p) for p in (outer, middle, inner)]
    check_mesh(qm.mesh(**graph), areas[0])
    check_mesh(qm.mesh(**graph, domain='parity'), areas[0] - areas[1] + areas[2])
    check_mesh(qm.mesh(**graph, domain='marked', regions=[[1.5, 0]]), areas[1] - areas[2])


def test_markers():
    mesh = qm.mesh(**SQUARE, segment_markers=[5, 6, 7, 0], vertex_markers=[0, 0, 9, 0], max_edge=0.3)
    for marker, axis, value in [(5, 1, 0), (6, 0, 1), (7, 1, 1), (0, 0, 0)]:
        ends = mesh.vertices[mesh.segments[mesh.segment_markers == marker]]
        assert len(ends) > 1 and (ends[..., axis] == value).all()
    a, b, c, d = mesh.vertex_markers[:4]
    assert (a, c, d) == (5, 9, 7) and b in (5, 6)
    inside = ((mesh.vertices > 0) & (mesh.vertices < 1)).all(axis=1)
    assert (mesh.vertex_markers[inside] == 0).all() and (mesh.vertex_markers[~inside] != 0).all()
    assert ((mesh.vertex_segments >= 0) == ~inside)[4:].all()


def test_acute_corners_are_exempt():
    mesh = qm.mesh(vertices=[[0, 0], [10, 0], [10, 1]], segments=[[0, 1], [1, 2], [2, 0]])
    assert mesh.report
    assert set(mesh.report.exempt['corner']) <= {0}
    small = mesh.angles().min(axis=1) < 20.7
    assert set(np.flatnonzero(small)) == set(mesh.report.exempt['triangle'])


def test_what_is_unmet_is_reported():
    # A slit of which the ends are near the border.
    graph = dict(vertices=SQUARE['vertices'] + [[0.01, 0.5], [0.99, 0.5]], segments=SQUARE['segments'] + [[4, 5]])
    mesh = qm.mesh(**graph, min_edge=0.05)
    check_mesh(mesh, 1)
    assert not mesh.report and 'unmet' in repr(mesh)
    unmet = mesh.report.unmet
    assert set(unmet['reason']) == {'min_edge'}
    centroids = mesh.vertices[mesh.triangles[unmet['triangle']]].mean(axis=1)
    assert np.allclose(np.stack([unmet['x'], unmet['y']], axis=1), centroids)
    assert np.allclose(unmet['angle'], mesh.angles().min(axis=1)[unmet['triangle']])
    assert np.allclose(unmet['greatest_angle'], mesh.angles().max(axis=1)[unmet['triangle']])
    check_mesh(qm.mesh(**graph), 1)


def test_vertex_budget():
    places, segments = ring(1, 100)
    with pytest.raises(qm.GraphError, match='500') as error:
        qm.mesh(vertices=places, segments=segments, max_area=1e-4, max_vertices=500)
    assert error.value.kind == 'too_many_triangles'


def test_few_new_vertices_and_conforming_meshes():
    graph = dict(vertices=[[0, 0], [9, 0], [9, 9], [0, 9], [1, 4], [8, 4.2], [3, 4.5], [6, 4.6]],
                 segments=[[0, 1], [1, 2], [2, 3], [3, 0], [4, 5]])
    for most in (0, 2):
        mesh = qm.mesh(**graph, max_edge=1, max_steiner=most)
        assert len(mesh.vertices) == 8 + most and mesh.report.is_budget_exhausted
    mesh = qm.mesh(**graph, conforming=True)
    assert mesh.report and mesh.report.encroached_edges == 0
    # No angle opposite an edge on a segment is obtuse.
    on_segment = {tuple(sorted(s)) for s in mesh.segments.tolist()}
    for triangle, angles in zip(mesh.triangles.tolist(), mesh.angles()):
        for k in range(3):
            if tuple(sorted((triangle[(k + 1) % 3], triangle[(k + 2) % 3]))) in on_segment:
                assert angles[k] <= 90 + 1e-9
    assert not qm.mesh(**graph, conforming=True, max_steiner=0).report
    with pytest.raises((ValueError, TypeError)):
        qm.mesh(**graph, max_steiner=-1)


def test_kept_borders():
    graph = dict(vertices=[[0, 0], [9, 0], [9, 9], [0, 9], [4, 1], [4, 8]],
                 segments=[[0, 1], [1, 2], [2, 3], [3, 0], [4, 5]], segment_markers=[0, 0, 0, 0, 3])
    for keep, kept in dict(none=set(), boundary={0, 1, 2, 3}, marked={4}, all={0, 1, 2, 3, 4}).items():
        mesh = qm.mesh(**graph, max_edge=1, keep_borders=keep)
        pieces = np.bincount(mesh.segment_origins, minlength=5)
        assert all((pieces[s] == 1) == (s in kept) for s in range(5))
        assert set(mesh.report.unmet['reason']) == ({'kept_segment'} if kept else set())
        assert set(mesh.report.unmet['segment'].tolist()) <= kept
    with pytest.raises(ValueError, match='keep_borders'):
        qm.mesh(**graph, keep_borders='some')
    with pytest.raises(ValueError, match='borders'):
        qm.mesh(**graph, keep_borders='all', separation='theorem_5')
    with pytest.raises(ValueError, match='borders'):
        qm.mesh(**graph, keep_borders='all', project='mercator')


def test_crossings():
    graph = dict(vertices=[[0, 0], [4, 0], [4, 4], [0, 4], [1, -1], [1, 5]],
                 segments=[[0, 1], [1, 2], [2, 3], [3, 0], [4, 5]])
    with pytest.raises(qm.GraphError) as error:
        qm.mesh(**graph)
    assert error.value.kind == 'crossing' and 4 in error.value.segments
    mesh = qm.mesh(**graph, repair=True)
    check_mesh(mesh, 16)
    assert mesh.report.repair['crossings'] == 2
    assert mesh.report.repair['vertex_map'].tolist() == list(range(6))
    assert mesh.report.repair['segment_origins'].max() == 4
    assert qm.mesh(**SQUARE, repair=True).report.repair is None


def test_duplicates_and_overlaps():
    graph = dict(vertices=[[0, 0], [2, 0], [2, 2], [0, 2], [2, 0], [1, 0]],
                 segments=[[0, 1], [4, 2], [2, 3], [3, 0], [0, 5]])
    mesh = qm.mesh(**graph)
    check_mesh(mesh, 4)
    assert mesh.report.merged_vertices == 1 and mesh.report.vertices_on_segments == 1
    compact = mesh.compacted()
    check_mesh(compact, 4)
    assert len(compact.vertices) == len(mesh.vertices) - 1 == mesh.report.vertices
    assert compact.number_of_input_vertices == 5


def test_refine_where():
    # The corner at the origin is wanted fine.
    def is_large(corners):
        assert corners.shape == (3, 2)
        return bool(np.ptp(corners, axis=0).max() > 0.05 + np.linalg.norm(corners.mean(axis=0)))

    mesh = qm.mesh(**SQUARE, refine_where=is_large)
    check_mesh(mesh, 1)
    assert not any(map(is_large, mesh.vertices[mesh.triangles]))


def test_errors_in_refine_where_come_through():
    def fails(corners):
        raise LookupError('mine')

    with pytest.raises(LookupError, match='mine'):
        qm.mesh(**SQUARE, refine_where=fails)


def test_separation_by_quadtrees():
    mesh = qm.mesh(**annulus(), separation='theorem_5')
    check_mesh(mesh)
    assert mesh.report and mesh.report.has_used_quadtrees and mesh.angles().min() >= 20.7


def test_same_bits_with_any_number_of_threads():
    meshes = [qm.mesh(**annulus(), max_area=1e-4, threads=threads) for threads in (1, 2, None)]
    for mesh in meshes[1:]:
        assert mesh.vertices.tobytes() == meshes[0].vertices.tobytes()
        assert mesh.triangles.tobytes() == meshes[0].triangles.tobytes()


def test_arrays_live_on_without_the_mesh():
    mesh = qm.mesh(**SQUARE, max_area=1e-3)
    copies = {name: getattr(mesh, name).copy() for name in ('vertices', 'triangles', 'segments', 'regions')}
    views = {name: getattr(mesh, name) for name in copies}
    assert not views['vertices'].flags.owndata and views['vertices'].flags.writeable
    del mesh
    gc.collect()
    for _ in range(10):
        qm.mesh(**SQUARE, max_area=1e-3)
    for name, copy in copies.items():
        assert (views[name] == copy).all()


def test_any_array_layout():
    expected = qm.mesh(**SQUARE, max_area=0.1)
    vertices = np.zeros((8, 3), np.float32)
    vertices[::2, 1:] = SQUARE['vertices']
    segments = np.asfortranarray(np.array(SQUARE['segments'], np.uint8))
    mesh = qm.mesh(vertices=vertices[::2, 1:], segments=segments, max_area=0.1)
    assert mesh.vertices.tobytes() == expected.vertices.tobytes()
    assert (mesh.triangles == expected.triangles).all()
    whole = qm.mesh(vertices=SQUARE['vertices'], segments=np.array(SQUARE['segments'], float), max_area=0.1)
    assert (whole.triangles == expected.triangles).all()


def test_meshes_can_be_pickled():
    mesh = qm.mesh(**SQUARE, max_area=0.1)
    again = pickle.loads(pickle.dumps(mesh))
    assert (again.vertices == mesh.vertices).all() and again.report.is_met
    error = pickle.loads(pickle.dumps(qm.GraphError('text', 'crossing', [], [1, 2])))
    assert str(error) == 'text' and error.segments == [1, 2]


# --- From files ---

def test_files(tmp_path):
    lakes = qm.read(GREAT_LAKES)
    with gzip.open(GREAT_LAKES, 'rt') as file:
        again = read_poly(file)
    assert all((lakes[name] == again[name]).all() for name in again)
    (tmp_path / 'box.wkt').write_text('POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0), (.5 .5, 1 .5, 1 1, .5 1, .5 .5))')
    check_mesh(qm.mesh(**qm.read(tmp_path / 'box.wkt')), 3.75)
    (tmp_path / 'box.geojson').write_text(
        '{"type": "Feature", "properties": {"depth": 7}, "geometry": '
        '{"type": "Polygon", "coordinates": [[[0, 0], [2, 0], [0, 2], [0, 0]]]}}')
    mesh = qm.mesh(**qm.read(tmp_path / 'box.geojson', region='depth'))
    check_mesh(mesh, 2)
    assert (mesh.values_of_triangles() == 7).all()
    assert (qm.read(tmp_path / 'box.geojson', marker='depth')['segment_markers'] == 7).all()
    (tmp_path / 'named.geojson').write_text((tmp_path / 'box.geojson').read_text().replace('7', '"deep"'))
    with pytest.raises(ValueError, match="'depth' has names"):
        qm.read(tmp_path / 'named.geojson', marker='depth')


def test_files_that_cannot_be_read(tmp_path):
    with pytest.raises(qm.GraphError, match='none.poly') as error:
        qm.read(tmp_path / 'none.poly')
    assert error.value.kind == 'unreadable'
    (tmp_path / 'bad.poly').write_text('3 2 0 0\n0 0 0\n1 x 0\n')
    with pytest.raises(qm.GraphError, match='line 3|:3'):
        qm.read(tmp_path / 'bad.poly')
    with pytest.raises(ValueError, match='shp'):
        qm.read('lakes.shp')


# --- While it runs ---

LONG = dict(max_area=4e-7)  # a quarter of a second


def test_progress():
    shares = []
    caller = threading.get_ident()

    def progress(share):
        assert threading.get_ident() == caller
        shares.append(share)

    qm.mesh(**SQUARE, max_area=1e-5, progress=progress)
    assert shares == sorted(shares) and shares[-1] == 1 and all(0 <= s <= 1 for s in shares)


def test_progress_can_cancel():
    mesh = qm.mesh(**SQUARE, **LONG, progress=lambda share: False)
    assert mesh.report.is_cancelled and not mesh.report
    assert 'cancelled' in mesh.report.unmet['reason']


def test_errors_in_progress_come_through():
    def progress(share):
        raise LookupError('mine')

    with pytest.raises(LookupError, match='mine'):
        qm.mesh(**SQUARE, **LONG, progress=progress)


@pytest.fixture
def listens_to_ctrl_c():
    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored by jobs in the background
    yield
    signal.signal(signal.SIGINT, before)


def test_ctrl_c(listens_to_ctrl_c):
    begin = time.monotonic()
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        while time.monotonic() < begin + 60:
            qm.mesh(**SQUARE, **LONG)
    assert time.monotonic() < begin + 30


def test_other_threads_run_meanwhile():
    count = 0
    is_done = threading.Event()

    def work():
        nonlocal count
        while not is_done.is_set():
            count += 1
            time.sleep(0.001)

    thread = threading.Thread(target=work)
    thread.start()
    before = count
    qm.mesh(**SQUARE, **LONG)
    during = count - before
    is_done.set()
    thread.join()
    assert during > 10


def test_threads_can_mesh_at_once():
    meshes = [None] * 4

    def work(i):
        meshes[i] = qm.mesh(**annulus(), max_area=1e-3)

    threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len({mesh.vertices.tobytes() for mesh in meshes}) == 1
