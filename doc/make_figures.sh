#!/usr/bin/env bash
# Makes the figures of the manual, doc/fig/*.svg, by the examples. Figures are kept with the manual: GitHub shows them.
set -euo pipefail

# shellcheck source-path=SCRIPTDIR source=../.ci/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../.ci/common.sh"

bin=${1:-$root/build/bin}
figures=$root/doc/fig
lakes=$root/examples/data/great_lakes.poly.gz
[[ -x $bin/mesh_points ]] || fail "no examples in $bin: build them first (test/run.sh), or say where they are"

"$bin/compare_with_mesh_2" "$lakes" "$figures/compare_with_mesh_2.svg"
"$bin/adaptive_poisson" "$lakes" "$figures/adaptive_poisson.svg" >/dev/null
for example in mesh_points mesh_regions sizing_field theorem_5 acute_points quadtree_of_points quadtree_of_sizes; do
  "$bin/$example" "$figures/$example.svg" >/dev/null
done
ls -l "$figures"
