#!/usr/bin/env bash
# Builds the benchmarks and prints the tables of doc/; arguments go to those of meshes, for example names of
# files.
set -euo pipefail

# shellcheck source-path=SCRIPTDIR source=../.ci/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../.ci/common.sh"

install_packages "${build_packages[@]}"
# A peer of the quadtrees, which they do without.
(install_packages libp4est-dev libopenmpi-dev) || say "no p4est: the quadtrees are not compared with it"
configure_and_build "$root/build" versus_mesh_2 -DCMAKE_BUILD_TYPE=Release
configure_and_build "$root/build" quadtree -DCMAKE_BUILD_TYPE=Release

for bound in 20.7 30; do
  say "versus Mesh_2, $bound degrees"
  "$root/build/bin/versus_mesh_2" --min-angle "$bound" --json "$root/build/versus_mesh_2_$bound.json" "$@"
done

say "quadtrees"
"$root/build/bin/quadtree" --n 1e5 1e6 --repeat 3 --limit 10 --threads "$(nproc)" \
  --json "$root/build/quadtree.json"
"$root/build/bin/quadtree" --rounds --n 1e5 1e6 --repeat 3 --json "$root/build/quadtree_rounds.json"
