#!/usr/bin/env bash
# Compiles all headers, and the meshers over all usual traits, by other compilers and standards, and by another CGAL:
# only looks for errors and warnings, makes nothing. See --help.
set -euo pipefail

# shellcheck source-path=SCRIPTDIR source=../.ci/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../.ci/common.sh"

usage() {
  cat <<'EOF'
usage: test/compilers.sh [--cgal FOLDER]

  --cgal FOLDER   with the CGAL whose folder `include` is in FOLDER, instead of the installed one
EOF
}

cgal=()
while [[ $# -gt 0 ]]; do
  case $1 in
    --cgal)
      [[ $# -ge 2 ]] || fail "--cgal needs a value"
      [[ -f $2/include/CGAL/version.h ]] || fail "no CGAL in '$2'"
      cgal=(-isystem "$2/include") && shift
      ;;
    --help | -h) usage && exit 0 ;;
    *) usage >&2 && fail "unknown argument '$1'" ;;
  esac
  shift
done
install_packages "${build_packages[@]}" clang

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
(cd "$root/include" && find CGAL -name internal -prune -o -name '*.h' -print | sort | sed 's/.*/#include <&>/') \
  >"$work/all_headers.cpp"

check() { # compiler, standard, source
  say "$1 -std=$2 ${3##*/}"
  "$1" -std="$2" -fsyntax-only -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -DCGAL_LINKED_WITH_TBB \
    "${cgal[@]}" -I "$root/include" -isystem /usr/include/eigen3 "$3"
}

sources=("$work/all_headers.cpp" "$root"/src/*.cpp)
for how in "g++ c++17" "g++ c++20" "clang++ c++17"; do
  read -r compiler standard <<<"$how"
  # What g++ makes of C++17 with the installed CGAL, the build has shown.
  [[ $how != "g++ c++17" || ${#cgal[@]} -gt 0 ]] || continue
  for source in "${sources[@]}"; do check "$compiler" "$standard" "$source"; done
done
