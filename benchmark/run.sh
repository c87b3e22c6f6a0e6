#!/usr/bin/env bash
# Builds the benchmarks and prints the tables of doc/; arguments go to each, for example names of files.
set -euo pipefail

# shellcheck source-path=SCRIPTDIR source=../.ci/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../.ci/common.sh"

install_packages "${build_packages[@]}"
configure_and_build "$root/build" versus_mesh_2 -DCMAKE_BUILD_TYPE=Release

for bound in 20.7 30; do
  say "versus Mesh_2, $bound degrees"
  "$root/build/bin/versus_mesh_2" --min-angle "$bound" --json "$root/build/versus_mesh_2_$bound.json" "$@"
done
