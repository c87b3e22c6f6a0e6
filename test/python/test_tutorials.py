"""The tutorials: their blocks run one after the other, in an empty folder."""

import os
import re
import subprocess

import pytest
from shapes import ROOT

PROGRAM = os.environ.get('QUADTREE_MESH_PROGRAM')


@pytest.mark.skipif(not PROGRAM, reason='QUADTREE_MESH_PROGRAM is not set')
def test_tutorials(tmp_path, monkeypatch):
    for package in ('scipy.sparse', 'meshio'):
        pytest.importorskip(package)
    pytest.importorskip('matplotlib').use('Agg')
    with open(os.path.join(ROOT, 'doc', 'tutorials.md'), encoding='utf-8') as file:
        blocks = re.findall(r'^```(sh|python)\n(.*?)^```', file.read(), re.MULTILINE | re.DOTALL)
    assert {language for language, _ in blocks} == {'sh', 'python'}
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv('PATH', os.path.dirname(PROGRAM) + os.pathsep + os.environ['PATH'])
    names = {}
    for language, block in blocks:
        if language == 'python':
            exec(compile(block, 'doc/tutorials.md', 'exec'), names)
        else:
            done = subprocess.run(['bash', '-e', '-c', block], capture_output=True, text=True)
            assert done.returncode == 0, block + done.stdout + done.stderr
    for name in ('bay.gr3', 'bay.2dm', 'bay.svg', 'bay.json', 'disk.png', 'channel.mesh'):
        assert os.path.getsize(name) > 0, name
