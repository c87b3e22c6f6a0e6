#!/usr/bin/env bash
# Builds the package and meshes the Great Lakes; installs missing Debian packages first.
set -euo pipefail

# shellcheck source-path=SCRIPTDIR source=../.ci/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../.ci/common.sh"

install_packages "${build_packages[@]}"
configure_and_build "$root/build" quickstart -DCMAKE_BUILD_TYPE=Release

mesh=$root/build/great_lakes
say "meshing the Great Lakes, a file of shorelines with islands as holes; no angle below 20.7 degrees"
"$root/build/bin/quickstart" "$root/examples/data/great_lakes.poly.gz" "$mesh.svg" "$mesh.vtu"
say "both meshes of the Thousand Islands, Mesh_2's on the left and ours on the right, for a browser: $mesh.svg"
say "the mesh for ParaView: $mesh.vtu"
say "from Python: see doc/python.md"
say "the program for files of yours: cmake --build build --target quality_mesh -j$(nproc)"
