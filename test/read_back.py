#!/usr/bin/env python3
"""Reads mesh files by readers that are not ours and prints what is in them, for test_written_formats.cpp.

usage: read_back.py READER FILE [READER FILE]...

READER is meshio, or gmsh, which must not warn. For each file: its points in their order, `p x y` as the bits of the
doubles, behind them their marker if the file has one; then, sorted, triangles `t a b c region` and edges `e a b marker`;
then further numbers of triangles, sorted, `NAME a b c bits`.
"""

import contextlib
import struct
import sys

import meshio


def bits(number):
    return struct.unpack("<Q", struct.pack("<d", float(number)))[0]


def number_in(name):
    """The region or marker in the name of a physical group; -1 for none."""
    word = name.split(",")[0].split()
    return int(word[1]) if word[0] in ("region", "marker") else -1


def report(points, triangles, edges, markers=None, fields=()):
    for i, p in enumerate(points):
        assert len(p) == 2 or p[2] == 0, "z is not 0"
        print("p", bits(p[0]), bits(p[1]), *([] if markers is None else [int(markers[i])]))
    for line in sorted("t {} {} {} {}".format(*map(int, t)) for t in triangles):
        print(line)
    for line in sorted("e {} {} {}".format(*map(int, e)) for e in edges):
        print(line)
    for name, values in fields:
        for line in sorted("{} {} {} {} {}".format(name, *map(int, t[:3]), bits(x)) for t, x in zip(triangles, values)):
            print(line)


def cells_with(mesh, kind, values):
    """Cells of a kind, each with its value."""
    return [[*cell, value] for block, data in zip(mesh.cells, values) if block.type == kind
            for cell, value in zip(block.data, data)]


def values_of(mesh, kind, name):
    return [x for block, data in zip(mesh.cells, mesh.cell_data[name]) if block.type == kind for x in data]


def read_by_meshio(file_name):
    with contextlib.redirect_stdout(sys.stderr):  # it prints blank lines
        mesh = meshio.read(file_name)
    if file_name.endswith(".mesh"):
        references = mesh.cell_data.get("medit:ref", [])
        triangles = [[*t[:3], t[3] - 1] for t in cells_with(mesh, "triangle", references)]
        return report(mesh.points, triangles, cells_with(mesh, "line", references), mesh.point_data["medit:ref"])
    if file_name.endswith(".msh"):
        names = {(dim, tag): number_in(name) for name, (tag, dim) in mesh.field_data.items()}
        groups = mesh.cell_data.get("gmsh:physical", [])
        triangles = [[*t[:3], names[2, t[3]]] for t in cells_with(mesh, "triangle", groups)]
        edges = [[*e[:2], names[1, e[2]]] for e in cells_with(mesh, "line", groups)]
        return report(mesh.points, triangles, edges)
    if not mesh.cells:
        return report(mesh.points, [], [])
    fields = [(name, values_of(mesh, "triangle", name)) for name in mesh.cell_data if name not in ("region", "marker")]
    report(mesh.points, cells_with(mesh, "triangle", mesh.cell_data["region"]),
           cells_with(mesh, "line", mesh.cell_data["marker"]), mesh.point_data.get("marker"), fields)


def elements_by_gmsh(gmsh, dim, nodes):
    for _, tag in gmsh.model.getEntities(dim):
        (group,) = gmsh.model.getPhysicalGroupsForEntity(dim, tag)
        value = number_in(gmsh.model.getPhysicalName(dim, group))
        for ends in gmsh.model.mesh.getElements(dim, tag)[2]:
            for i in range(0, len(ends), nodes):
                yield [*(int(v) - 1 for v in ends[i:i + nodes]), value]


def read_by_gmsh(file_name):
    import gmsh
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.logger.start()
    gmsh.open(file_name)
    complaints = [line for line in gmsh.logger.get() if not line.startswith("Info")]
    assert not complaints, complaints
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    points = {int(tag): coordinates[3 * i:3 * i + 3] for i, tag in enumerate(tags)}
    report([points[tag] for tag in sorted(points)], list(elements_by_gmsh(gmsh, 2, 3)),
           list(elements_by_gmsh(gmsh, 1, 2)))
    gmsh.logger.stop()
    gmsh.finalize()


for reader, file_name in zip(sys.argv[1::2], sys.argv[2::2]):
    print("==", reader, file_name.rsplit(".", 1)[1])
    {"meshio": read_by_meshio, "gmsh": read_by_gmsh}[reader](file_name)
