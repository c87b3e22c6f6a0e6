#!/usr/bin/env bash
# Builds the manual and the reference in build/doc/html; installs Doxygen first where it is missing. Fails on any
# warning: a public name without documentation, a link to nowhere, an example that is not there; and if a table is not
# that of the figures.
set -euo pipefail

# shellcheck source-path=SCRIPTDIR source=../.ci/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../.ci/common.sh"

install_packages doxygen
cd "$root"
benchmark/tables.py check doc/figures
rm -rf build/doc
mkdir -p build/doc
QUADTREE_MESH_VERSION=$(sed -n 's/^ *VERSION \([0-9.]*\)$/\1/p' CMakeLists.txt)
export QUADTREE_MESH_VERSION QUADTREE_MESH_WARN_AS_ERROR=${QUADTREE_MESH_WARN_AS_ERROR:-FAIL_ON_WARNINGS}
say "building the manual"
doxygen doc/Doxyfile
say "the manual: build/doc/html/index.html"
