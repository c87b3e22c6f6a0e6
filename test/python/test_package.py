"""Files, pictures, documents and types."""

import ast
import base64
import doctest
import inspect
import os
import re
import subprocess

import numpy as np
import pytest
import quadtree_mesh as qm
from shapes import ROOT, SQUARE, annulus

FOLDER = os.path.dirname(qm.__file__)


def test_version():
    with open(os.path.join(ROOT, 'CMakeLists.txt'), encoding='utf-8') as file:
        assert f'VERSION {qm.__version__}\n' in file.read()


def test_everything_public_is_documented():
    for name in qm.__all__:
        thing = getattr(qm, name)
        if name.startswith('__'):
            continue
        assert inspect.getdoc(thing), name
        members = vars(thing).items() if inspect.isclass(thing) or inspect.ismodule(thing) else ()
        for member, value in members:
            if not member.startswith('_') and inspect.isfunction(value):
                assert inspect.getdoc(value), f'{name}.{member}'


def test_docstring_examples():
    from quadtree_mesh import adaptation, meshing
    for module in (adaptation, meshing):
        assert doctest.testmod(module).failed == 0


def test_stubs_name_what_the_module_has():
    from quadtree_mesh import _core
    with open(os.path.join(FOLDER, '_core.pyi'), encoding='utf-8') as file:
        tree = ast.parse(file.read())
    stubs = {}
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            stubs[node.name] = {n.name for n in node.body}
        elif isinstance(node, ast.FunctionDef):
            stubs[node.name] = None
    public = {name for name in vars(_core) if not name.startswith('_')} - {'version'}
    assert set(stubs) == public
    for name, members in stubs.items():
        for member in members or ():
            assert hasattr(getattr(_core, name), member), f'{name}.{member}'
    assert os.path.exists(os.path.join(FOLDER, 'py.typed'))


def test_examples_of_the_documents(tmp_path, monkeypatch):
    """The blocks of Python in doc/python.md run one after the other."""
    geopandas = pytest.importorskip('geopandas')
    geometry = pytest.importorskip('shapely.geometry')
    pytest.importorskip('meshio')
    pytest.importorskip('h5py')
    pytest.importorskip('matplotlib').use('Agg')
    with open(os.path.join(ROOT, 'doc', 'python.md'), encoding='utf-8') as file:
        blocks = re.findall(r'^```python\n(.*?)^```', file.read(), re.MULTILINE | re.DOTALL)
    assert blocks
    monkeypatch.chdir(tmp_path)
    (tmp_path / 'examples').symlink_to(os.path.join(ROOT, 'examples'))
    geopandas.GeoDataFrame(dict(manning=[0.02, 0.03], max_area=[1e5, 2e5]), crs=4326, geometry=[
        geometry.box(11, 60, 11.1, 60.05), geometry.box(11.1, 60, 11.2, 60.05)]).to_file('lakes.gpkg', driver='GPKG')
    geopandas.GeoDataFrame(crs=4326, geometry=[geometry.Polygon(
        [(10, 59), (10.2, 59), (10.3, 59.1), (10.2, 59.2), (10, 59.1)])]).to_file('bay.gpkg', driver='GPKG')
    names = {}
    for block in blocks:
        exec(compile(block, 'doc/python.md', 'exec'), names)
    assert names['mesh'].report and names['polygons'].crs == 4326
    assert names['shapes'].crs == 4326
    assert set(names['friction']) == {0.02, 0.03}
    for file in ('lakes.png', 'lakes.vtu', 'bay.png', 'bay.xdmf'):
        assert os.path.getsize(file) > 0, file


def test_the_first_minute_runs_what_the_document_says():
    script = os.path.join(ROOT, 'examples', 'python', 'first_minute.sh')
    lines = subprocess.run(['bash', script, '--print'], capture_output=True, text=True, check=True).stdout
    assert re.search(r'^apt-get install .*g\+\+', lines, re.MULTILINE)
    assert 'venv/bin/pip install --no-build-isolation examples/python\n' in lines
    assert "read_file('bay.gpkg')" in lines and "savefig('bay.png')" in lines and "write('bay.xdmf'" in lines
    assert subprocess.run(['bash', script, '--print', 'a', 'b'], capture_output=True).returncode == 2


@pytest.mark.parametrize('ending, kwargs', [('vtu', {}), ('xdmf', dict(data_format='XML')), ('mesh', {}), ('off', {})])
def test_meshio(tmp_path, ending, kwargs):
    meshio = pytest.importorskip('meshio')
    mesh = qm.mesh(**annulus(), regions=[[1, 0, 3]])
    cells = mesh.to_meshio()
    if ending == 'off':
        cells = meshio.Mesh(cells.points, cells.cells[:1])
    cells.write(tmp_path / f'mesh.{ending}', **kwargs)
    again = meshio.read(tmp_path / f'mesh.{ending}')
    assert np.allclose(again.points[:, :2], mesh.vertices)
    assert (again.cells_dict['triangle'] == mesh.triangles).all()
    if ending == 'vtu':
        assert (again.cell_data_dict['region']['triangle'] == 0).all()
        assert (again.cells_dict['line'] == mesh.segments).all()
    assert len(qm.mesh_points([[0, 0], [1, 1]]).to_meshio().cells) == 1


def test_pages(tmp_path):
    def array(page, name):
        kind, text = re.search(rf'id="{name}" data-type="(\w+)">([^<]*)<', page).groups()
        return np.frombuffer(base64.b64decode(text), kind.lower())

    mesh = qm.mesh(**annulus(), max_area=0.01, regions=[[1, 0, 3.5]], max_vertices=200)
    assert len(mesh.report.unmet) > 0
    mesh.to_html(tmp_path / 'mesh.html', title='a < b', color='region')
    page = (tmp_path / 'mesh.html').read_text(encoding='utf-8')
    assert (array(page, 'points').reshape(-1, 2) == mesh.vertices).all()
    assert (array(page, 'triangles').reshape(-1, 3) == mesh.triangles).all()
    assert (array(page, 'edges').reshape(-1, 2) == mesh.segments).all()
    assert (array(page, 'regions') == mesh.regions).all()
    assert (array(page, 'unmet') == mesh.report.unmet['triangle']).all()
    assert '"color":"region","attributes":[3.5]' in page and '<h1>a &lt; b</h1>' in page
    qm.mesh_points([[0, 0], [1, 1]]).to_html(tmp_path / 'points.html', color=None)
    assert 'id="regions"' not in (tmp_path / 'points.html').read_text(encoding='utf-8')
    with pytest.raises(ValueError, match='color'):
        mesh.to_html(tmp_path / 'mesh.html', color='depth')
    with pytest.raises(FileNotFoundError):
        mesh.to_html(tmp_path / 'none' / 'mesh.html')
    mesh.triangles = mesh.triangles + len(mesh.vertices)
    with pytest.raises(ValueError, match='triangles'):
        mesh.to_html(tmp_path / 'mesh.html')
    assert (tmp_path / 'mesh.html').read_text(encoding='utf-8') == page


def test_pictures(tmp_path):
    pytest.importorskip('matplotlib').use('Agg')
    from matplotlib import pyplot
    mesh = qm.mesh(**annulus(), regions=[[1, 0, 3]])
    for color in ('angle', 'region', 'area', None, np.arange(len(mesh.triangles))):
        figure, ax = pyplot.subplots()
        assert mesh.plot(ax, color=color) is ax
        # What is drawn is what there is.
        assert np.allclose(ax.dataLim.get_points(), [mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)])
        if color is not None:
            assert len(ax.collections[0].get_array()) == len(mesh.triangles)
        figure.savefig(tmp_path / 'mesh.png')
        pyplot.close(figure)
    qm.mesh(**SQUARE).plot(edges=True, cmap='magma')
    qm.mesh(**SQUARE).plot(color='region')
    qm.Quadtree(mesh.vertices).plot()
    pyplot.close('all')
    with pytest.raises(ValueError, match='color'):
        mesh.plot(color='blue')
