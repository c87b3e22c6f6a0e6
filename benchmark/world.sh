#!/usr/bin/env bash
# Meshes all coastlines of the world, at GSHHG's full resolution, in one run, by doubles and by 64-bit words. See
# --help.
set -euo pipefail

# shellcheck source-path=SCRIPTDIR source=../.ci/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../.ci/common.sh"

usage() {
  cat <<'HELP'
usage: benchmark/world.sh [--docs] [--folder F] [--triangle PATH]

Takes about fifteen minutes, 2 GB of disk and 24 GB of memory, and installs Debian's packages gmt-gshhg-full and
python3-netcdf4. Each mesh is checked.

  --docs           put the figures into doc/figures/world and the table into the documents
  --folder F       where the graph is written, build/world by default
  --triangle PATH  compare with the program Triangle, too, which is not free software
HELP
}

folder=$root/build/world
shall_write=no
peers=(--peers none)
while [[ $# -gt 0 ]]; do
  case $1 in
    --folder | --triangle) [[ $# -ge 2 ]] || fail "$1 needs a value" ;;&
    --docs) shall_write=yes ;;
    --folder) folder=$2 && shift ;;
    --triangle) peers=(--peers triangle --triangle "$2") && shift ;;
    --help | -h) usage && exit 0 ;;
    *) usage >&2 && fail "unknown argument '$1'" ;;
  esac
  shift
done

install_packages "${build_packages[@]}" gmt-gshhg-full python3-netcdf4
for program in world pslg quality_mesh; do
  configure_and_build "$root/build" "$program" -DCMAKE_BUILD_TYPE=Release -DQUADTREE_MESH_2_QUICK_PROGRAMS=OFF
done
figures=$folder/figures
mkdir -p "$figures"
"$root/benchmark/tables.py" stamp "$figures" 1

say "the graph"
/usr/bin/python3 "$root/benchmark/world/world_coasts.py" /usr/share/gmt-gshhg/binned_GSHHS_f.nc "$folder/raw.poly"
"$root/build/bin/world" "$folder/raw.poly" "$folder/world.poly"
rm "$folder/raw.poly"

say "by doubles"
"$root/build/bin/pslg" "$folder/world.poly" "${peers[@]}" --repeat 1 --limit 3600 --json "$figures/world.json"
say "by 64-bit words"
"$root/build/bin/quality_mesh" "$folder/world.poly" --kernel fixed --report "$figures/words.json"

if [[ $shall_write == yes ]]; then
  rm -rf "$root/doc/figures/world"
  cp -r "$figures" "$root/doc/figures/world"
  "$root/benchmark/tables.py" write "$root/doc/figures"
  say "the documents have these figures"
fi
