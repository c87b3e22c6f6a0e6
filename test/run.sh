#!/usr/bin/env bash
# Builds and runs all tests, and the examples; installs missing Debian packages first. See --help.
set -euo pipefail

# shellcheck source-path=SCRIPTDIR source=../.ci/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../.ci/common.sh"

usage() {
  cat <<'EOF'
usage: test/run.sh [--sanitize S[,S]] [--compiler CXX] [--full] [--strict]

  --sanitize S    build with sanitizers and with assertions, in a folder of its own: address, undefined or
                  address,undefined, or thread; runs the few tests of which the reduced suite for them consists
  --compiler CXX  build with this compiler, for example g++, in a folder of its own; else it is clang++, which
                  compiles the tests in half of g++'s time
  --full          run the slow sweeps too; with --sanitize all tests and the examples
  --strict        let a compiler warning be an error
EOF
}

sanitize=
compiler=clang++
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
  '' | address | undefined | address,undefined | thread) ;;
  *) fail "--sanitize knows address, undefined, address,undefined and thread, not '$sanitize'" ;;
esac

packages=("${build_packages[@]}" ninja-build lld libgdal-dev catch2 python3-gmsh python3-h5py python3-meshio)
# The Python package: what is missing is left out of build and tests, which CMake says.
[[ -n $sanitize ]] || packages+=(pybind11-dev python3-dev python3-pytest python3-numpy python3-shapely
  python3-geopandas python3-matplotlib)
# Tests on several ranks.
[[ -n $sanitize ]] || packages+=("${distributed_packages[@]}" petsc-dev)
# Pages are opened in a browser.
[[ -n $sanitize ]] || packages+=(chromium-headless-shell python3-pil)
# CGAL's viewer, for draw().
[[ $full == no || -n $sanitize ]] || packages+=(libcgal-qt5-dev)
if [[ $compiler == clang++* ]]; then
  version=${compiler#clang++}
  command -v "$compiler" >/dev/null || packages+=("clang$version")
  [[ -z $sanitize ]] || packages+=("libclang-rt$version-dev")
fi
install_packages "${packages[@]}"

folder=$(test_folder "$compiler")
arguments=("${test_arguments[@]}" -DQUADTREE_MESH_2_WARNINGS_AS_ERRORS="$strict"
  -DCMAKE_CXX_COMPILER="$compiler" -DQUADTREE_MESH_2_REQUIRE_READ_BACK=ON)
suite=all
if [[ -n $sanitize ]]; then
  folder+=-${sanitize//,/-}
  optimize=-O1
  if [[ $full == no ]]; then
    suite=reduced
    optimize=-O0 # compiled fastest, and its inputs are small
  fi
  # Not Release: its NDEBUG would switch the assertions off, and they find more than the sanitizer.
  arguments+=(-DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="$optimize -g1" -DQUADTREE_MESH_2_SANITIZE="$sanitize")
fi
target=all
[[ $suite == all ]] || target=reduced_tests
configure_and_build "$folder" "$target" "${arguments[@]}"

export UBSAN_OPTIONS=print_stacktrace=1
if [[ $suite == reduced ]]; then
  say "running the reduced suite under the sanitizers $sanitize"
  # Tests of two concurrencies have a sequential half, in which no thread can meet another.
  every='~[.]'
  [[ $sanitize != thread ]] || every='[threads]~*Sequential_tag'
  # Two halves that take about as long as each other.
  "$folder/bin/reduced_tests" "[end_to_end]$every" &
  end_to_end=$!
  "$folder/bin/reduced_tests" "~[end_to_end]$every"
  wait "$end_to_end"
  exit
fi

say "running the tests${sanitize:+ under the sanitizers $sanitize}"
[[ $full == no ]] || export QUADTREE_MESH_FULL_TESTS=1
ctest --test-dir "$folder" --parallel "$(nproc)" --output-on-failure --progress
[[ $full == no ]] || "$folder/bin/quadtree_mesh_2_tests" '[.slow]'

say "running the examples"
written=$(mktemp -d) # they write files where they are run
installed=$(mktemp -d)
trap 'rm -rf "$written" "$installed"' EXIT
run_example() { # program
  case ${1##*/} in
    quality_mesh | quality_mesh_mpi | mesh_for_dolfinx) ;; # the tests run them
    parallel_quadtree) "$1" 100000 >/dev/null ;;
    distribute_mesh | mesh_for_petsc) # where there is MPI, and PETSc
      export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
      for ranks in 1 2 3 4; do
        [[ ! -x $1 ]] || mpirun -n $ranks "$1" >/dev/null || return
      done
      ;;
    *) "$1" >/dev/null ;;
  esac
}
export -f run_example
# shellcheck disable=SC2016 # the inner shell expands it
(
  cd "$written"
  for source in "$root"/examples/*.cpp; do
    printf '%s\0' "$folder/bin/$(basename "$source" .cpp)"
  done | xargs -0 -P "$(nproc)" -n 1 bash -c 'run_example "$1"' run_example
)

if [[ -z $sanitize ]]; then
  say "installing, and building a project that uses the package, by the usual compiler"
  cmake --install "$folder" --prefix "$installed/usr" >/dev/null
  on_ranks=OFF
  ! command -v mpiexec >/dev/null || on_ranks=ON
  configure_and_build_project "$root/test/consumer" "$installed/build" all -DCONSUMER_ON_RANKS="$on_ranks" \
    -DCMAKE_BUILD_TYPE=None -DCMAKE_PREFIX_PATH="$installed/usr"
  ctest --test-dir "$installed/build" --output-on-failure
  # The examples are a project of their own, too. One is enough: the build had all.
  configure_and_build_project "$root/examples" "$installed/examples" mesh_graph \
    -DCMAKE_PREFIX_PATH="$installed/usr"
fi
