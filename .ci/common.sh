# shellcheck shell=bash
# What examples/quickstart.sh and test/run.sh share: installing Debian packages and building. Sourced, not run.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# Everything that quality_mesh needs to be built.
# shellcheck disable=SC2034
build_packages=(g++ make cmake libcgal-dev libboost-dev libboost-program-options-dev libboost-iostreams-dev
  nlohmann-json3-dev libtbb-dev libeigen3-dev libhdf5-dev)

# What the component Distributed needs, beside the HDF5 for one rank.
# shellcheck disable=SC2034
distributed_packages=(libopenmpi-dev openmpi-bin libp4est-dev libhdf5-openmpi-dev)

say() { printf '== %s\n' "$*"; }

fail() {
  printf 'error: %s\n' "$*" >&2
  exit 2
}

is_installed() { [[ $(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null) == installed ]]; }

# Installs those of the named packages that are missing; does nothing, and asks for no rights, if none is.
install_packages() {
  if ! command -v apt-get >/dev/null; then
    say "not a Debian system: expecting the equivalents of $*"
    return
  fi
  local missing=() package
  for package in "$@"; do
    is_installed "$package" || missing+=("$package")
  done
  [[ ${#missing[@]} -gt 0 ]] || return 0

  local as_root=()
  if [[ $(id -u) -ne 0 ]]; then
    command -v sudo >/dev/null || fail "please install as root: apt-get install ${missing[*]}"
    as_root=(sudo)
  fi
  say "installing ${missing[*]}"
  "${as_root[@]}" apt-get -qq update
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get -qq -o Dpkg::Use-Pty=0 install --yes --no-install-recommends "${missing[@]}" >/dev/null
}

# Compilers of this code take up to four gigabytes each, so the number of cores alone does not decide.
build_jobs() {
  local cores gigabytes
  cores=$(nproc)
  gigabytes=$(awk '/^MemAvailable/ { print int($2 / 4e6) }' /proc/meminfo)
  ((gigabytes >= 1)) || gigabytes=1
  echo $((cores < gigabytes ? cores : gigabytes))
}

# configure_and_build_project SOURCE FOLDER TARGET [CMAKE_ARGUMENT]...
configure_and_build_project() {
  local source=$1 folder=$2 target=$3
  shift 3
  # By Ninja, if it is there: a tenth faster than by make.
  local generator=()
  [[ -f $folder/CMakeCache.txt ]] || ! command -v ninja >/dev/null || generator=(-G Ninja)
  say "building $target in $folder"
  cmake "${generator[@]}" -S "$source" -B "$folder" -Wno-dev "$@" >"$folder.log" 2>&1 || {
    cat "$folder.log" >&2
    fail "cmake could not configure $folder"
  }
  rm -f "$folder.log"
  cmake --build "$folder" --target "$target" --parallel "$(build_jobs)"
}

# configure_and_build FOLDER TARGET [CMAKE_ARGUMENT]...: this project.
configure_and_build() { configure_and_build_project "$root" "$@"; }

# Where the tests are built by a compiler, and how: their programs are slow, so not where users find theirs.
test_folder() { # compiler
  local folder=$root/build-tests
  [[ $1 == clang++ ]] || folder+=-$(basename "$1")
  echo "$folder"
}
# shellcheck disable=SC2034
test_arguments=(-DCMAKE_BUILD_TYPE=Release -DQUADTREE_MESH_2_QUICK_PROGRAMS=ON)
