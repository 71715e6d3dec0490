#!/bin/sh
# Makes this machine ready for Bracket (Debian 12 or alike) and may be run any number of times:
#   - compiler, Python's venv module and the libraries gmsh needs, by apt, only if something is missing;
#   - a project-local .venv with gmsh and Mmg (in mmgpy); with --test also what the tests compare with.
# Exit 0: ready. Exit 4: something is missing that this script may not or cannot install; it says what to do.
set -eu

gmsh_version=4.15.2
mmgpy_version=0.17.1
meshio_version=5.3.5
ezdxf_version=1.4.5
playwright_version=1.65.2
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
venv=$root/.venv
test=no
PATH=$PATH:/usr/sbin:/sbin

say() { printf 'setup: %s\n' "$*" >&2; }
stop() {
    say "$@"
    exit 4
}

case "$#:${1:-}" in
    0:) ;;
    1:--test) test=yes ;;
    *)
        echo "usage: scripts/setup.sh [--test]" >&2
        exit 2
        ;;
esac

# --- what is missing -------------------------------------------------------------------------------------------------

has_venv() { "$1" -c 'import ensurepip, venv' >/dev/null 2>&1; }

# The first Python 3 that can make a virtual environment.
find_python() {
    for candidate in python3 /usr/bin/python3; do
        if has_venv "$candidate"; then
            echo "$candidate"
            return
        fi
    done
}

# apt package and the library that shows that it is installed.
libraries='libgl1 libGL.so.1
libglu1-mesa libGLU.so.1
libxcursor1 libXcursor.so.1
libxft2 libXft.so.2
libxinerama1 libXinerama.so.1
libgomp1 libgomp.so.1'

missing_packages() {
    command -v cc >/dev/null 2>&1 || echo build-essential
    command -v python3 >/dev/null 2>&1 || echo python3
    [ -n "$(find_python)" ] || echo python3-venv
    # the tests read what report.pdf says
    [ "$test" = no ] || command -v pdftotext >/dev/null 2>&1 || echo poppler-utils
    # the tests use report.html in a browser
    [ "$test" = no ] || command -v chromium >/dev/null 2>&1 || echo chromium
    # a mesher that runs has all its libraries, wherever they are
    if mesher_runs; then return; fi
    cache=$(ldconfig -p 2>/dev/null || true)
    echo "$libraries" | while read -r package library; do
        case $cache in
            *"$library "*) ;;
            *) dpkg -s "$package" 2>/dev/null | grep -q '^Status: install ok installed' || echo "$package" ;;
        esac
    done
}

mesher_runs() { [ -x "$venv/bin/python" ] && "$venv/bin/python" "$venv/bin/gmsh" --version >/dev/null 2>&1; }

if ! command -v cargo >/dev/null 2>&1; then
    stop "cargo is not on PATH. Install Rust 1.92 or newer (https://rustup.rs) and open a new shell."
fi

# --- apt, only for what is missing -----------------------------------------------------------------------------------

packages=$(missing_packages | tr '\n' ' ')
packages=${packages% }
if [ -n "$packages" ]; then
    by_hand="apt-get update && apt-get install -y --no-install-recommends $packages"
    command -v apt-get >/dev/null 2>&1 || stop "missing: $packages (Debian names). There is no apt-get here: install what corresponds."
    if [ "$(id -u)" = 0 ]; then
        as_root=''
    elif command -v sudo >/dev/null 2>&1 && sudo -n true 2>/dev/null; then
        as_root='sudo -n'
    else
        stop "missing: $packages. Installing needs root; run this once, then this script again:
    sudo sh -c '$by_hand'"
    fi
    say "installing $packages"
    $as_root apt-get update -q >&2 || say "apt-get update failed; trying with the lists at hand"
    # shellcheck disable=SC2086  # the list is meant to be split
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $packages >&2 ||
        stop "apt-get failed. As root: $by_hand"
fi

# --- the project's own Python environment ----------------------------------------------------------------------------

python=$(find_python)
[ -n "$python" ] || stop "no Python 3 with the modules venv and ensurepip (Debian: apt-get install python3 python3-venv)"
if ! "$venv/bin/python" -m pip --version >/dev/null 2>&1; then
    say "making $venv"
    rm -rf -- "$venv"
    "$python" -m venv "$venv" >&2 || stop "cannot make $venv"
fi

# try PACKAGE VERSION [OPTION]: installs it unless that very version is there; OPTION is one more option for pip.
try() {
    if ! "$venv/bin/python" -c "import importlib.metadata as m, sys; sys.exit(m.version('$1') != '$2')" 2>/dev/null; then
        say "installing $1 $2 into .venv"
        # shellcheck disable=SC2086  # without an option there is no word
        "$venv/bin/python" -m pip install --quiet --disable-pip-version-check ${3:-} "$1==$2" >&2
    fi
}
want() {
    try "$@" || stop "pip could not install $1==$2; is the package index reachable?"
}

# The executable of Mmg that mmgpy carries; its Python modules, which need numpy and scipy, are not used.
remesher_runs() {
    for mmg in "$venv"/lib/python3*/site-packages/mmgpy/bin/mmg3d_O3; do
        # -h prints the version and ends with a code that is not 0
        [ -x "$mmg" ] && "$mmg" -h 2>&1 | grep -q 'MMG3D, Release' && return
    done
    return 1
}

want gmsh "$gmsh_version"
try mmgpy "$mmgpy_version" --no-deps || :
if [ "$test" = yes ]; then
    want meshio "$meshio_version"
    want ezdxf "$ezdxf_version"
    want playwright "$playwright_version"
    "$venv/bin/python" -c 'import numpy' 2>/dev/null ||
        "$venv/bin/python" -m pip install --quiet --disable-pip-version-check numpy >&2 ||
        stop "pip could not install numpy; is the package index reachable?"
fi

if ! mesher_runs; then
    "$venv/bin/python" "$venv/bin/gmsh" --version >&2 || true
    stop "gmsh $gmsh_version is installed but does not run (its message stands above). If a library is missing, install it; otherwise remove .venv and run this script again."
fi
remesher_runs ||
    say "warning: mmgpy $mmgpy_version has no mmg3d_O3 that runs here. Bracket works without it: it refines your meshes by bisection. To try again, remove .venv and run this script again."
say "ready: $(cargo --version), gmsh $gmsh_version in .venv"
