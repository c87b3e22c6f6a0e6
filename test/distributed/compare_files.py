#!/usr/bin/env python3
"""Compares the files of a mesh that ranks have written with those that one machine has, by readers that are not ours.

usage: compare_files.py FOLDER RANKS

For each mesh FOLDER/whole/NAME.vtkhdf, h5py finds the same arrays in FOLDER/NAME.vtkhdf and .h5, and read_back.py, which
is for other tests, too, prints the same of FOLDER/NAME.* as of FOLDER/whole/NAME.*: of .vtkhdf and .xdmf by h5py, of
Gmsh's parts by gmsh, with their ghosts, and of VTK's pieces by meshio. There are as many parts as ranks, but no more than
triangles.
"""

import os
import subprocess
import sys

import h5py

READ_BACK = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "read_back.py")


def contents(file_name):
    """Groups and arrays with their attributes, by name."""
    found = {}

    def visit(name, item):
        values = (item.dtype, item.shape, item[:].tobytes()) if isinstance(item, h5py.Dataset) else None
        found[name] = (values, {key: bytes(value) for key, value in item.attrs.items()})

    with h5py.File(file_name, "r") as file:
        file.visititems(visit)
    return found


def listing(reader, files):
    arguments = [word for file in files for word in (reader, file)]
    return subprocess.run([sys.executable, READ_BACK, *arguments], check=True, stdout=subprocess.PIPE).stdout


def count(folder, name, ending):
    part = 1
    while os.path.exists(os.path.join(folder, "{}_{}{}".format(name, part, ending))):
        part += 1
    return part - 1


def main(folder, ranks):
    whole = os.path.join(folder, "whole")
    names = sorted(name[:-len(".vtkhdf")] for name in os.listdir(whole) if name.endswith(".vtkhdf"))
    assert len(names) >= 7, names
    with_triangles = []
    for name in names:
        for ending in (".vtkhdf", ".h5"):
            ours, theirs = (contents(os.path.join(at, name + ending)) for at in (folder, whole))
            assert ours == theirs and len(ours) > 5, name + ending
            if ending == ".h5":
                triangles = ours["mesh/triangles"][0][1][0]
        for ending in (".msh", ".vtu"):
            assert count(folder, name, ending) == min(ranks, max(1, triangles)), name + ending
        if triangles > 0:
            with_triangles.append(name)
    for reader, ending in (("h5py", ".vtkhdf"), ("h5py", ".xdmf"), ("gmsh", ".msh"), ("meshio", ".pvtu")):
        ours, theirs = (listing(reader, [os.path.join(at, name + ending) for name in with_triangles])
                        for at in (folder, whole))
        assert ours == theirs and len(ours) > 1000, ending
    print(len(names), "meshes are the same")


main(sys.argv[1], int(sys.argv[2]))
