#!/usr/bin/env python3
"""Checks the reference that Doxygen has made, by its XML and its pages: check_reference.py FOLDER.

- Every public class, function, type and enumeration of the package is in a group.
- Every public name has a brief description. Only an overload may leave it to another one of its name.
- No two names of a class or of a group have the same text.
- No page has a formula that a browser cannot show, or the path of a file on this machine.

Prints what is wrong, one line each; the exit status is 1 if there is anything.
"""

import collections
import glob
import os
import re
import sys
import xml.etree.ElementTree as ElementTree

# What is left of a formula where nothing renders it.
RAW_FORMULA = re.compile(r'\\f[$\[\]]|\\\(|\\\[|MathJax')
CLASSES = ('class', 'struct')

folder = sys.argv[1]
errors = []


def text_of(element):
    return ' '.join(''.join(element.itertext()).split()) if element is not None else ''


def brief_of(element):
    return text_of(element.find('briefdescription'))


def name_of(compound):
    return text_of(compound.find('compoundname'))


compounds = {}
for file in glob.glob(os.path.join(folder, 'xml', '*.xml')):
    for compound in ElementTree.parse(file).getroot().findall('compounddef'):
        compounds[compound.get('id')] = compound
grouped, members_of_groups, nested = set(), set(), set()
for compound in compounds.values():
    inner = {i.get('refid') for i in compound.findall('innerclass')}
    if compound.get('kind') == 'group':
        grouped |= inner
        members_of_groups |= {member.get('id') for member in compound.iter('memberdef')}
    elif compound.get('kind') in CLASSES:
        nested |= inner


def check_members(compound):
    """Texts of public members: there, and not that of another name."""
    described, texts = set(), collections.defaultdict(set)
    members = [m for m in compound.iter('memberdef') if m.get('prot') == 'public']
    for member in members:
        name = text_of(member.find('name'))
        if brief_of(member):
            described.add(name)
            texts[brief_of(member) + text_of(member.find('detaileddescription'))].add(name)
        for value in member.findall('enumvalue'):
            if not text_of(value.find('briefdescription')) + text_of(value.find('detaileddescription')):
                errors.append(f'{name_of(compound)}: {name}::{text_of(value.find("name"))} has no description')
    for name in sorted({text_of(m.find('name')) for m in members} - described):
        errors.append(f'{name_of(compound)}: {name} has no brief description')
    overloads = collections.Counter(text_of(m.find('name')) for m in members)
    for text, names in texts.items():
        # An option without an argument gives its value: what it is, says the overload that sets it.
        names = {name for name in names if overloads[name] == 1}
        if len(names) > 1:
            errors.append(f'{name_of(compound)}: {", ".join(sorted(names))} have the same text: {text}')


for compound in sorted(compounds.values(), key=name_of):
    kind = compound.get('kind')
    if kind in CLASSES and compound.get('prot') == 'public':
        if not brief_of(compound):
            errors.append(f'{name_of(compound)} has no brief description')
        if compound.get('id') not in grouped | nested:
            errors.append(f'{name_of(compound)} is in no group')
        check_members(compound)
    elif kind == 'group':
        check_members(compound)
    elif kind == 'namespace':
        for member in compound.iter('memberdef'):
            if member.get('id') not in members_of_groups:
                errors.append(f'{name_of(compound)}: {text_of(member.find("name"))} is in no group')

root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
pages = sorted(glob.glob(os.path.join(folder, 'html', '*.html')))
for page in pages:
    with open(page, encoding='utf-8') as file:
        html = file.read()
    if root in html:
        errors.append(f'{os.path.basename(page)}: has the path {root}')
    code_removed = re.sub(r'<(div class="fragment"|pre|code)\b.*?</(div><!-- fragment -->|pre|code)>', '', html, flags=re.DOTALL)
    found = RAW_FORMULA.search(re.sub(r'<script.*?</script>', '', code_removed, flags=re.DOTALL))
    if found:
        errors.append(f'{os.path.basename(page)}: has the raw formula {found.group(0)}')
for error in errors:
    print(error)
print(f'{len(pages)} pages, {len(errors)} errors')
sys.exit(1 if errors else 0)
