"""Graphs in degrees: what holds on the sphere, measured by vectors in space."""

import base64
import re
import warnings

import numpy as np
import pytest
import quadtree_mesh as qm
from shapes import check_mesh

geopandas = pytest.importorskip('geopandas')
from shapely.geometry import LineString, Polygon, box  # noqa: E402

RADIUS = 6371008.8
FJORD = Polygon([(10, 59), (10.6, 59.1), (10.7, 59.7), (10.62, 59.8), (10.55, 59.7), (10.3, 59.4)],
                [[(10.4, 59.3), (10.5, 59.3), (10.45, 59.4)]])


def frame(*shapes, crs=4326, **columns):
    return geopandas.GeoDataFrame(columns, geometry=list(shapes), crs=crs)


def on_sphere(places):
    longitude, latitude = np.radians(places).T
    return np.stack([np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude), np.sin(latitude)], 1)


def angles_on_ground(mesh):
    """Between the great circles from each vertex of a triangle to the others."""
    corners = on_sphere(mesh.vertices)[mesh.triangles]
    angles = np.empty(mesh.triangles.shape)
    for k in range(3):
        p = corners[:, k]
        u, v = (corners[:, (k + i) % 3] - p for i in (1, 2))
        u, v = (w - (w * p).sum(axis=1, keepdims=True) * p for w in (u, v))
        angles[:, k] = np.degrees(np.arctan2((np.cross(u, v) * p).sum(axis=1), (u * v).sum(axis=1)))
    return angles


def area_on_ground(mesh):
    corners = on_sphere(mesh.vertices)[mesh.triangles]
    return RADIUS ** 2 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2


@pytest.mark.parametrize('project', ['auto', 'mercator', 'lambert'])
def test_angles_are_those_on_the_ground(project):
    with warnings.catch_warnings():
        warnings.simplefilter('error')
        mesh = qm.mesh(frame(FJORD), min_angle=25, max_area=2e6, project=project)
    assert mesh.report and mesh.report.projection['bent_triangles'] == 0
    assert len(mesh.report.exempt) == 0
    angles = angles_on_ground(mesh)
    assert angles.min() > 24.9  # triangles are plane in the projection, and slightly curved on the ground
    assert np.abs(angles - mesh.angles()).max() < 0.1
    areas = area_on_ground(mesh)
    assert areas.max() < 2.02e6
    assert np.allclose(areas, mesh.areas(), rtol=1e-3)
    # In the plane of degrees the bound does not hold.
    flat = qm.Mesh(dict(vertices=mesh.vertices, triangles=mesh.triangles, neighbors=mesh.neighbors,
                        number_of_input_vertices=0, report=mesh.report))
    assert flat.angles().min() < 20
    check_mesh(flat, FJORD.area)


def test_pages_are_drawn_in_the_plane_and_tell_degrees(tmp_path):
    mesh = qm.mesh(frame(FJORD), max_edge=3000)
    mesh.to_html(tmp_path / 'fjord.html')
    page = (tmp_path / 'fjord.html').read_text(encoding='utf-8')

    def places(name):
        text = re.search(rf'id="{name}" data-type="Float64">([^<]*)<', page).group(1)
        return np.frombuffer(base64.b64decode(text), 'float64').reshape(-1, 2)

    assert (places('points') == mesh.places).all() and (places('coordinates') == mesh.vertices).all()
    with pytest.warns(qm.DegreesWarning):
        qm.mesh(frame(FJORD), project='none').to_html(tmp_path / 'flat.html')
    assert 'id="coordinates"' not in (tmp_path / 'flat.html').read_text(encoding='utf-8')


def test_plots_have_the_shape_on_the_ground():
    pyplot = pytest.importorskip('matplotlib.pyplot')
    pyplot.switch_backend('Agg')

    def height_of_a_degree(mesh):
        """In widths of one, as drawn."""
        ax = mesh.plot(pyplot.figure().gca())
        ax.apply_aspect()
        x, y = np.diff(ax.transData.transform([(10, 59), (11, 60)]), axis=0)[0]
        return y / x

    assert np.isclose(height_of_a_degree(qm.mesh(frame(FJORD))), 1 / np.cos(np.radians(59.4)))
    with pytest.warns(qm.DegreesWarning):
        assert np.isclose(height_of_a_degree(qm.mesh(frame(FJORD), project='none')), 1)
    pyplot.close('all')


def test_vertices_are_kept_and_the_plane_is_told():
    graph = qm.graph(frame(FJORD))
    mesh = qm.mesh(frame(FJORD), max_edge=3000)
    n = len(graph['vertices'])
    assert mesh.number_of_input_vertices == n and (mesh.vertices[:n] == graph['vertices']).all()
    assert mesh.places.shape == mesh.vertices.shape and mesh.scales.shape == (len(mesh.vertices),)
    used = mesh.compacted()
    assert used.places.shape == used.vertices.shape
    edges = mesh.places[mesh.edges()]
    assert np.linalg.norm(edges[:, 0] - edges[:, 1], axis=1).max() <= 3000
    projection = mesh.report.projection
    assert projection['name'] == 'lambert' and 59 < projection['standard_parallels'][0] < 60
    assert 10 < projection['central_longitude'] < 10.7


def test_sizes_hold_at_places_in_degrees():
    east = qm.SizeGrid([[20000, 2000], [20000, 2000]], origin=(10, 59), spacing=(0.7, 1))
    near_island = qm.SizePoints([[10.45, 59.35]], [500], gradation=0.3)
    mesh = qm.mesh(frame(FJORD), size=[east, near_island])
    lengths = np.sqrt(area_on_ground(mesh))
    centers = mesh.vertices[mesh.triangles].mean(axis=1)
    distance = RADIUS * np.linalg.norm(on_sphere(centers) - on_sphere(np.array([[10.45, 59.35]])), axis=1)
    # An equilateral triangle has an area of 0.43 squared edges.
    assert (lengths <= 0.67 * np.minimum(500 + 0.3 * distance, east(centers[:, 0], centers[:, 1]))).all()
    near = distance < 5000
    assert near.any() and lengths[near].max() < 0.5 * lengths.max()


def test_criteria_get_degrees():
    seen = []

    def is_far_north(corners):
        seen.append(corners.copy())
        return corners[:, 1].min() > 59.5 and np.ptp(corners[:, 1]) > 0.05

    mesh = qm.mesh(frame(FJORD), refine_where=is_far_north)
    assert all(10 <= c[:, 0].min() and c[:, 1].max() <= 59.8 + 1e-9 for c in seen)
    corners = mesh.vertices[mesh.triangles]
    assert not any(is_far_north(c) for c in corners)


def test_columns_and_overlaps():
    shapes = frame(box(20, 70, 20.5, 70.2), box(20.3, 70.1, 21, 70.3), LineString([(20.1, 70.05), (20.2, 70.15)]),
                   depth=[3., 5., np.nan], limit=[1e6, 5e6, 0])
    mesh = qm.mesh(shapes, region='depth', max_area='limit')
    assert set(mesh.values_of_triangles()) == {3, 5} and mesh.report.repair is not None
    areas, deep = area_on_ground(mesh), mesh.values_of_triangles() == 5
    assert areas[~deep].max() < 1.01e6 < areas[deep].max() < 5.05e6


def test_arrays_are_projected_if_asked_to():
    arrays = dict(vertices=[[0, 60], [1, 60], [1, 61], [0, 61]], segments=[[0, 1], [1, 2], [2, 3], [3, 0]])
    assert qm.mesh(**arrays).places is None and qm.mesh(**arrays).report.projection is None
    mesh = qm.mesh(**arrays, project='mercator', max_edge=20000)
    assert mesh.report.projection['name'] == 'mercator' and angles_on_ground(mesh).min() > 20.6


def test_a_graph_that_has_no_projection_is_refused():
    with pytest.raises(ValueError, match='project must be one of'):
        qm.mesh(frame(FJORD), project='utm')
    with pytest.raises(TypeError):
        qm.mesh(frame(FJORD), project=None)
    with pytest.raises(qm.GraphError, match='vertex'):
        qm.mesh(vertices=[[0, 89], [1, 89], [0, 90]], segments=[[0, 1], [1, 2], [2, 0]], project='mercator')
    with pytest.raises(ValueError, match='pole'):
        qm.mesh(frame(FJORD), size=qm.SizePoints([[0, 90]], [1.]))
