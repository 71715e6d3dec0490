#!/bin/sh
# Makes bracket.msh from bracket.geo with the project's gmsh (scripts/setup.sh puts it into .venv), or else with one on PATH.
set -eu
here=$(cd -- "$(dirname -- "$0")" && pwd)
root=$here/../..
if [ -x "$root/.venv/bin/python" ] && [ -e "$root/.venv/bin/gmsh" ]; then
    set -- "$root/.venv/bin/python" "$root/.venv/bin/gmsh"
else
    set -- gmsh
fi
"$@" -v 2 -nt 1 -3 -format msh41 -o "$here/bracket.msh" "$here/bracket.geo"
