"""Has CMake build the extension module, by the project's CMakeLists.txt, and no more of the library than it needs."""

import os
import re
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))


def version():
    with open(os.path.join(ROOT, 'CMakeLists.txt'), encoding='utf-8') as file:
        return re.search(r'^  VERSION ([\d.]+)$', file.read(), re.MULTILINE).group(1)


class BuildByCMake(build_ext):
    def build_extension(self, ext):
        folder = os.path.join(ROOT, 'build', 'pip-' + sys.implementation.cache_tag)
        module = os.path.abspath(self.get_ext_fullpath(ext.name))
        switches = dict(CMAKE_BUILD_TYPE='Release', Python_EXECUTABLE=sys.executable,
                        QUADTREE_MESH_2_PYTHON_DIR=os.path.dirname(module),
                        QUADTREE_MESH_2_COMPILE_FOR_PYTHON='ON', QUADTREE_MESH_2_BUILD_EXAMPLES='OFF',
                        QUADTREE_MESH_2_BUILD_TESTS='OFF', QUADTREE_MESH_2_BUILD_BENCHMARK='OFF')
        subprocess.check_call(['cmake', '-S', ROOT, '-B', folder, '-Wno-dev',
                               *(f'-D{name}={value}' for name, value in switches.items())])
        subprocess.check_call(['cmake', '--build', folder, '--target', 'quadtree_mesh_python',
                               '--parallel', str(os.cpu_count() or 1)])
        if not os.path.exists(module):
            raise RuntimeError('CMake has not built the module: see its messages on pybind11 and Python above')


setup(version=version(), ext_modules=[Extension('quadtree_mesh._core', sources=[])],
      cmdclass=dict(build_ext=BuildByCMake))
