#!/bin/sh
# Tests of end-plate joints of the literature against the program (docs/validation.md): strength, stiffness, what governs. Opt-in: hours
# on two cores. Runs what has no result of the same spec yet, so that it can be stopped and continued at any time, then writes
# docs/study/tests_of_joints.json, the plot and the generated blocks of docs/validation.md.
# usage: tests_of_joints.sh [--only limit|route|stiffness] [--passes N] [ID...]
# With --passes 1 and some ids it is a quick look. Needs a built program.
set -eu
cd -- "$(dirname -- "$0")/.."
[ -x .venv/bin/python ] || { echo "tests_of_joints: run scripts/setup.sh first" >&2; exit 4; }
[ -x "${BRACKET:-${CARGO_TARGET_DIR:-target}/release/bracket}" ] ||
    { echo "tests_of_joints: build first (cargo build --release --locked)" >&2; exit 4; }
.venv/bin/python scripts/tests_of_joints/run.py "$@"
.venv/bin/python scripts/tests_of_joints/collect.py
.venv/bin/python scripts/tests_of_joints/page.py
