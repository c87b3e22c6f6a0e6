#!/usr/bin/env bash
# Builds and runs the benchmarks, and makes the tables of the documentation of their figures. See --help.
set -euo pipefail

# shellcheck source-path=SCRIPTDIR source=../.ci/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../.ci/common.sh"

usage() {
  cat <<'HELP'
usage: benchmark/run.sh [--docs] [--quick] [--triangle PATH]

Prints the tables of the documentation, measured on this machine in about ten minutes, during which it should have
nothing else to do. The figures are in build/figures.

  --docs           put the figures into doc/figures and the tables into the documents
  --quick          run everything once, with smaller inputs where there is a choice of size
  --triangle PATH  compare with the program Triangle, too, which is not free software
HELP
}

shall_write=no
repeat=5
large=1e6
medium=1e5
triangle=()
while [[ $# -gt 0 ]]; do
  case $1 in
    --docs) shall_write=yes ;;
    --quick) repeat=1 large=1e5 medium=1e4 ;;
    --triangle)
      [[ $# -ge 2 ]] || fail "--triangle needs a value"
      triangle=(--triangle "$2") && shift
      ;;
    --help | -h) usage && exit 0 ;;
    *) usage >&2 && fail "unknown argument '$1'" ;;
  esac
  shift
done

install_packages "${build_packages[@]}" python3
# A peer of the quadtrees, which they do without.
(install_packages libp4est-dev libopenmpi-dev) || say "no p4est: the quadtrees are not compared with it"
for program in pslg parts points separation quadtree neighbors; do
  configure_and_build "$root/build" "$program" -DCMAKE_BUILD_TYPE=Release -DQUADTREE_MESH_2_QUICK_PROGRAMS=OFF
done

figures=$root/build/figures
rm -rf "$figures"
mkdir -p "$figures"
# What was built just now: later there may be another commit.
"$root/benchmark/tables.py" stamp "$figures" "$repeat"
measure() { # name of the figures, program, arguments
  local name=$1 program=$2
  shift 2
  say "$name"
  "$root/build/bin/$program" --json "$figures/$name.json" "$@" >"$figures/$name.txt"
}
cd "$root" # that figures name inputs by their place in the project
data=test/data
maps=(examples/data/great_lakes.poly.gz "$data/us_states_10m.poly.gz" "$data/gshhg_aegean_h.poly.gz")
norway=$data/gshhg_norway_f.poly.gz
holes=$data/syn_holes_400.poly.gz

measure maps pslg "${maps[@]}" "$norway" "$data"/syn_*.poly* --repeat "$repeat" "${triangle[@]}"
measure bounds pslg "${maps[@]}" "$norway" "$holes" --min-angle 18.43 30 --repeat 1 "${triangle[@]}"
measure max_angle pslg "${maps[@]}" "$norway" "$data"/syn_*.poly* --max-angle 120 --peers none --repeat "$repeat"
measure synthetic pslg koch:49152 blob:1e4 stars:1e4 comb:500 fan:1 fan:0.1 wedge:1 wedge:0.0001 parallel:1e-4 \
  "segments:$medium" holes:19600 square:1.5e-6 "coast:$medium" --repeat 1 --limit 60 "${triangle[@]}"
measure growth pslg --growth coast segments blob holes line circle parabola zigzag comb --sizes 1e4 1e5 3e5 --peers none --repeat 1
measure threads pslg "$norway" "coast:$medium" "segments:$medium" square:1e-6 --peers none --repeat "$repeat" \
  --threads $(seq -s ' ' 1 "$(nproc)")

measure parts parts "$norway" coast:3e5 --parts 2 7 24 64

measure separation separation "${maps[@]}" "$norway" coast:1e4 stars:1e3 "$holes" "$data"/syn_{comb,fan_1deg,parallel_0.001}.poly \
  --repeat 3 --limit 120
measure separation_rounds separation --rounds --families blob holes coast segments --sizes 1e3 1e4 --limit 300
measure neighbors neighbors "$norway" "${maps[@]:1}" --repeat "$repeat"

measure points_modes points uniform --n 1e4 --modes bounded:0 bounded:1 bounded bounded:3 tight wide acute warped points \
  --peers none --repeat 1 --limit 60
measure points_near points close-pairs nested short-spiral --n 100 1e3 --modes acute --peers none --repeat 1 --limit 60
measure points_peers points uniform --n "$medium" "$large" --modes points --repeat 1 --limit 120 "${triangle[@]}"

measure quadtree quadtree --n "$large" --repeat "$repeat" --limit 10 --threads "$(nproc)"
measure quadtree_rounds quadtree uniform spiral --rounds --n "$medium" "$large" --repeat "$repeat"

say compile_times
"$root/benchmark/compile_times.sh" --repeat "$repeat"

"$root/benchmark/tables.py" print "$figures"
if [[ $shall_write == yes ]]; then
  rm -f "$root/doc/figures"/*.json # those of benchmark/world.sh stay, in a folder of their own
  cp "$figures"/*.json "$root/doc/figures"
  "$root/benchmark/tables.py" write "$root/doc/figures"
  say "the documents have these figures"
fi
