#!/usr/bin/env bash
# Builds the manual and the reference in build/doc/html; installs Doxygen first where it is missing. Fails on any
# warning: a public name without documentation, a link to nowhere, an example that is not there; if a table is not that
# of the figures; and if the reference breaks a rule of doc/check_reference.py.
set -euo pipefail

# shellcheck source-path=SCRIPTDIR source=../.ci/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../.ci/common.sh"

install_packages doxygen python3
cd "$root"
benchmark/tables.py check doc/figures
rm -rf build/doc
mkdir -p build/doc
QUADTREE_MESH_VERSION=$(sed -n 's/^ *VERSION \([0-9.]*\)$/\1/p' CMakeLists.txt)
QUADTREE_MESH_ROOT=$root
export QUADTREE_MESH_ROOT QUADTREE_MESH_VERSION QUADTREE_MESH_WARN_AS_ERROR=${QUADTREE_MESH_WARN_AS_ERROR:-FAIL_ON_WARNINGS}
say "building the manual"
doxygen doc/Doxyfile
# To Doxygen 1.9 concepts are classes, with headers.
for concept in doc/Concepts/*.h; do
  name=$(basename "$concept" .h)
  sed -i 's/ Class Reference/ Concept Reference/g; s/documentation for this class/documentation for this concept/
    /<code>#include &lt;.*Concepts/d' \
    "build/doc/html/class${name//_/__}.html"
done
doc/check_reference.py build/doc
say "the manual: build/doc/html/index.html"
