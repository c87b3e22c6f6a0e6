#!/usr/bin/env bash
# Meshes all coastlines of the world, at GSHHG's full resolution, in one run: `benchmark/world.sh [--folder F]
# [--kernels "filtered fixed"] [--triangle PATH]`. Wants Debian's packages gmt-gshhg-full and python3-netcdf4, about
# 4 GB of disk in the folder (build/world) and 16 GB of memory. The checker of quality_mesh judges the mesh.
set -euo pipefail

# shellcheck source-path=SCRIPTDIR source=../.ci/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../.ci/common.sh"

folder=$root/build/world kernels='filtered fixed' triangle=''
while [[ $# -gt 0 ]]; do
  case $1 in
    --folder) folder=$2 ;;
    --kernels) kernels=$2 ;;
    --triangle) triangle=$2 ;;
    *) fail "usage: benchmark/world.sh [--folder F] [--kernels K] [--triangle PATH]" ;;
  esac
  shift 2
done

install_packages "${build_packages[@]}" gmt-gshhg-full python3-netcdf4 time
configure_and_build "$root/build" world -DCMAKE_BUILD_TYPE=Release -DQUADTREE_MESH_2_QUICK_BENCHMARK=OFF
configure_and_build "$root/build" quality_mesh -DCMAKE_BUILD_TYPE=Release
mkdir -p "$folder"

say "the graph"
/usr/bin/python3 "$root/benchmark/world/world_coasts.py" /usr/share/gmt-gshhg/binned_GSHHS_f.nc "$folder/raw.poly"
"$root/build/bin/world" "$folder/raw.poly" "$folder/world.poly"
rm "$folder/raw.poly"

usage='%U processor seconds and %S of the system, %M kB at most'
for kernel in $kernels; do
  say "quality_mesh --kernel $kernel"
  /usr/bin/time -f "$usage" "$root/build/bin/quality_mesh" "$folder/world.poly" --kernel "$kernel" \
    --report "$folder/$kernel.json"
done

if [[ -n $triangle ]]; then
  say "Triangle -pq20.7"
  /usr/bin/time -f "$usage" "$triangle" -pq20.7 "$folder/world.poly" || say "Triangle did not survive it"
fi
