import warnings

import numpy as np
import pytest
import quadtree_mesh as qm
from shapes import check_mesh

shapely = pytest.importorskip('shapely')
from shapely.geometry import (GeometryCollection, LineString, MultiPoint, MultiPolygon, Point, Polygon,  # noqa: E402
                              box)
from shapely.ops import unary_union  # noqa: E402

LAKE = Polygon([(0, 0), (10, 0), (12, 5), (5, 9), (-1, 4)], [[(3, 3), (5, 3), (5, 5), (3, 5)]])


def area_of(mesh, row):
    return mesh.areas()[mesh.regions == row].sum()


def test_polygon_with_an_island():
    mesh = qm.mesh(LAKE, max_area=0.5)
    check_mesh(mesh, LAKE.area)
    assert (mesh.regions == 0).all() and mesh.region_values.tolist() == [0]
    assert mesh.areas().max() <= 0.5


def test_graph_of_polygons():
    graph = qm.graph([box(0, 0, 1, 1), box(1, 0, 2, 1)])
    assert len(graph['vertices']) == 6 and len(graph['segments']) == 7 and len(graph['holes']) == 0
    assert sorted(graph['regions'][:, 2]) == [0, 1]
    check_mesh(qm.mesh(**graph), 2)


def test_overlaps_are_split():
    shapes = [box(0, 0, 2, 2), box(1, 1, 3, 3), box(1.5, -1, 1.75, 5)]
    mesh = qm.mesh(shapes, max_area=[0.1, 0.01, np.nan])
    check_mesh(mesh, unary_union(shapes).area)
    # The first one counts.
    assert np.isclose(area_of(mesh, 0), 4) and np.isclose(area_of(mesh, 1), 3)
    assert mesh.areas()[mesh.regions == 1].max() <= 0.01
    assert mesh.report.repair['crossings'] > 0
    with pytest.raises(qm.GraphError, match='cross'):
        qm.mesh(shapes, repair=False)


def test_random_overlaps():
    rng = np.random.default_rng(3)
    for _ in range(10):
        shapes = [Polygon(rng.uniform(0, 1, (3, 2))) for _ in range(6)]
        mesh = qm.mesh(shapes, min_angle=0)
        assert np.isclose(mesh.areas().sum(), unary_union(shapes).area)
        rest = None
        for row, shape in enumerate(shapes):
            own = shape if rest is None else shape.difference(rest)
            rest = shape if rest is None else rest.union(shape)
            assert np.isclose(area_of(mesh, row), own.area, atol=1e-12)


def test_gaps_are_holes():
    shapes = [box(0, 0, 3, 1), box(0, 2, 3, 3), box(0, 1, 1, 2), box(2, 1, 3, 2)]
    mesh = qm.mesh(shapes)
    check_mesh(mesh, 8)
    inside = mesh.vertices[mesh.triangles].mean(axis=1)
    assert not ((abs(inside - 1.5) < 0.5).all(axis=1)).any()


def test_lines_and_points_and_collections():
    collection = GeometryCollection([MultiPolygon([LAKE, box(20, 20, 21, 21)]), LineString([(1, 1), (2, 4)]),
                                     MultiPoint([(7, 4), (8, 3)]), Point(6, 6, 99), Polygon()])
    mesh = qm.mesh(collection)
    check_mesh(mesh, LAKE.area + 1)
    used = mesh.vertices[np.unique(mesh.triangles)].tolist()
    for place in [(1, 1), (2, 4), (7, 4), (8, 3), (6, 6)]:
        assert list(place) in used
    inner = mesh.vertices[mesh.segments].mean(axis=1)
    assert np.isclose(np.cross(inner - (1, 1), (1, 3)), 0).sum() >= 1


def test_lines_alone_enclose_a_domain():
    lines = [LineString([(0, 0), (1, 0), (1, 1)]), LineString([(1, 1), (0, 1), (0, 0)]), None]
    check_mesh(qm.mesh(lines), 1)


def test_a_coast_of_lines_that_cross():
    check_mesh(qm.mesh([LineString([(0, -1), (0, 2)]), LineString([(1, -1), (1, 2)]),
                        LineString([(-1, 0), (2, 0)]), LineString([(-1, 1), (2, 1)])]), 1)


@pytest.mark.parametrize('geometry, kind', [
    (LineString([(0, 0), (1, 1)]), 'no_area'), (LineString([(0, 0), (1, 1), (1, 0)]), 'no_domain'),
    (Point(0, 0), 'no_area'), ([], 'no_domain'), (Polygon(), 'no_domain'),
    (Polygon([(0, 0), (1, 1), (0, 0)]), 'unreadable'), (Polygon([(0, 0), (1, float('nan')), (0, 1)]), 'not_finite')])
def test_geometries_that_cannot_be_meshed(geometry, kind):
    with pytest.raises(qm.GraphError) as error:
        qm.mesh(geometry)
    assert error.value.kind == kind


def test_errors_name_the_geometry():
    with pytest.raises(qm.GraphError, match='geometry 1: a ring'):
        qm.mesh([LAKE, Polygon([(0, 0), (1, 1), (0, 0)])])


@pytest.mark.parametrize('geometry', ['lake', 5, [LAKE, 5], np.zeros((3, 2))])
def test_what_is_no_geometry(geometry):
    with pytest.raises(TypeError, match='geometry'):
        qm.mesh(geometry)


@pytest.mark.parametrize('kwargs, error', [
    (dict(holes=[[0, 0]]), TypeError), (dict(region='name'), TypeError), (dict(max_area=[1, 2, 3]), ValueError),
    (dict(region=[1, 2]), ValueError), (dict(max_area=[-1]), ValueError), (dict(region=3), TypeError)])
def test_bad_arguments(kwargs, error):
    with pytest.raises(error):
        qm.mesh(LAKE, **kwargs)


# --- GeoPandas ---

def frame(**kwargs):
    geopandas = pytest.importorskip('geopandas')
    return geopandas.GeoDataFrame(
        dict(name=['deep', None, 'flat'], depth=[10.0, np.nan, 1.5], area=[0.05, 0, np.nan]), index=[7, 8, 9],
        geometry=[box(0, 0, 2, 2), None, box(2, 0, 4, 2)], **kwargs)


def test_columns_become_regions():
    mesh = qm.mesh(frame(), region='depth', max_area='area')
    check_mesh(mesh, 8)
    left = mesh.vertices[mesh.triangles].mean(axis=1)[:, 0] < 2
    assert (mesh.values_of_triangles() == np.where(left, 10, 1.5)).all()
    assert mesh.areas()[left].max() <= 0.05 < mesh.areas()[~left].max()
    texts = qm.mesh(frame(), region='name').values_of_triangles(missing='')
    assert set(texts) == {'deep', 'flat'}
    assert set(qm.mesh(frame()).values_of_triangles()) == {7, 9}
    assert set(qm.mesh(frame(), region=['a', 'b', 'c']).values_of_triangles(missing='')) == {'a', 'c'}
    with pytest.raises(ValueError, match='no such column'):
        qm.mesh(frame(), region='height')


def test_reference_systems_are_kept():
    utm = frame(crs=32632)
    with warnings.catch_warnings():
        warnings.simplefilter('error')
        assert qm.mesh(utm).crs == utm.crs
        assert qm.mesh(utm.geometry).crs == utm.crs
        assert qm.mesh(frame()).crs is None
    with pytest.warns(qm.DegreesWarning, match='WGS 84'):
        mesh = qm.mesh(frame(crs=4326), project='none')
    polygons = mesh.to_geopandas()
    assert polygons.crs == mesh.crs and np.isclose(sum(p.area for p in polygons.geometry), 8)
    assert set(polygons.columns) == {'region', 'value', 'least_angle', 'geometry'}


def test_from_a_file(tmp_path):
    geopandas = pytest.importorskip('geopandas')
    path = tmp_path / 'lakes.gpkg'
    frame(crs=32632).dropna(subset=['geometry']).to_file(path, driver='GPKG')
    mesh = qm.mesh(geopandas.read_file(path), region='depth', min_angle=25)
    check_mesh(mesh, 8)
    assert mesh.report and mesh.angles().min() >= 25
