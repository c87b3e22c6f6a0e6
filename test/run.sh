#!/usr/bin/env bash
# Builds and runs all tests, and the examples; installs missing Debian packages first. See --help.
set -euo pipefail

# shellcheck source-path=SCRIPTDIR source=../.ci/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../.ci/common.sh"

usage() {
  cat <<'EOF'
usage: test/run.sh [--sanitize address|undefined|thread] [--compiler CXX] [--full] [--strict]

  --sanitize S    build with a sanitizer and with assertions, in a folder of its own
  --compiler CXX  build with this compiler, for example clang++, in a folder of its own
  --full          run the slow sweeps too
  --strict        let a compiler warning be an error
EOF
}

sanitize=
compiler=
full=no
strict=OFF
while [[ $# -gt 0 ]]; do
  case $1 in
    --sanitize | --compiler) [[ $# -ge 2 ]] || fail "$1 needs a value" ;;&
    --sanitize) sanitize=$2 && shift ;;
    --compiler) compiler=$2 && shift ;;
    --full) full=yes ;;
    --strict) strict=ON ;;
    --help | -h) usage && exit 0 ;;
    *) usage >&2 && fail "unknown argument '$1'" ;;
  esac
  shift
done
case $sanitize in
  '' | address | undefined | thread) ;;
  *) fail "--sanitize knows address, undefined and thread, not '$sanitize'" ;;
esac

packages=("${build_packages[@]}" catch2 python3-gmsh python3-meshio)
if [[ $compiler == clang++* ]] && ! command -v "$compiler" >/dev/null; then
  packages+=("clang${compiler#clang++}")
fi
install_packages "${packages[@]}"

folder=$root/build
arguments=(-DCMAKE_BUILD_TYPE=Release -DQUADTREE_MESH_2_WARNINGS_AS_ERRORS="$strict"
  -DQUADTREE_MESH_2_REQUIRE_READ_BACK=ON)
compiler_argument=()
if [[ -n $compiler ]]; then
  folder+=-$(basename "$compiler")
  compiler_argument=(-DCMAKE_CXX_COMPILER="$compiler")
  arguments+=("${compiler_argument[@]}")
fi
if [[ -n $sanitize ]]; then
  # Not Release: its NDEBUG would switch the assertions off, and they find more than the sanitizer.
  folder+=-$sanitize
  arguments+=(-DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="-O1 -g1" -DQUADTREE_MESH_2_SANITIZE="$sanitize")
fi
configure_and_build "$folder" all "${arguments[@]}"

what=('~[.]')
if [[ $full == yes ]]; then
  export QUADTREE_MESH_FULL_TESTS=1
  what=('~[.],[.slow]')
fi
export UBSAN_OPTIONS=print_stacktrace=1
say "running the tests${sanitize:+ under the $sanitize sanitizer}"
"$folder/bin/quadtree_mesh_2_tests" "${what[@]}"

say "running the examples"
for source in "$root"/examples/*.cpp; do
  name=$(basename "$source" .cpp)
  case $name in
    quality_mesh) ;; # the tests run it
    parallel_quadtree) "$folder/bin/$name" 100000 >/dev/null ;;
    *) "$folder/bin/$name" >/dev/null ;;
  esac
done

if [[ -z $sanitize ]]; then
  say "installing, and building a project that uses the package"
  installed=$(mktemp -d)
  trap 'rm -rf "$installed"' EXIT
  cmake --install "$folder" --prefix "$installed/usr" >/dev/null
  configure_and_build_project "$root/test/consumer" "$installed/build" all \
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$installed/usr" "${compiler_argument[@]}"
  ctest --test-dir "$installed/build" --output-on-failure
fi
