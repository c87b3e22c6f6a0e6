#!/usr/bin/env python3
"""Checks the order of the house: layers, heads, guards, tests' namespaces, the width of lines, and that the checker is
independent of the meshers.

The layers are the table of rooms in doc/development.md: a header below include/CGAL/Quadtree_mesh_2/internal includes
headers of its own room and of rooms on lower levels only, be it through public headers. Prints what is wrong, one line
each; the exit status is 1 if there is anything.
"""

import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
INCLUDE = os.path.join(ROOT, 'include')
INTERNAL = 'CGAL/Quadtree_mesh_2/internal/'
ROOM_LINE = re.compile(r'^\| (\d+) \| `([a-z_0-9]+|\.)/` \|', re.MULTILINE)
MOST_HEADERS_IN_A_ROOM = 25
LONGEST_HEADER = 500
WIDEST_LINE = 120  # clang-format leaves comments as they are
# What a mesh and its input are: all that meshers and checker may share.
VOCABULARY = {
    'CGAL/Indexed_mesh_2.h', 'CGAL/Pslg_2.h', 'CGAL/Quadtree_mesh_2/Index.h',
    'CGAL/Quadtree_mesh_2/mesh_quality_types.h', 'CGAL/Quadtree_mesh_2/compiled_meshers.h',
}
MESHERS = [INTERNAL + 'Mesh_pipeline.h', INTERNAL + 'Point_set_pipeline.h']
CHECKER = 'CGAL/mesh_quality_2.h'

errors = []


def read(header):
    with open(os.path.join(INCLUDE, header), encoding='utf-8') as file:
        return file.read()


def headers_below(folder):
    for at, _, names in os.walk(os.path.join(INCLUDE, folder)):
        for name in sorted(names):
            yield os.path.relpath(os.path.join(at, name), INCLUDE)


texts = {header: read(header) for header in headers_below('CGAL')}
includes = {header: [name for name in re.findall(r'^#include <(CGAL/[^>]+)>', text, re.MULTILINE) if name in texts]
            for header, text in texts.items()}


def reached_from(header, through=lambda name: True):
    """All headers of ours that `header` includes, directly or through those that `through` accepts."""
    reached, open_headers = set(), [header]
    while open_headers:
        for name in includes[open_headers.pop()]:
            if name not in reached:
                reached.add(name)
                if through(name):
                    open_headers.append(name)
    return reached


def is_internal(header):
    return header.startswith(INTERNAL)


def room_of(header):
    """'.' for the pipelines, which are in none."""
    return os.path.dirname(header[len(INTERNAL):]) or '.'


def check_layers():
    with open(os.path.join(ROOT, 'doc', 'development.md'), encoding='utf-8') as file:
        level_of = {room: int(level) for level, room in ROOM_LINE.findall(file.read())}
    rooms = {}
    for header in filter(is_internal, texts):
        rooms.setdefault(room_of(header), []).append(header)
    for room, headers in sorted(rooms.items()):
        if room not in level_of:
            errors.append(f'{INTERNAL}{room}: not in the table of rooms in doc/development.md')
        elif len(headers) > MOST_HEADERS_IN_A_ROOM:
            errors.append(f'{INTERNAL}{room}: {len(headers)} headers, more than {MOST_HEADERS_IN_A_ROOM}')
    for room in sorted(set(level_of) - set(rooms)):
        errors.append(f'doc/development.md: room {room}/ does not exist')
    for header in filter(is_internal, texts):
        for name in sorted(reached_from(header, lambda name: not is_internal(name))):
            if not is_internal(name) or room_of(name) == room_of(header):
                continue
            if level_of.get(room_of(name), 0) >= level_of.get(room_of(header), 0):
                errors.append(f'{header}: includes {name}, which is not on a lower level')


def check_checker():
    made_by = {}
    for mesher in MESHERS:
        for header in reached_from(mesher):
            made_by.setdefault(header, mesher)
    for header in sorted(reached_from(CHECKER) - VOCABULARY):
        if header in made_by:
            errors.append(f'{CHECKER}: includes {header}, which {made_by[header]} uses: a checker shares no code with '
                          'what it checks')


def check_cycles():
    for header in sorted(texts):
        if header in reached_from(header):
            errors.append(f'{header}: includes itself')


def check_heads():
    for header, text in sorted(texts.items()):
        lines = text.splitlines()
        if not lines or not lines[0].startswith('// Copyright (c) ') or 'SPDX-License-Identifier' not in text:
            errors.append(f'{header}: no copyright and license at its head')
        if len(lines) > LONGEST_HEADER:
            errors.append(f'{header}: {len(lines)} lines, more than {LONGEST_HEADER}')
        guard = re.sub(r'[^A-Z0-9]', '_', header.upper())
        is_included_again = header.endswith('/compiled_meshers.h')
        if not is_included_again and f'#ifndef {guard}\n#define {guard}\n' not in text:
            errors.append(f'{header}: the guard is not {guard}')
        # Either a block of its own below the license or a comment on what it defines.
        after_license = text.split('Author(s)', 1)[-1].split('\n', 1)[-1]
        if not re.search(r'^//(/|\s*\w)', after_license, re.MULTILINE):
            errors.append(f'{header}: nothing says what it is for')


def check_tests():
    """Tests of several rooms are compiled as one: a namespace of its own keeps each file's names from the others."""
    for at, _, names in os.walk(os.path.join(ROOT, 'test')):
        for name in sorted(names):
            if not re.fullmatch(r'test_\w+\.cpp', name):
                continue
            with open(os.path.join(at, name), encoding='utf-8') as file:
                text = file.read()
            own = name[:-len('.cpp')]
            inside = text.partition(f'\nnamespace {own} {{\n')[2].rpartition(f'\n}} // namespace {own}\n')
            if 'TEST_CASE' not in inside[0] or 'TEST_CASE' in inside[2]:
                errors.append(f'{os.path.relpath(os.path.join(at, name), ROOT)}: its tests are not in a namespace {own}')


def check_width():
    for folder in ('include', 'examples', 'test', 'benchmark'):
        for at, _, names in os.walk(os.path.join(ROOT, folder)):
            for name in sorted(names):
                if not name.endswith(('.h', '.cpp')):
                    continue
                path = os.path.join(at, name)
                with open(path, encoding='utf-8') as file:
                    for number, line in enumerate(file, 1):
                        if len(line.rstrip('\n')) > WIDEST_LINE:
                            errors.append(f'{os.path.relpath(path, ROOT)}:{number}: wider than {WIDEST_LINE} columns')


check_layers()
check_checker()
check_tests()
check_cycles()
check_heads()
check_width()
for error in errors:
    print(error)
print(f'{len(texts)} headers, {len(errors)} errors')
sys.exit(1 if errors else 0)
