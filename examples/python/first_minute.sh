#!/usr/bin/env bash
# From apt-get to a picture: runs what doc/python.md tells to do under "Installation" and "From a GeoPackage to a
# solver", as it stands there, and says how long that took. To be run as root on Debian 12.
#
# usage: first_minute.sh [--installed | --print] [FOLDER]
#   --installed  leave out apt-get: its packages are there
#   --print      print what would run, and do nothing
#   FOLDER       where the virtual environment and the files go; a new one in /tmp if it is not given
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
page=$root/doc/python.md
mode=all
case ${1:-} in --installed | --print) mode=$1 && shift ;; esac
[[ $# -le 1 && ${1:-} != -* ]] || { sed -n '/^# usage/,/^#   FOLDER/s/^# //p' "$0" >&2 && exit 2; }

# The first block of a section that is indented, and the first one of Python.
commands() {
  awk -v head="## $1" '$0 == head { on = 1 }
    on && /^    / { print substr($0, 5); seen = 1; next }
    seen { exit }' "$page"
}
python_lines() {
  awk -v head="## $1" '$0 == head { on = 1 }
    seen && /^```$/ { exit }
    seen { print }
    on && /^```python$/ { seen = 1 }' "$page"
}
say() { echo "== $1 ($SECONDS seconds)"; }

installation=$(commands Installation)
lines=$(python_lines 'From a GeoPackage to a solver')
[[ -n $installation && -n $lines ]]
if [[ $mode == --print ]]; then
  printf '%s\n' "$installation" "$lines"
  exit
fi
folder=${1:-$(mktemp -d)}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
# Where to install is up to whoever runs this; and nobody is there to answer questions.
installation=$(sed "s# venv\$# '$folder'/venv#; s#^venv/#'$folder'/venv/#" <<<"$installation")
export DEBIAN_FRONTEND=noninteractive
if [[ $mode == --installed ]]; then
  installation=$(awk '/^apt-get/ { skip = 1 } !skip { print } skip && !/\\$/ { skip = 0 }' <<<"$installation")
else
  installation="apt-get update -qq"$'\n'${installation//apt-get install/apt-get install -qq -y}
fi
cd "$root"
SECONDS=0
if ! bash -euo pipefail -c "$installation" >"$folder/installation.log" 2>&1; then
  tail -20 "$folder/installation.log" >&2
  exit 1
fi
say "installed"

cd "$folder"
export MPLBACKEND=Agg
venv/bin/python - <<'END'
import geopandas
from shapely.geometry import Polygon

shore = [(10.00, 59.00), (10.12, 58.98), (10.25, 59.01), (10.33, 59.08), (10.31, 59.16), (10.22, 59.21),
         (10.20, 59.27), (10.16, 59.21), (10.08, 59.19), (10.02, 59.12)]
island = [(10.14, 59.07), (10.18, 59.08), (10.19, 59.11), (10.15, 59.12), (10.13, 59.10)]
geopandas.GeoDataFrame(geometry=[Polygon(shore, [island])], crs=4326).to_file('bay.gpkg')
END
printf '%s\n' "$lines" "print(mesh, 'with angles from', mesh.angles().min().round(2), 'degrees')" >first_minute.py
venv/bin/python first_minute.py
test -s bay.png && test -s bay.xdmf
say "from packages to a picture: $folder/bay.png, and for solvers $folder/bay.xdmf"
