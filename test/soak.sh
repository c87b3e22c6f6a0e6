#!/usr/bin/env bash
# Runs the meshers on generated inputs and judges what they make; installs missing Debian packages and builds first. See
# --help.
set -euo pipefail

# shellcheck source-path=SCRIPTDIR source=../.ci/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../.ci/common.sh"

usage() {
  cat <<'EOT'
usage: test/soak.sh [--own-seed] [--quick] [option of build/bin/soak]...
       test/soak.sh --docs LOG...

  --own-seed  take the seed from the commit's name, 1 without one
  --quick     use what test/run.sh has built, which takes less time to compile and more to mesh
  --docs      write doc/soak.md from logs; nothing is run

Inputs that fail are written to the folder soak where it is built. The options of build/bin/soak:
EOT
}

arguments=()
documents=no
own_seed=no
quick=no
help=no
commit=$(git -C "$root" rev-parse --short=12 HEAD 2>/dev/null || echo unknown)
git -C "$root" diff --quiet HEAD 2>/dev/null || commit+=+
for argument in "$@"; do
  case $argument in
    --own-seed) own_seed=yes ;;
    --quick) quick=yes ;;
    --docs) documents=yes && arguments+=("$argument") ;;
    --help | -h) help=yes ;;
    *) arguments+=("$argument") ;;
  esac
done
if [[ $own_seed == yes ]]; then
  digits=${commit:0:6}
  [[ $commit != unknown ]] || digits=1 # not a repository
  arguments+=(--seed "$((16#$digits))")
fi

if [[ $help == yes ]]; then
  usage
  if [[ -x $root/build/bin/soak ]]; then
    "$root/build/bin/soak" --help
  else
    echo "are shown as soon as it is built: cmake -S . -B build && cmake --build build --target soak"
  fi
  exit
fi
install_packages "${build_packages[@]}"
folder=$root/build
how=(-DCMAKE_BUILD_TYPE=Release)
if [[ $quick == yes ]]; then
  folder=$(test_folder clang++)
  how=("${test_arguments[@]}" -DCMAKE_CXX_COMPILER=clang++)
  install_packages clang
fi
configure_and_build "$folder" soak "${how[@]}"
if [[ $documents == yes ]]; then
  "$folder/bin/soak" "${arguments[@]}" >"$folder/soak.md"
  mv "$folder/soak.md" "$root/doc/soak.md"
  say "written: doc/soak.md"
else
  "$folder/bin/soak" --commit "$commit" --folder "$folder/soak" "${arguments[@]}"
fi
