"""The package and the program quality_mesh make the same meshes, bit for bit."""

import gzip
import os
import subprocess

import numpy as np
import pytest
import quadtree_mesh as qm
from shapes import GREAT_LAKES, SQUARE, annulus, read_poly

PROGRAM = os.environ.get('QUADTREE_MESH_PROGRAM')
pytestmark = pytest.mark.skipif(not PROGRAM, reason='QUADTREE_MESH_PROGRAM does not name the program')


def write_poly(path, graph):
    holes = graph.get('holes', [])
    lines = [f"{len(graph['vertices'])} 2 0 0"]
    lines += [f'{i} {x!r} {y!r}' for i, (x, y) in enumerate(np.asarray(graph['vertices'], float).tolist())]
    lines += [f"{len(graph['segments'])} 0"] + [f'{i} {a} {b}' for i, (a, b) in enumerate(graph['segments'])]
    lines += [str(len(holes))] + [f'{i} {x!r} {y!r}' for i, (x, y) in enumerate(np.asarray(holes, float).tolist())]
    path.write_text('\n'.join(lines) + '\n')


def rows_of(path):
    with open(path, encoding='ascii') as file:
        return [line.split() for line in file if not line.startswith('#')][1:]


def run(tmp_path, source, *options):
    """Vertices and triangles, counted from 0, by the program."""
    subprocess.run([PROGRAM, str(source), *options, '--quiet', '-o', str(tmp_path / 'out.ele')], check=True)
    nodes, elements = rows_of(tmp_path / 'out.node'), rows_of(tmp_path / 'out.ele')
    first = int(nodes[0][0])
    return (np.array([row[1:3] for row in nodes], float), np.array([row[1:4] for row in elements], int) - first)


def assert_same(mesh, made):
    assert mesh.vertices.tobytes() == made[0].tobytes()
    assert (mesh.triangles == made[1]).all()


@pytest.mark.parametrize('options, kwargs', [
    ([], {}),
    (['--min-angle', '30', '--max-area', '0.01'], dict(min_angle=30, max_area=0.01)),
    (['--max-edge', '0.2', '--smooth', '2', '--thin', '1'], dict(max_edge=0.2, smooth=2, thin=1)),
    (['--separation', 'theorem-5'], dict(separation='theorem_5'))])
def test_graphs(tmp_path, options, kwargs):
    for graph in (SQUARE, annulus()):
        write_poly(tmp_path / 'in.poly', graph)
        assert_same(qm.mesh(**graph, **kwargs), run(tmp_path, tmp_path / 'in.poly', *options))


def test_the_great_lakes(tmp_path):
    with gzip.open(GREAT_LAKES, 'rt') as file:
        graph = read_poly(file)
    mesh = qm.mesh(**graph, min_angle=25)
    assert_same(mesh, run(tmp_path, GREAT_LAKES, '--min-angle', '25'))
    assert len(mesh.triangles) > 10000


@pytest.mark.parametrize('options, kwargs', [
    (['--mode', 'points'], dict(angles='least')), (['--mode', 'acute'], dict(angles='acute')),
    (['--mode', 'bounded'], dict(angles=(36, 80))), (['--mode', 'warped'], dict(angles='warped'))])
def test_points(tmp_path, options, kwargs):
    points = np.random.default_rng(2).uniform(0, 1, (50, 2))
    (tmp_path / 'in.xy').write_text(''.join(f'{x!r} {y!r}\n' for x, y in points.tolist()))
    assert_same(qm.mesh_points(points, **kwargs), run(tmp_path, tmp_path / 'in.xy', *options))
