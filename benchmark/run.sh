#!/usr/bin/env bash
# Builds the benchmarks and prints the tables of doc/. Arguments go to those of meshes, for example
# `--triangle PATH` for the program Triangle, which is not free software.
set -euo pipefail

# shellcheck source-path=SCRIPTDIR source=../.ci/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../.ci/common.sh"

install_packages "${build_packages[@]}"
# A peer of the quadtrees, which they do without.
(install_packages libp4est-dev libopenmpi-dev) || say "no p4est: the quadtrees are not compared with it"
configure_and_build "$root/build" pslg -DCMAKE_BUILD_TYPE=Release
configure_and_build "$root/build" points -DCMAKE_BUILD_TYPE=Release
configure_and_build "$root/build" separation -DCMAKE_BUILD_TYPE=Release
configure_and_build "$root/build" quadtree -DCMAKE_BUILD_TYPE=Release
configure_and_build "$root/build" neighbors -DCMAKE_BUILD_TYPE=Release

# Prints the tables of one set of inputs: name, then options.
meshes() {
  local name=$1
  shift
  say "meshes: $name"
  "$root/build/bin/pslg" --json "$root/build/pslg_$name.json" "$@"
}
meshes maps --min-angle 18.43 20.7 30 --repeat 5 "$@"
meshes synthetic koch:49152 blob:1e4 stars:1e4 comb:500 fan:1 fan:0.1 wedge:1 wedge:0.0001 parallel:1e-4 \
  segments:1e5 holes:19600 square:1.5e-6 coast:1e5 --repeat 3 --limit 60 "$@"
meshes growth --growth coast segments blob holes --sizes 1e4 3e4 1e5 3e5 --repeat 1 --limit 120 "$@"
meshes threads "$root/test/data/gshhg_norway_f.poly.gz" coast:3e5 segments:1e5 square:1e-6 --peers none --repeat 5 \
  --threads $(seq -s ' ' 1 "$(nproc)")
meshes large coast:1e6 --repeat 1 --limit 120 "$@"

say "separations"
"$root/build/bin/separation" --repeat 3 --limit 60 --threads 2 --json "$root/build/separation.json"
"$root/build/bin/separation" --repeat 1 --limit 120 coast:1e4 coast:1e5 segments:1e4 holes:2500 stars:1e3 comb:100 fan:1 \
  parallel:1e-3 --json "$root/build/separation_synthetic.json"
"$root/build/bin/separation" --rounds --limit 300 --json "$root/build/separation_rounds.json"

# The same for meshes of points.
points() {
  local name=$1
  shift
  say "points: $name"
  "$root/build/bin/points" --json "$root/build/points_$name.json" "$@"
}
points modes uniform clusters kuzmin plummer grid line short-spiral --n 1e3 --repeat 3 --limit 30 "$@"
points near close-pairs nested --n 300 --modes acute points warped bounded --repeat 1 --limit 60 "$@"
points large uniform kuzmin --n 1e4 --modes bounded acute points --repeat 1 --limit 120 "$@"
points growth uniform short-spiral nested --growth --modes acute:1 points --n 1e3 1e4 1e5 --repeat 1 --limit 120 "$@"
points growth_near close-pairs --growth --modes acute:1 points --n 300 1e3 3e3 --repeat 1 --limit 120 "$@"
points threads uniform --n 1e4 --modes bounded:1 acute:1 points --peers none --repeat 3 --threads 1 2 4

say "quadtrees"
"$root/build/bin/quadtree" --n 1e5 1e6 --repeat 3 --limit 10 --threads "$(nproc)" \
  --json "$root/build/quadtree.json"
"$root/build/bin/quadtree" --rounds --n 1e5 1e6 --repeat 3 --json "$root/build/quadtree_rounds.json"

say "vertex-edge neighbours"
"$root/build/bin/neighbors" "$root/test/data/gshhg_norway_f.poly.gz" coast:1e5 segments:1e5 --repeat 7 \
  --json "$root/build/neighbors.json"
