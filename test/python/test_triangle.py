"""The stand-in for the package triangle: its documented examples, and inputs that crash it, retyped."""

import numpy as np
import pytest
from quadtree_mesh import GraphError, mesh, triangle
from shapes import SQUARE, annulus, polygon_area, ring

UNIT = dict(vertices=np.array([[0, 0], [1, 0], [1, 1], [0, 1]]))
# spiral.node of the documentation, by J. R. Shewchuk.
SPIRAL = dict(vertices=[[0, 0], [-0.416, 0.909], [-1.35, 0.436], [-1.64, -0.549], [-1.31, -1.51], [-0.532, -2.17],
                        [0.454, -2.41], [1.45, -2.21], [2.29, -1.66], [2.88, -0.838], [3.16, 0.131], [3.12, 1.14],
                        [2.77, 2.08], [2.16, 2.89], [1.36, 3.49]])
# box.poly of the documentation: one side of the outer box, and a square hole.
BOX = dict(vertices=[[0, 0], [0, 3], [3, 0], [3, 3], [1, 1], [1, 2], [2, 1], [2, 2]],
           vertex_markers=[[0], [0], [0], [33], [0], [0], [0], [0]],
           segments=[[0, 1], [4, 6], [6, 7], [7, 5], [5, 4]], segment_markers=[[5], [0], [0], [10], [0]],
           holes=[[1.5, 1.5]])


def angles_and_areas(t):
    corners = np.asarray(t['vertices'])[t['triangles']]
    u, v = corners[:, [1, 2, 0]] - corners, corners[:, [2, 0, 1]] - corners
    cross = u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]
    return np.degrees(np.arctan2(cross, (u * v).sum(axis=2))), cross[:, 0] / 2


def check(t, area, least=0.0, largest_area=np.inf):
    angles, areas = angles_and_areas(t)
    assert np.isclose(areas.sum(), area) and (areas > 0).all()
    assert angles.min() >= least and areas.max() <= largest_area * (1 + 1e-12)
    assert t['vertex_markers'].shape == (len(t['vertices']), 1)


def test_documented_first_example():
    t = triangle.triangulate({'vertices': [[0, 0], [0, 1], [1, 1], [1, 0]]}, 'a0.2')
    check(t, 1, largest_area=0.2)
    assert t['vertices'][:4].tolist() == [[0, 0], [0, 1], [1, 1], [1, 0]]
    on_border = ((t['vertices'] == 0) | (t['vertices'] == 1)).any(axis=1)
    assert (t['vertex_markers'][:, 0] == on_border).all()


def test_documented_delaunay():
    # Four triangles around the middle, as there.
    t = triangle.delaunay([[0, 0], [0, 1], [0.5, 0.5], [1, 1], [1, 0]])
    expected = [[1, 0, 2], [2, 4, 3], [4, 2, 0], [2, 3, 1]]
    assert sorted(map(sorted, t.tolist())) == sorted(map(sorted, expected))


def test_documented_convex_hull():
    segments = triangle.convex_hull([[0, 0], [0, 1], [1, 1], [1, 0]])
    assert sorted(map(sorted, segments.tolist())) == [[0, 1], [0, 3], [1, 2], [2, 3]]


@pytest.mark.parametrize('opts, largest', [('', np.inf), ('qa0.1', 0.1), ('qa0.01', 0.01)])
def test_documented_squares(opts, largest):
    t = triangle.triangulate(UNIT, opts)
    check(t, 1, 20 if 'q' in opts else 0, largest)
    assert opts or len(t['triangles']) == 2


@pytest.mark.parametrize('opts, largest', [('q', np.inf), ('qa0.05', 0.05)])
def test_documented_circles(opts, largest):
    places, _ = ring(1, 32)
    check(triangle.triangulate(dict(vertices=places), opts), polygon_area(places), 20, largest)


def test_documented_annulus():
    graph = annulus()
    area = polygon_area(graph['vertices'][:30]) - polygon_area(graph['vertices'][30:])
    t = triangle.triangulate(graph, 'qpa0.05')
    check(t, area, 20, 0.05)
    assert t['segments'].shape[1] == 2 and (t['segment_markers'] == 1).all()


def test_documented_boxes_with_attributes():
    vertices, segments, regions = [], [], []
    for x, y, w, h, attribute in [(0, 0, 5, 5, 1), (1, 1, 3, 1, 2), (1, 3, 1, 1, 3), (3, 3, 1, 1, 4)]:
        i = len(vertices)
        vertices += [[x, y], [x + w, y], [x + w, y + h], [x, y + h]]
        segments += [(i, i + 1), (i + 1, i + 2), (i + 2, i + 3), (i + 3, i)]
        regions.append([x + 0.5 * w, y + 0.5 * h, attribute, 0])
    t = triangle.triangulate(dict(vertices=vertices, segments=segments, regions=regions), 'pA')
    check(t, 25)
    _, areas = angles_and_areas(t)
    by_attribute = [areas[t['triangle_attributes'][:, 0] == a].sum() for a in (1, 2, 3, 4)]
    # The middle of the first box is in none of the others.
    assert np.allclose(by_attribute, [20, 3, 1, 1])
    assert len(t['vertices']) == 16  # no new ones
    assert (t['regions'] == regions).all()


def test_documented_box_with_a_convex_hull():
    t = triangle.triangulate(BOX, 'pc')
    check(t, 8)
    assert t['vertex_markers'][3, 0] == 33 and t['vertex_markers'][0, 0] == 5
    pieces = {tuple(sorted(s)): m for s, m in zip(t['segments'].tolist(), t['segment_markers'][:, 0])}
    assert pieces[(0, 1)] == 5 and pieces[(5, 7)] == 10 and pieces[(4, 6)] == 1
    assert pieces[(2, 3)] == 1  # the hull's


@pytest.mark.parametrize('opts, least', [('', 0), ('q', 20), ('q32.5', 32.5)])
def test_documented_spirals(opts, least):
    t = triangle.triangulate(SPIRAL, opts)
    hull = triangle.convex_hull(SPIRAL['vertices'])
    ends = np.asarray(SPIRAL['vertices'])[hull]
    check(t, abs((ends[:, 0, 0] * ends[:, 1, 1] - ends[:, 1, 0] * ends[:, 0, 1]).sum()) / 2, least)


def test_documented_spiral_by_area():
    _, areas = angles_and_areas(triangle.triangulate(SPIRAL, 'a.2'))
    assert areas.max() <= 0.2


def test_documented_refinement():
    box = triangle.triangulate(BOX, 'pc')
    for area in (0.2, 0.05, 0.0125):
        finer = triangle.triangulate(box, f'rpa{area}')
        check(finer, 8, largest_area=area)
        n = len(box['vertices'])
        assert (finer['vertices'][:n] == box['vertices']).all()
        box = finer


def test_the_issue_of_this_package():
    graph = dict(vertices=[[0, 0], [1, 0], [1, 1], [0, 1], [.5, 0], [.5, 1]],
                 segments=[[0, 4], [4, 1], [1, 2], [2, 5], [5, 3], [3, 0], [4, 5]],
                 regions=[[.2, .5, 7, .01], [.8, .5, 9, 0]])
    t = triangle.triangulate(graph, 'pq30a0.1Aan')
    check(t, 1, 30, 0.1)
    _, areas = angles_and_areas(t)
    left = t['triangle_attributes'][:, 0] == 7
    assert areas[left].max() <= 0.01 < areas[~left].max() and np.isclose(areas[left].sum(), 0.5)
    assert t['neighbors'].shape == t['triangles'].shape
    # Areas of regions count only with an a without a number.
    assert len(triangle.triangulate(graph, 'pq30a0.1A')['triangles']) < len(t['triangles'])
    one_region = triangle.triangulate(dict(graph, regions=[[.2, .5, 7, .01]]), 'pA')
    assert set(one_region['triangle_attributes'].ravel()) == {0, 7}


def test_edges_and_neighbors():
    t = triangle.triangulate(annulus(), 'pqen')
    assert len(t['vertices']) - len(t['edges']) + len(t['triangles']) == 0  # Euler, with a hole
    assert (t['edge_markers'] == 1).sum() == (t['neighbors'] == -1).sum() == len(t['segments'])


def test_six_nodes():
    t = triangle.triangulate(dict(annulus(), segment_markers=np.full((46, 1), 9)), 'pqeno2')
    corners, nodes = t['triangles'][:, :3], t['triangles'][:, 3:]
    places = t['vertices']
    for k in range(3):  # Triangle's order: opposite the corners
        assert np.allclose(places[nodes[:, k]], (places[corners[:, (k + 1) % 3]] + places[corners[:, (k + 2) % 3]]) / 2)
    n = corners.max() + 1
    assert len(places) == n + len(t['edges']) == len(t['vertex_markers'])
    assert sorted(np.unique(nodes)) == list(range(n, len(places)))
    on_border = t['neighbors'] < 0
    assert (t['vertex_markers'][nodes[on_border], 0] == 9).all()
    assert (t['vertex_markers'][nodes[~on_border], 0] == 0).all()


def circumcenters(t):
    a, b, c = (t['vertices'][t['triangles'][:, k]] for k in range(3))
    u, v = b - a, c - a
    d = 2 * (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
    u2, v2 = (u ** 2).sum(axis=1), (v ** 2).sum(axis=1)
    return a + np.stack([v[:, 1] * u2 - u[:, 1] * v2, u[:, 0] * v2 - v[:, 0] * u2], axis=1) / d[:, None], a


def test_conforming_delaunay():
    # A segment close to vertices that it does not need to be split for.
    graph = dict(vertices=[[0, 0], [9, 0], [9, 9], [0, 9], [1, 4], [8, 4.2], [3, 4.5], [6, 4.6]],
                 segments=[[0, 1], [1, 2], [2, 3], [3, 0], [4, 5]])

    def vertices_in_circles(t):
        centers, on_circle = circumcenters(t)
        radii = np.linalg.norm(on_circle - centers, axis=1)
        distances = np.linalg.norm(t['vertices'][None] - centers[:, None], axis=2)
        return (distances < radii[:, None] * (1 - 1e-9)).sum()
    assert vertices_in_circles(triangle.triangulate(graph, 'p')) > 0
    for opts in ('pD', 'pqD'):
        assert vertices_in_circles(triangle.triangulate(graph, opts)) == 0


@pytest.mark.parametrize('opts, kept', [('pqa0.02', ()), ('pqa0.02Y', (0, 1, 2, 3)), ('pqa0.02YY', (0, 1, 2, 3, 4))])
def test_borders_without_new_vertices(opts, kept):
    graph = dict(vertices=[[0, 0], [1, 0], [1, 1], [0, 1]], segments=[[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]],
                 segment_markers=[[2], [3], [4], [5], [6]])
    t = triangle.triangulate(graph, opts)
    assert np.isclose(angles_and_areas(t)[1].sum(), 1)
    pieces = [(t['segment_markers'][:, 0] == m).sum() for m in (2, 3, 4, 5, 6)]
    for s in range(5):
        assert (pieces[s] == 1) == (s in kept)


def test_vertices_outside():
    graph = dict(vertices=[[0, 0], [1, 0], [0, 1], [5, 5]], segments=[[0, 1], [1, 2], [2, 0]],
                 vertex_attributes=[1, 2, 3, 4])
    t = triangle.triangulate(graph, 'p')
    assert len(t['vertices']) == 4 and t['vertex_attributes'].ravel().tolist() == [1, 2, 3, 4]
    assert len(triangle.triangulate(graph, 'pj')['vertices']) == 3


def test_most_new_vertices():
    assert len(triangle.triangulate(annulus(), 'pqS1000')['vertices']) <= 46 + 1000
    for most in (0, 1, 10):  # as there, refinement just ends
        assert len(triangle.triangulate(annulus(), f'pqa0.0001S{most}')['vertices']) == 46 + most


def test_segments_that_cross_are_split():
    graph = dict(vertices=[[0, 0], [2, 0], [2, 2], [0, 2], [-1, 1], [3, 1]],
                 segments=[[0, 1], [1, 2], [2, 3], [3, 0], [4, 5]])
    check(triangle.triangulate(graph, 'pq'), 4, 20)


@pytest.mark.parametrize('opts', ['o', 'o3', 'u', 'v', 'k', 'p?', 'q50'])
def test_switches_that_are_refused(opts):
    with pytest.raises(ValueError):
        triangle.triangulate(UNIT, opts)


def test_bad_dictionaries():
    with pytest.raises(KeyError, match='vertex'):
        triangle.triangulate(dict(vertex=[]))
    with pytest.raises(ValueError, match='three vertices'):
        triangle.triangulate(dict(vertices=[[0, 0], [1, 1]]))
    with pytest.raises(GraphError):
        triangle.triangulate(dict(vertices=[[0, 0], [1, 1], [2, 2]]))


def test_pictures():
    matplotlib = pytest.importorskip('matplotlib')
    matplotlib.use('Agg')
    from matplotlib import pyplot
    triangle.compare(pyplot, BOX, triangle.triangulate(BOX, 'pcq'))
    assert len(pyplot.gcf().axes) == 2
    pyplot.close('all')


# --- What crashes the package triangle: drufat/triangle, by the numbers of its issues ---

def test_issue_2_a_hole_in_a_corner_of_an_arc():
    vertices = [
        [2.1948854485272875, 0.2233940429716767], [2.210334747734508, 0.2045690176995104],
        [2.23101526067872, 0.19170904853717624], [2.2547319630849922, 0.18617908927292653],
        [2.2789675703171275, 0.18856608834740984], [2.301149721315429, 0.1986166902985606],
        [2.3189240083317504, 0.21526412684456825], [2.3304038731566465, 0.23674144339235967],
        [2.334370845917945, 0.2607690431393805], [2.333798685834391, 0.27], [2.1854430073431304, 0.27],
        [2.184870847259575, 0.26076904313938054], [2.1874178917967892, 0.24142231941101294]]
    i = np.arange(13)
    graph = dict(vertices=vertices, segments=np.stack([i, (i + 1) % 13], axis=1))
    for opts in ('p', 'pq', 'pqa0.0001'):
        # The hole is outside, next to the arc: Triangle's own rule leaves the domain as it is.
        check(triangle.triangulate(dict(graph, holes=[[2.194746831368343, 0.22198663923314035]]), opts),
              polygon_area(vertices), 20 if 'q' in opts else 0)


def test_issue_4_a_vertex_given_twice():
    graph = dict(vertices=[[5, -5], [5, 0], [0, 0], [0, -2], [0, -2]],
                 segments=[[0, 1], [1, 2], [2, 3], [3, 4], [4, 0]])
    for opts in ('p', 'pq', 'pqa0.1'):
        check(triangle.triangulate(graph, opts), polygon_area(graph['vertices'][:4]))


def test_issues_68_and_70_again_and_again():
    points = np.array([[1383, 171, 18.0], [1998, 0, 9.170907020568848], [2378, 750, 18.0], [660, 1483, 18.0],
                       [0, 551, 4.605607986450195], [0, 551, 4.605607986450195]])
    segments = [[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 0]]
    bits = set()
    for _ in range(100):
        t = triangle.triangulate(dict(vertices=points[:, :2], segments=segments), 'p')
        check(t, polygon_area(points[:, :2]))
        bits.add(t['triangles'].tobytes())
    assert len(bits) == 1


def test_fuzz():
    """Graphs of all kinds give a mesh or an error that says why."""
    rng = np.random.default_rng(11)
    meshed = 0
    for _ in range(300):
        n, m = rng.integers(3, 9, 2)
        graph = dict(vertices=rng.integers(0, 4, (n, 2)), segments=rng.integers(0, n, (m, 2)))
        try:
            t = triangle.triangulate(graph, rng.choice(['p', 'pq', 'pc', 'pcq30', '', 'qa0.3']))
        except GraphError as error:
            assert error.kind in ('no_domain', 'no_area'), error
            continue
        _, areas = angles_and_areas(t)
        assert (areas > 0).all()
        meshed += 1
    assert meshed > 100


def test_same_mesh_as_without_the_stand_in():
    graph = annulus()
    t = triangle.triangulate(graph, 'pq25a0.01')
    assert t['vertices'].tobytes() == mesh(**graph, min_angle=25, max_area=0.01).vertices.tobytes()


@pytest.mark.parametrize('changes, opts, text', [
    (dict(vertex_attributes=[[1, 2]]), 'p', 'vertex_attributes'),
    (dict(vertex_attributes=[[1]] * 5), 'p', 'vertex_attributes'),
    (dict(segment_markers=[2**40] * 4), 'p', 'segment_markers'),
    (dict(segment_markers=[1, 2]), 'p', 'segment_markers'),
    ({}, 'r', 'no triangles'),
])
def test_arrays_that_do_not_fit(changes, opts, text):
    with pytest.raises(ValueError, match=text):
        triangle.triangulate({**SQUARE, **changes}, opts)
