#!/usr/bin/env bash
# Builds the package and meshes the Great Lakes; installs missing Debian packages first.
set -euo pipefail

# shellcheck source-path=SCRIPTDIR source=../.ci/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../.ci/common.sh"

install_packages "${build_packages[@]}"
configure_and_build "$root/build" quality_mesh -DCMAKE_BUILD_TYPE=Release

input=$root/examples/data/great_lakes.poly.gz
mesh=$root/build/great_lakes
say "meshing the Great Lakes, a file of shorelines with islands as holes"
"$root/build/bin/quality_mesh" "$input" --compare -o "$mesh.vtu" -o "$mesh.svg"
say "for ParaView:  $mesh.vtu"
say "for a browser: $mesh.svg"
