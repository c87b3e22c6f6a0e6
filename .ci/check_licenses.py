#!/usr/bin/env python3
"""Checks which public headers include parts of CGAL that are under the GPL.

The table in the section "Parts of CGAL" of doc/development.md lists these headers. All others may reach only headers of
CGAL under the LGPL or a more permissive license. What a header reaches is what the compiler's preprocessor reads, with
TBB and all optional libraries; the license of a header of CGAL is in its first lines. Prints what is wrong, one line
each; the exit status is 1 if there is anything. The compiler is $CXX, g++ by default.
"""

import glob
import os
import re
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
INCLUDE = os.path.join(ROOT, 'include')
LISTED_HEADER = re.compile(r'^\| `(CGAL/[\w/]+\.h)` \|', re.MULTILINE)
LICENSE_LINE = re.compile(r'SPDX-License-Identifier: *(\S+)')
FREE_LICENSES = ('LGPL-', 'BSL-', 'MIT', 'BSD-')
HEAD = 3000  # characters that hold the license
MPI = [word for folder in glob.glob('/usr/lib/*/openmpi/include') for word in ('-isystem', folder)]
COMMAND = [os.environ.get('CXX', 'g++'), '-std=c++17', '-M', '-DCGAL_LINKED_WITH_TBB', '-I', INCLUDE,
           '-isystem', '/usr/include/eigen3', '-isystem', '/usr/include/hdf5/serial', '-isystem', '/usr/include/gdal',
           '-DOMPI_SKIP_MPICXX', *MPI, '-x', 'c++', '-']


def public_headers():
    for folder in ('CGAL', 'CGAL/IO', 'CGAL/Quadtree_mesh_2'):
        for name in sorted(os.listdir(os.path.join(INCLUDE, folder))):
            if name.endswith('.h'):
                yield f'{folder}/{name}'


def files_read_for(headers):
    """The files that the preprocessor reads for the headers together."""
    source = ''.join(f'#include <{header}>\n' for header in headers)
    rule = subprocess.run(COMMAND, input=source, stdout=subprocess.PIPE, text=True, check=True).stdout
    return rule.replace('\\\n', ' ').split()[1:]


def is_gpl(file):
    """Whether a header of CGAL is under the GPL, or is the mark of a part that is."""
    if '/CGAL/license/' in file:
        return not file.endswith('/lgpl.h')
    with open(file, encoding='utf-8', errors='replace') as text:
        license_line = LICENSE_LINE.search(text.read(HEAD))
    return not (license_line and license_line.group(1).startswith(FREE_LICENSES))


def gpl_files_read_for(headers):
    files = {os.path.realpath(file) for file in files_read_for(headers)}
    return sorted(file for file in files
                  if '/CGAL/' in file and not file.startswith(os.path.realpath(INCLUDE)) and is_gpl(file))


with open(os.path.join(ROOT, 'doc', 'development.md'), encoding='utf-8') as document:
    listed = LISTED_HEADER.findall(document.read())
free = [header for header in public_headers() if header not in listed]
errors = []
if gpl_files_read_for(free):  # all at once are read in seconds; the culprit is looked for only if there is one
    for header in free:
        found = gpl_files_read_for([header])
        if found:
            errors.append(f'{header}: reaches {found[0]}, which is under the GPL, and is not listed in '
                          'doc/development.md')
for header in listed:
    if not os.path.exists(os.path.join(INCLUDE, header)):
        errors.append(f'doc/development.md: {header} does not exist')
    elif not gpl_files_read_for([header]):
        errors.append(f'doc/development.md: {header} reaches nothing of CGAL under the GPL')
for error in errors:
    print(error)
print(f'{len(free)} headers that reach no part of CGAL under the GPL, {len(listed)} that do, {len(errors)} errors')
sys.exit(1 if errors else 0)
