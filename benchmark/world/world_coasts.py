#!/usr/bin/python3
# Copyright (c) 2026 The Quadtree_mesh_2 authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Quadtree_mesh_2 authors
"""Makes one graph of all coastlines in GSHHG's bins: world_coasts.py binned_GSHHS_f.nc GRAPH.poly

Bins are squares of one degree, in which coordinates are 16-bit words; coastlines are cut at their sides, where both
pieces end at the same point. So points merge by their words on the whole globe, exactly, and each edge is written once.

The map is Mercator's: conformal, so angles on the globe are kept; and meridians and parallels stay parallel to the axes,
so that bins stay rectangles and coastlines of different bins can meet at their ends only. Units are those of the data
along the equator, 1/65535 of a degree. The world is cut at the meridian of Greenwich and at 86 degrees, beyond all
coasts, and framed there. The marker of a segment is 1 plus the number of its bin, 0 on the frame.
"""
import sys

import netCDF4
import numpy as np

UNIT, COLUMNS, ROWS = 65535, 360, 180
LARGEST_LATITUDE = 86


def read_points(path):
    """Global words of the points of all pieces, the piece of each, and the bin of each piece."""
    data = netCDF4.Dataset(path)
    data.set_auto_maskandscale(False)

    def column(name, words=None):
        values = data.variables[name][:]
        return (values.view(words) if words else values).astype(np.int64)

    first_piece, pieces = column("Id_of_first_segment_in_a_bin"), column("N_segments_in_a_bin", np.uint16)
    bin_of_piece = np.empty(pieces.sum(), np.int64)
    for number in np.flatnonzero(pieces):
        bin_of_piece[first_piece[number]:first_piece[number] + pieces[number]] = number
    points = column("Embedded_npts_levels_exit_entry_for_a_segment") >> 9
    first_point = column("Id_of_first_point_in_a_segment")
    piece = np.repeat(np.arange(len(points)), points)
    place = np.arange(len(piece)) + np.repeat(first_point - (np.cumsum(points) - points), points)
    x = column("Relative_longitude_from_SW_corner_of_bin", np.uint16)[place]
    y = column("Relative_latitude_from_SW_corner_of_bin", np.uint16)[place]
    x += UNIT * (bin_of_piece[piece] % COLUMNS)
    y += UNIT * (ROWS - 1 - bin_of_piece[piece] // COLUMNS)
    return x, y, piece, bin_of_piece


def unique_edges(key, piece, bin_of_piece):
    """The distinct points, and per edge its two points and its bin."""
    places, point = np.unique(key, return_inverse=True)
    a, b = point[:-1], point[1:]
    is_edge = (piece[:-1] == piece[1:]) & (a != b)
    a, b, bins = a[is_edge], b[is_edge], bin_of_piece[piece[:-1][is_edge]]
    _, first = np.unique(np.minimum(a, b) * len(places) + np.maximum(a, b), return_index=True)
    return places, a[first], b[first], bins[first]


def mercator(y):
    """The ordinate of a latitude in words from the south pole."""
    latitude = np.radians(y / UNIT - 90)
    return np.degrees(np.arcsinh(np.tan(latitude))) * UNIT


def write_rows(file, pattern, columns, rows_at_once=200000):
    for begin in range(0, len(columns[0]), rows_at_once):
        rows = zip(*(c[begin:begin + rows_at_once].tolist() for c in columns))
        file.write("".join(pattern % row for row in rows))


def main():
    x, y, piece, bin_of_piece = read_points(sys.argv[1])
    places, a, b, bins = unique_edges(x * (ROWS * UNIT + 1) + y, piece, bin_of_piece)
    del x, y, piece
    n, side = len(places), mercator(UNIT * (90 + LARGEST_LATITUDE))
    corners = [(0, -side), (COLUMNS * UNIT, -side), (COLUMNS * UNIT, side), (0, side)]
    with open(sys.argv[2], "w") as file:
        file.write("%d 2 0 0\n" % (n + 4))
        write_rows(file, "%d %d %.9f\n",
                   (np.arange(n), places // (ROWS * UNIT + 1), mercator(places % (ROWS * UNIT + 1))))
        for i, corner in enumerate(corners):
            file.write("%d %d %.9f\n" % (n + i, *corner))
        file.write("%d 1\n" % (len(a) + 4))
        write_rows(file, "%d %d %d %d\n", (np.arange(len(a)), a, b, bins + 1))
        for i in range(4):
            file.write("%d %d %d 0\n" % (len(a) + i, n + i, n + (i + 1) % 4))
        file.write("0\n")


if __name__ == "__main__":
    main()
