#!/usr/bin/env bash
# On ranks quality_mesh_mpi writes the bytes that quality_mesh writes, with arrays in a scratch file or without, and with
# several threads of each rank, and tells once what is wrong.
#
# usage: compare_programs.sh RANKS GRAPH QUALITY_MESH COMMAND...
#
# COMMAND runs quality_mesh_mpi on RANKS ranks; GRAPH is a .poly.gz.
set -euo pipefail

ranks=$1 graph=$2 program=$3
command=("${@:4}")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir one_machine ranks
gunzip <"$graph" >graph.poly

outputs() { printf -- '-o %s/mesh.%s ' "$1" vtkhdf "$1" xdmf "$1" pvtu "$1" msh; }
for options in "" "--min-angle 25 --max-area 2e7 --separation theorem-5"; do
  # shellcheck disable=SC2046,SC2086 # options are words
  "$program" graph.poly --quiet --renumber --pieces "$ranks" $options $(outputs one_machine)
  # shellcheck disable=SC2046,SC2086
  "${command[@]}" graph.poly --quiet $options $(outputs ranks) --threads 2
  diff -r one_machine ranks
  [[ $(find ranks -name '*.vtu' | wc -l) -eq $ranks ]]
  rm ranks/*
  # shellcheck disable=SC2046,SC2086
  "${command[@]}" graph.poly --quiet $options $(outputs ranks) --memory 64M --scratch scratch
  diff -r one_machine ranks
  [[ ! -e scratch ]]
  rm one_machine/* ranks/*
done

# An error is told by one rank, names what is wrong, and ends all of them.
refuses() { # what is named, argument...
  local status=0
  "${command[@]}" "${@:2}" >/dev/null 2>errors || status=$?
  [[ $status -eq 2 && $(grep -c 'quality_mesh_mpi: error:' errors) -eq 1 ]] &&
    grep -q "quality_mesh_mpi: error:.*$1" errors && return
  echo "not refused by one error that names '$1': ${*:2}" >&2
  cat errors >&2
  exit 1
}
refuses "no input"
refuses nothing.poly nothing.poly -o mesh.vtkhdf
refuses mesh.svg graph.poly -o mesh.svg
# What only quality_mesh does is not passed over.
refuses --project graph.poly -o mesh.vtkhdf --project auto
refuses --msh-version graph.poly -o mesh.msh --msh-version 2.2
refuses --size-from-features graph.poly -o mesh.vtkhdf --size-from-features 1 1
refuses nowhere graph.poly -o nowhere/mesh.vtkhdf
refuses nowhere graph.poly --report nowhere/report.json
refuses mesh_1.msh graph.poly -o mesh.msh --report mesh_1.msh
[[ ! -e /dev/full ]] || refuses /dev/full graph.poly --report /dev/full
refuses graph.poly/scratch graph.poly -o mesh.vtkhdf --memory 64M --scratch graph.poly/scratch
printf '3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n1 0\n1 1 9\n0\n' >broken.poly
refuses broken.poly broken.poly -o mesh.vtkhdf
printf '3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n2 0\n1 1 2\n2 2 3\n0\n' >open.poly
refuses "close the border" open.poly -o mesh.vtkhdf
printf '4 2 0 0\n1 0 0\n2 1 1\n3 0 1\n4 1 0\n2 0\n1 1 2\n2 3 4\n0\n' >crossing.poly
refuses "or use --repair of quality_mesh" crossing.poly -o mesh.vtkhdf
[[ ! -e mesh.vtkhdf ]]
# One more rank, with other arguments.
refuses "different arguments" graph.poly --quiet : -n 1 "${command[-1]}" graph.poly --quiet -o mesh.vtkhdf
refuses "different arguments" graph.poly --quiet : -n 1 "${command[-1]}" --help
# Through MPI's own program a rank does not see that nobody takes what it prints.
if [[ -e /dev/full ]]; then
  status=0
  "${command[-1]}" graph.poly >/dev/full 2>errors || status=$?
  [[ $status -eq 2 ]] && grep -q "cannot be printed" errors
fi

# What misses a bound is told with its place and the reason, and so are the angles.
status=0
"${command[@]}" graph.poly --keep-borders all --report report.json >told || status=$?
[[ $status -eq 1 ]]
grep -q '^unmet: the triangle at (' told
grep -q '^unmet: reason for .*--keep-borders' told
"${command[@]}" graph.poly >told
"$program" graph.poly >expected
for line in vertices triangles 'least angle ' 'largest angle'; do
  # shellcheck disable=SC2016 # awk expands it
  [[ $(grep -m 1 "^$line" told | awk '{ print $NF }') == $(grep -m 1 "^$line" expected | awk '{ print $NF }') ]]
done
printf '4 2 0 0\n1 0 0\n2 1e-200 0\n3 1e-200 1e-200\n4 0 1e-200\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n' >tiny.poly
"${command[@]}" tiny.poly >told
grep -q '^least angle *45.00' told && grep -q '^largest angle *90.00' told
# The report has what that of one machine has, but for what is of one machine alone, for times and for memory.
"$program" graph.poly --keep-borders all --renumber --report expected.json >/dev/null || [[ $? -eq 1 ]]
python3 - "$ranks" <<'EOF'
import json, math, sys
report, expected = (json.load(open(name + ".json")) for name in ("report", "expected"))
assert report.pop("ranks") == int(sys.argv[1])
of_one_machine = {"min_new_angle", "unmet", "repair", "projection", "region_names", "marker_names"}
assert set(expected) - set(report) == of_one_machine
assert report["unmet_triangles"] == len(report["left"]) > 0
for name in ("seconds", "wall_seconds"):
    assert list(report.pop(name)) == list(expected.pop(name)), name
assert report.pop("peak_memory_mb") > 0
for name in ("min_angle", "max_angle"):
    assert math.isclose(report.pop(name), expected.pop(name), rel_tol=1e-12), name
differences = {name for name in report if report[name] != expected[name] and name != "threads"}
assert not differences, differences
EOF
printf '3 2 0 0\n1 10 60\n2 20 60\n3 10 68\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n' >degrees.poly
"${command[@]}" degrees.poly | grep -q 'longitudes and latitudes'
