#!/usr/bin/env bash
# How long compilers take for this package. See --help.
set -euo pipefail

# shellcheck source-path=SCRIPTDIR source=../.ci/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../.ci/common.sh"

usage() {
  cat <<'HELP'
usage: benchmark/compile_times.sh [--docs] [--compiler CXX] [--repeat N]

Compiles README's program from the headers and with the compiled library, the same mesh by CGAL Mesh_2, and each part of
the library, one after the other. Prints processor seconds, the median of N (3) runs, without ccache.

  --docs          put the figures into doc/figures and the table into doc/development.md
  --compiler CXX  by this compiler (g++)
HELP
}

shall_write=no
compiler=g++
repeat=3
while [[ $# -gt 0 ]]; do
  case $1 in
    --docs) shall_write=yes ;;
    --compiler) [[ $# -ge 2 ]] || fail "--compiler needs a value" ; compiler=$2 && shift ;;
    --repeat) [[ $# -ge 2 ]] || fail "--repeat needs a value" ; repeat=$2 && shift ;;
    --help | -h) usage && exit 0 ;;
    *) usage >&2 && fail "unknown argument '$1'" ;;
  esac
  shift
done
install_packages "${build_packages[@]}"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# Writes the sources of the library.
cmake -S "$root" -B "$work/build" -Wno-dev -DCMAKE_BUILD_TYPE=Release -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >/dev/null
# README's program is its first block of C++.
awk '/^```cpp$/ { ++block; next } /^```$/ { block += block > 0 } block == 1' "$root/README.md" >"$work/readme.cpp"
cat >"$work/mesh_2.cpp" <<'EOF'
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Tds = CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>,
                                                 CGAL::Delaunay_mesh_face_base_2<Kernel>>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Tds>;

int main() {
  Cdt cdt;
  for (double radius : {5., 1.}) {
    const auto a = cdt.insert({-radius, -radius}), b = cdt.insert({radius, -radius}), c = cdt.insert({radius, radius}),
               d = cdt.insert({-radius, radius});
    cdt.insert_constraint(a, b), cdt.insert_constraint(b, c), cdt.insert_constraint(c, d), cdt.insert_constraint(d, a);
  }
  CGAL::Delaunay_mesher_2<Cdt, CGAL::Delaunay_mesh_size_criteria_2<Cdt>> mesher(cdt, {0.125, 0.5});
  const Kernel::Point_2 seed(0, 0);
  mesher.set_seeds(&seed, &seed + 1);
  mesher.refine_mesh();
  std::cout << cdt.number_of_faces() << '\n';
}
EOF

# Prints one figure: what, source, flags.
figure() {
  local what=$1 source=$2 seconds
  shift 2
  seconds=$(for ((i = 0; i < repeat; ++i)); do
    # shellcheck disable=SC2030 # only for the one command
    (TIMEFORMAT='%U %S' && time "$compiler" -std=c++17 -w -I "$root/include" "$@" -c "$source" -o "$work/object.o") 2>&1
  done | awk '{ print $1 + $2 }' | sort -n | sed -n "$(((repeat + 1) / 2))p")
  printf '{"what": "%s", "flags": "%s", "seconds": %s, "bytes": %s}\n' "$what" "$*" "$seconds" \
    "$(stat -c %s "$work/object.o")"
}

figures=$root/build/figures
[[ $shall_write == no ]] || figures=$root/doc/figures
mkdir -p "$figures"
{
  figure "README's program, from the headers" "$work/readme.cpp" -O2
  figure "README's program, with the library" "$work/readme.cpp" -O2 -DCGAL_QUADTREE_MESH_2_COMPILED
  figure "the same mesh by CGAL Mesh_2" "$work/mesh_2.cpp" -O2
  # The sources of the library and their levels of optimization, from the commands that would compile them.
  python3 - "$work/build/compile_commands.json" <<'EOF' >"$work/library"
import json, re, sys
for unit in json.load(open(sys.argv[1])):
    if '/compiled/' in unit['file']:
        print(unit['file'], re.findall(r' (-O\d)', unit['command'])[-1])
EOF
  while read -r source flag; do
    figure "library: $(basename "$source" .cpp)" "$source" "$flag" -DCGAL_LINKED_WITH_TBB -DCGAL_QUADTREE_MESH_2_COMPILED
  done <"$work/library"
} | tee /dev/stderr | python3 -c '
import json, sys
print(json.dumps({"compiler": sys.argv[1], "figures": [json.loads(line) for line in sys.stdin]}, indent=2))
' "$("$compiler" --version | head -1)" >"$figures/compile_times.json"
[[ $shall_write == no ]] || "$root/benchmark/tables.py" write "$figures"
