#!/usr/bin/env bash
# Compiles all headers, and the meshers over all usual traits, by other compilers and standards, another standard
# library, and another CGAL; and headers alone, twice in a row. Looks for errors and warnings. At last one program is
# built for each platform that is promised, and has to make meshes of the same bits. See --help.
set -euo pipefail

# shellcheck source-path=SCRIPTDIR source=../.ci/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../.ci/common.sh"

usage() {
  cat <<'EOF'
usage: test/compilers.sh [--cgal FOLDER] [--full]

  --cgal FOLDER   with the CGAL whose folder `include` is in FOLDER, instead of the installed one
  --full          all internal headers alone, all platforms, and clang++ with GCC's library, too; else what has changed
                  lately and an eighth of the other internal headers, and one platform beside g++, by the commit's name
EOF
}

cgal=
full=no
while [[ $# -gt 0 ]]; do
  case $1 in
    --cgal)
      [[ $# -ge 2 ]] || fail "--cgal needs a value"
      [[ -f $2/include/CGAL/version.h ]] || fail "no CGAL in '$2'"
      cgal=$(realpath "$2")/include && shift
      ;;
    --full) full=yes ;;
    --help | -h) usage && exit 0 ;;
    *) usage >&2 && fail "unknown argument '$1'" ;;
  esac
  shift
done
install_packages "${build_packages[@]}" "${distributed_packages[@]}" libgdal-dev clang libc++-dev libc++abi-dev g++-multilib

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$root/include"
mapfile -t headers < <(find CGAL -name internal -prune -o -name '*.h' -print | sort)
mapfile -t internal_headers < <(find CGAL -path '*/internal/*.h' | sort)

# Other commits have other samples, so what a sample misses, those of later commits find.
commit=$(git -C "$root" rev-parse --short=6 HEAD 2>/dev/null || echo 0)
is_sampled() { # place, length of the turn
  [[ $full == yes ]] || (($1 % $2 == 16#$commit % $2))
}
# The internal headers to be compiled alone.
headers_alone() {
  local i
  for i in "${!internal_headers[@]}"; do
    ! is_sampled "$i" 8 || echo "${internal_headers[i]}"
  done
  [[ $full == yes ]] || git -C "$root" diff --name-only --relative=include HEAD~20 2>/dev/null |
    grep -xF "$(printf '%s\n' "${internal_headers[@]}")" || true
}

# One source for all headers and all meshers: what they share is read and instantiated once.
everything=$work/all_headers_and_meshers.cpp
printf '#include <%s>\n' "${headers[@]}" >"$everything"
cat >>"$everything" <<'EOF'
namespace CGAL {
#define INSTANTIATE(MESHER, TRAITS) CGAL_QUADTREE_MESH_2_INSTANTIATE(, MESHER, TRAITS)
INSTANTIATE(Quality_mesher_2, Filtered_quadtree_traits_2<>);
INSTANTIATE(Quality_mesher_2, Fixed_point_quadtree_traits_2<std::uint64_t>);
INSTANTIATE(Quality_mesher_2, Exact_quadtree_traits_2<>);
INSTANTIATE(Point_set_mesher_2, Filtered_quadtree_traits_2<>);
INSTANTIATE(Point_set_mesher_2, Fixed_point_quadtree_traits_2<std::uint64_t>);
INSTANTIATE(Point_set_mesher_2, Exact_quadtree_traits_2<>);
INSTANTIATE(Trapezoidal_vertex_edge_neighbors_2, Filtered_quadtree_traits_2<>);
CGAL_QUADTREE_MESH_2_INSTANTIATE_MESH_QUALITY(, Sequential_tag);
CGAL_QUADTREE_MESH_2_INSTANTIATE_MESH_QUALITY(, Parallel_tag);
} // namespace CGAL
EOF

check() { # compiler, standard, source
  printf '== %s -std=%s %s\n' "$1" "$2" "${3##*/}"
  "$1" -std="$2" -fsyntax-only "${flags[@]}" "${@:4}" "$3"
}
flags=(-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -DCGAL_LINKED_WITH_TBB
  ${cgal:+-isystem "$cgal"} -I "$root/include" -isystem /usr/include/eigen3
  -isystem /usr/include/hdf5/serial -isystem /usr/include/gdal
  -DOMPI_SKIP_MPICXX -isystem "$(g++ -print-file-name=openmpi)/include")

# Other libraries take longer to read than most of our headers. So a header finds those of them read that it includes,
# itself or through headers of ours, and none that it lacks. The first set that is all among what it includes is taken.
precompiled_sets=(
  "CGAL/Constrained_Delaunay_triangulation_2.h CGAL/Exact_predicates_exact_constructions_kernel.h
   CGAL/Exact_predicates_inexact_constructions_kernel.h"
  "CGAL/Exact_predicates_inexact_constructions_kernel.h CGAL/Exact_rational.h"
  "CGAL/Exact_predicates_inexact_constructions_kernel.h"
  "CGAL/Exact_rational.h boost/multiprecision/cpp_int.hpp tbb/parallel_for.h"
  "CGAL/Exact_rational.h"
  "CGAL/number_utils.h"
  "tbb/parallel_for.h")
declare -A included
for header in "${headers[@]}" "${internal_headers[@]}"; do
  included[$header]=$(sed -nE 's/^ *# *include <([^>]+)>.*/\1/p' "$header")
done
reached_from() { # header
  local -A reached=()
  local waiting=("$1") header name
  while [[ ${#waiting[@]} -gt 0 ]]; do
    header=${waiting[-1]}
    unset 'waiting[-1]'
    for name in ${included[$header]-}; do
      [[ -z ${reached[$name]-} ]] || continue
      reached[$name]=yes
      waiting+=("$name")
    done
  done
  printf '%s\n' "${!reached[@]}"
}
precompiled_set_for() { # header
  local i reached
  reached=$(reached_from "$1")
  for i in "${!precompiled_sets[@]}"; do
    # shellcheck disable=SC2086 # a set is a list of words
    if ! grep -qvxF "$reached" < <(printf '%s\n' ${precompiled_sets[i]}); then
      printf ' -include-pch %s' "$work/set_$i.pch"
      return
    fi
  done
}
for i in "${!precompiled_sets[@]}"; do
  # shellcheck disable=SC2086
  printf '#include <%s>\n' ${precompiled_sets[i]} >"$work/set_$i.h"
  printf '%s\0' "$i"
done | xargs -0 -P "$(build_jobs)" -I{} clang++ -std=c++17 "${flags[@]}" -x c++-header "$work/set_{}.h" -o "$work/set_{}.pch"

# The same meshes, by what differs between platforms: integers of 128 bits by the compiler or in two words, the standard
# library, and long words of 32 bits. There CGAL takes Boost's numbers, because Debian has GMP for one width at a time.
platforms=(
  "g++"
  "g++ -DCGAL_QUADTREE_MESH_2_NO_INT128"
  "clang++ -stdlib=libc++"
  "g++ -O1 -m32 -msse2 -mfpmath=sse -DCGAL_DISABLE_GMP"
)
others=$((${#platforms[@]} - 1))
for ((i = 1; i <= others; ++i)); do
  is_sampled "$i" "$others" || unset 'platforms[i]'
done
# Not every Linux on 64 bits runs programs of 32. An emulator does, 20 times as slowly: hence -O1.
emulator=()
if [[ ${platforms[*]} == *-m32* ]]; then
  g++ -m32 -x c++ - -o "$work/nothing" <<<'int main() {}'
  "$work/nothing" 2>/dev/null || { install_packages qemu-user && emulator=(qemu-i386); }
fi
digests() { # platform, in words
  local libraries=(-lgmp -lmpfr) program runner=()
  [[ $* != *CGAL_DISABLE_GMP* ]] || libraries=()
  [[ $* != *-m32* ]] || runner=("${emulator[@]}")
  program=$work/digests_$(tr -c 'a-zA-Z0-9\n' _ <<<"$*")
  printf '== meshes by %s\n' "$*"
  "$1" -O0 "${@:2}" -std=c++17 -Wall -Wextra -Werror "${flags_of_cgal[@]}" -I "$root/include" \
    "$root/test/platforms/mesh_digests.cpp" -o "$program" "${libraries[@]}"
  "${runner[@]}" "$program" >"$program.txt"
}

# What g++ makes of C++17 with the installed CGAL, the build has shown.
{
  printf 'digests %s\n' "${platforms[@]}"
  [[ -z $cgal ]] || echo check g++ c++17 "$everything"
  echo check g++ c++20 "$everything"
  [[ $full == no ]] || echo check clang++ c++17 "$everything"
  echo check clang++ c++17 "$everything" -stdlib=libc++
  while read -r header; do
    source=$work/$(tr / _ <<<"$header").cpp
    printf '#include <%s>\n#include <%s>\n' "$header" "$header" >"$source"
    echo check clang++ c++17 "$source$(precompiled_set_for "$header")"
  done < <(printf '%s\n' "${headers[@]}" && headers_alone | sort -u)
} >"$work/checks"
export work root
# Functions and arrays do not reach the shells that xargs starts.
flags_of_cgal=(${cgal:+-isystem "$cgal"})
printf '%s\n' "set -e" "$(declare -f check digests)" "$(declare -p flags flags_of_cgal emulator)" >"$work/check.sh"
xargs -P "$(build_jobs)" -L 1 bash -c '. "$work/check.sh" && "$@"' check <"$work/checks"
for text in "$work"/digests_*.txt; do
  diff "$work/digests_g__.txt" "$text" || fail "the meshes of ${text##*/} are others"
done
