"""Triangle meshes with guaranteed angles, of polygons, planar straight-line graphs and points.

    import geopandas, quadtree_mesh
    lakes = geopandas.read_file('lakes.gpkg')
    mesh = quadtree_mesh.mesh(lakes.to_crs(lakes.estimate_utm_crs()), min_angle=25, max_area=1e6)
    mesh.plot()
    mesh.to_meshio().write('lakes.vtu')

`mesh()` meshes polygons and graphs, `mesh_points()` points; `refine()` and `adapt()` change a mesh; `Quadtree` is a
quadtree by itself. `triangle` and `meshpy` stand in for the packages of these names.
"""

from . import meshpy, triangle
from ._core import version as __version__
from .adaptation import adapt, refine
from .errors import DegreesWarning, GraphError, MeshingError, PointError
from .geometry import graph, read
from .meshing import mesh, mesh_points
from .quadtree import Quadtree
from .results import Mesh, Report
from .sizes import SizeGrid, SizePoints, size_grid

__all__ = ['mesh', 'mesh_points', 'refine', 'adapt', 'graph', 'read', 'Quadtree', 'SizeGrid', 'SizePoints',
           'size_grid', 'Mesh', 'Report',
           'MeshingError', 'GraphError', 'PointError', 'DegreesWarning', 'triangle', 'meshpy', '__version__']
