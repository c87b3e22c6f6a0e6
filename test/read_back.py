#!/usr/bin/env python3
"""Reads mesh files by readers that are not ours and prints what is in them, for test_written_formats.cpp.

usage: read_back.py READER FILE [READER FILE]...

READER is
- meshio, also for .pvtu, of which it reads the pieces
- gmsh, which must not warn, also for the parts FILE_1.msh, FILE_2.msh ... of FILE.msh if that is not there
- h5py, for .vtkhdf, and for .xdmf, whose arrays are in a file of HDF5
- meshio_2nd and gmsh_2nd, for elements of second order: behind the vertices of triangles and edges are their nodes, and
  there are no regions

For each file: its points in their order, `p x y` as the bits of the doubles, behind them their marker and their index in
the input if the file has these; then, sorted, triangles `t a b c region` and edges `e a b marker`; then further numbers
of triangles, sorted, `NAME a b c bits`.
"""

import contextlib
import itertools
import os
import struct
import sys
import xml.etree.ElementTree

import meshio


def bits(number):
    return struct.unpack("<Q", struct.pack("<d", float(number)))[0]


def number_in(name):
    """The region or marker in the name of a physical group; -1 for none."""
    word = name.split(",")[0].split()
    return int(word[1]) if word[0] in ("region", "marker") else -1


def report(points, triangles, edges, columns=(), fields=()):
    """:param columns: further numbers of points; None for those that the file has not"""
    columns = [column for column in columns if column is not None]
    for i, p in enumerate(points):
        assert len(p) == 2 or p[2] == 0, "z is not 0"
        print("p", bits(p[0]), bits(p[1]), *(int(column[i]) for column in columns))
    for line in sorted("t {} {} {} {}".format(*map(int, t)) for t in triangles):
        print(line)
    for line in sorted("e {} {} {}".format(*map(int, e)) for e in edges):
        print(line)
    for name, values in fields:
        for line in sorted("{} {} {} {} {}".format(name, *map(int, t[:3]), bits(x)) for t, x in zip(triangles, values)):
            print(line)


# --- meshio ---


def read_quietly(file_name):
    with contextlib.redirect_stdout(sys.stderr):  # it prints blank lines
        return meshio.read(file_name)


def cells_with(mesh, kind, values):
    """Cells of a kind, each with its value."""
    return [[*cell, value] for block, data in zip(mesh.cells, values) if block.type == kind
            for cell, value in zip(block.data, data)]


def values_of(mesh, kind, name):
    return [x for block, data in zip(mesh.cells, mesh.cell_data[name]) if block.type == kind for x in data]


def read_pieces(file_name):
    """Puts the pieces of a .pvtu file together by their global numbers. Copies of a point have to be the same."""
    root = xml.etree.ElementTree.parse(file_name).getroot()
    points, cells = {}, {}
    for piece in root.iter("Piece"):
        mesh = read_quietly(os.path.join(os.path.dirname(file_name), piece.get("Source")))
        numbers = mesh.point_data["GlobalPointIds"]
        for i, number in enumerate(numbers):
            data = [tuple(mesh.points[i]), {name: x[i] for name, x in mesh.point_data.items() if name != "GlobalPointIds"}]
            assert points.setdefault(int(number), data) == data, "copies of a point differ"
        for b, block in enumerate(mesh.cells):
            for i, cell in enumerate(block.data):
                number = int(mesh.cell_data["GlobalCellIds"][b][i])
                assert number not in cells, "a cell is in two pieces"
                data = {name: x[b][i] for name, x in mesh.cell_data.items() if name != "GlobalCellIds"}
                cells[number] = [block.type, [int(numbers[v]) for v in cell], data]
    assert sorted(points) == list(range(len(points))) and sorted(cells) == list(range(len(cells))), "some are missing"
    declared = {array.get("Name") for array in root.find("PUnstructuredGrid/PCellData")}
    triangles = [c for _, c in sorted(cells.items()) if c[0] == "triangle"]
    lines = [c for _, c in sorted(cells.items()) if c[0] == "line"]
    names = list(triangles[0][2])
    assert declared == {*names, "GlobalCellIds"}, "not what the .pvtu file says"
    column = [[points[i][1].get(name) for i in range(len(points))] for name in ("marker", "input_index")]
    report([points[i][0] for i in range(len(points))], [[*c[1], c[2]["region"]] for c in triangles],
           [[*c[1], c[2]["marker"]] for c in lines], [c if c[0] is not None else None for c in column],
           [(name, [c[2][name] for c in triangles]) for name in names if name not in ("region", "marker")])


def read_by_meshio(file_name):
    if file_name.endswith(".pvtu"):
        return read_pieces(file_name)
    mesh = read_quietly(file_name)
    if file_name.endswith(".mesh"):
        references = mesh.cell_data.get("medit:ref", [])
        triangles = [[*t[:3], t[3] - 1] for t in cells_with(mesh, "triangle", references)]
        return report(mesh.points, triangles, cells_with(mesh, "line", references), [mesh.point_data["medit:ref"]])
    if file_name.endswith(".msh"):
        names = {(dim, tag): number_in(name) for name, (tag, dim) in mesh.field_data.items()}
        groups = mesh.cell_data.get("gmsh:physical", [])
        triangles = [[*t[:3], names[2, t[3]]] for t in cells_with(mesh, "triangle", groups)]
        edges = [[*e[:2], names[1, e[2]]] for e in cells_with(mesh, "line", groups)]
        return report(mesh.points, triangles, edges, [mesh.point_data.get("input_index")])
    if not mesh.cells:
        return report(mesh.points, [], [])
    fields = [(name, values_of(mesh, "triangle", name)) for name in mesh.cell_data if name not in ("region", "marker")]
    report(mesh.points, cells_with(mesh, "triangle", mesh.cell_data["region"]),
           cells_with(mesh, "line", mesh.cell_data["marker"]),
           [mesh.point_data.get("marker"), mesh.point_data.get("input_index")], fields)


# --- gmsh ---


@contextlib.contextmanager
def opened_by_gmsh(file_name):
    import gmsh
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.logger.start()
    gmsh.open(file_name)
    complaints = [line for line in gmsh.logger.get() if not line.startswith(("Info", "Progress"))]
    assert not complaints, complaints
    yield gmsh
    gmsh.logger.stop()
    gmsh.finalize()


def elements_by_gmsh(gmsh, dim, nodes):
    """Pairs of an element's number and its vertices with the value of its entity; ghosts have none."""
    for _, tag in gmsh.model.getEntities(dim):
        if gmsh.model.getType(dim, tag) == "Ghost surface":
            continue
        (group,) = gmsh.model.getPhysicalGroupsForEntity(dim, tag)
        value = number_in(gmsh.model.getPhysicalName(dim, group))
        for numbers, ends in zip(*gmsh.model.mesh.getElements(dim, tag)[1:]):
            for i, number in enumerate(numbers):
                yield int(number), [*(int(v) - 1 for v in ends[i * nodes:(i + 1) * nodes]), value]


def points_by_gmsh(gmsh):
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    return {int(tag) - 1: tuple(coordinates[3 * i:3 * i + 3]) for i, tag in enumerate(tags)}


def input_index_by_gmsh(gmsh):
    views = gmsh.view.getTags()
    if not len(views):
        return {}
    _, tags, data, _, _ = gmsh.view.getModelData(views[0], 0)
    return {int(tag) - 1: int(x[0]) for tag, x in zip(tags, data)}


def report_by_gmsh(points, index, triangles, edges):
    assert sorted(points) == list(range(len(points)))
    assert not index or sorted(index) == sorted(points)
    report([points[v] for v in sorted(points)], triangles.values(), edges.values(),
           [[index[v] for v in sorted(points)] if index else None])


def check_ghosts(owners, ghosts, triangles):
    """That each part has the triangles of others at its own vertices, with their owners."""
    for part, found in ghosts.items():
        vertices = {v for t, owner in owners.items() if owner == part for v in triangles[t][:3]}
        wanted = {t: owner for t, owner in owners.items() if owner != part and vertices.intersection(triangles[t][:3])}
        assert found == wanted, "the ghosts of part {} are wrong".format(part)


def read_parts(stem):
    points, index, triangles, edges, owners, ghosts = {}, {}, {}, {}, {}, {}
    for part in itertools.count(1):
        name = "{}_{}.msh".format(stem, part)
        if not os.path.exists(name):
            break
        with opened_by_gmsh(name) as gmsh:
            for v, p in points_by_gmsh(gmsh).items():
                assert points.setdefault(v, p) == p, "copies of a point differ"
            index.update(input_index_by_gmsh(gmsh))
            for dim, nodes, elements in ((1, 2, edges), (2, 3, triangles)):
                here = dict(elements_by_gmsh(gmsh, dim, nodes))
                assert not here.keys() & elements.keys(), "an element is in two parts"
                elements.update(here)
            owners.update(dict.fromkeys([t for t in triangles if t not in owners], part))
            ghosts[part] = {}
            for dim, tag in gmsh.model.getEntities(2):
                kind = gmsh.model.getType(dim, tag)
                if kind in ("Partition surface", "Ghost surface"):
                    assert list(gmsh.model.getPartitions(dim, tag)) == [part]
                if kind == "Ghost surface":
                    numbers, of_parts = gmsh.model.mesh.getGhostElements(dim, tag)
                    assert sorted(numbers) == sorted(n for ns in gmsh.model.mesh.getElements(dim, tag)[1] for n in ns)
                    ghosts[part] = {int(n): int(p) for n, p in zip(numbers, of_parts)}
    check_ghosts(owners, ghosts, triangles)
    report_by_gmsh(points, index, triangles, edges)


def read_by_gmsh(file_name):
    if not os.path.exists(file_name):
        return read_parts(file_name[:-len(".msh")])
    with opened_by_gmsh(file_name) as gmsh:
        report_by_gmsh(points_by_gmsh(gmsh), input_index_by_gmsh(gmsh), dict(elements_by_gmsh(gmsh, 2, 3)),
                       dict(elements_by_gmsh(gmsh, 1, 2)))


# --- h5py ---


def read_vtkhdf(file_name):
    import h5py
    with h5py.File(file_name, "r") as file:
        grid = file["VTKHDF"]
        assert bytes(grid.attrs["Type"]) == b"UnstructuredGrid" and list(grid.attrs["Version"]) == [1, 0]
        points, connectivity, offsets, types = (grid[name][:] for name in ("Points", "Connectivity", "Offsets", "Types"))
        sizes = [int(grid[name][0]) for name in ("NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds")]
        assert sizes == [len(points), len(types), len(connectivity)] and len(offsets) == len(types) + 1
        cells = [connectivity[a:b] for a, b in zip(offsets, offsets[1:])]
        data = {name: values[:] for name, values in grid["CellData"].items()}
        triangles = [i for i, kind in enumerate(types) if kind == 5]
        lines = [i for i, kind in enumerate(types) if kind == 3]
        report(points, [[*cells[i], data["region"][i]] for i in triangles], [[*cells[i], data["marker"][i]] for i in lines],
               [grid["PointData"].get(name) for name in ("marker", "input_index")],
               [(name, values[triangles]) for name, values in ordered(data) if name not in ("region", "marker")])


def ordered(data):
    """HDF5 sorts by names; other formats keep the order in which fields are written."""
    first = [name for name in ("least_angle", "attribute") if name in data]
    return [(name, data[name]) for name in first + sorted(set(data) - set(first), reverse=True)]


def read_xdmf(file_name):
    import h5py
    root = xml.etree.ElementTree.parse(file_name).getroot()
    assert root.get("Version") == "3.0"

    def array(item):
        heavy, path = item.text.split(":")
        with h5py.File(os.path.join(os.path.dirname(file_name), heavy), "r") as file:
            values = file[path][:]
        assert list(values.shape) == [int(n) for n in item.get("Dimensions").split()]
        assert values.dtype.itemsize == int(item.get("Precision"))
        assert values.dtype.kind == {"Float": "f", "Int": "i"}[item.get("NumberType")]
        return values

    grids = {}
    for grid in root.iter("Grid"):
        data = {a.get("Center") + " " + a.get("Name"): array(a.find("DataItem")) for a in grid.findall("Attribute")}
        cells = array(grid.find("Topology/DataItem"))
        assert len(cells) == int(grid.find("Topology").get("NumberOfElements"))
        grids[grid.get("Name")] = (array(grid.find("Geometry/DataItem")), cells, data)
    points, triangles, data = grids["mesh"]
    _, edges, edge_data = grids.get("edges", (points, [], {"Cell marker": []}))
    cell_data = {name[len("Cell "):]: values for name, values in data.items() if name.startswith("Cell ")}
    report(points, [[*t, region] for t, region in zip(triangles, cell_data.pop("region"))],
           [[*e, marker] for e, marker in zip(edges, edge_data["Cell marker"])],
           [data.get("Node marker"), data.get("Node input_index")], cell_data.items())


def read_by_h5py(file_name):
    (read_xdmf if file_name.endswith(".xdmf") else read_vtkhdf)(file_name)


# --- elements of second order ---


def report_second_order(points, triangles, edges):
    for p in points:
        print("p", bits(p[0]), bits(p[1]))
    for letter, elements in (("t", triangles), ("e", edges)):
        for line in sorted(" ".join([letter, *map(str, map(int, e))]) for e in elements):
            print(line)


def read_second_order_by_meshio(file_name):
    mesh = read_quietly(file_name)
    if file_name.endswith(".msh"):
        names = {(dim, tag): number_in(name) for name, (tag, dim) in mesh.field_data.items()}
        markers = [[names[1, tag] if block.type == "line3" else 0 for tag in data]
                   for block, data in zip(mesh.cells, mesh.cell_data["gmsh:physical"])]
    else:
        markers = mesh.cell_data["marker"]
    assert {block.type for block in mesh.cells} == {"triangle6", "line3"}
    triangles = [t for block in mesh.cells if block.type == "triangle6" for t in block.data]
    report_second_order(mesh.points, triangles, cells_with(mesh, "line3", markers))


def read_second_order_by_gmsh(file_name):
    with opened_by_gmsh(file_name) as gmsh:
        points = points_by_gmsh(gmsh)
        triangles = [t[:6] for _, t in elements_by_gmsh(gmsh, 2, 6)]
        edges = [e for _, e in elements_by_gmsh(gmsh, 1, 3)]
    report_second_order([points[v] for v in sorted(points)], triangles, edges)


for reader, name in zip(sys.argv[1::2], sys.argv[2::2]):
    print("==", reader, name.rsplit(".", 1)[1])
    {"meshio": read_by_meshio, "gmsh": read_by_gmsh, "h5py": read_by_h5py,
     "meshio_2nd": read_second_order_by_meshio, "gmsh_2nd": read_second_order_by_gmsh}[reader](name)
