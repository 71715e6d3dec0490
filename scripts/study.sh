#!/bin/sh
# Speed against error of the paper's joint: uniform and adaptive meshes, into docs/study; then run scripts/readme.py.
# About ten minutes on two cores.
set -eu
cd -- "$(dirname -- "$0")/.."
bracket=${CARGO_TARGET_DIR:-target}/release/bracket
[ -x "$bracket" ] || { echo "study: build first (cargo build --release --locked)" >&2; exit 4; }
"$bracket" study examples/paper_joint/joint.yaml --size-factor 1.3 --uniform 3 --target-gap 0.01 --max-passes 5 \
    --max-macro-tets 50000 --out results/paper_joint_study
mkdir -p docs/study
cp results/paper_joint_study/study.csv results/paper_joint_study/tets.png docs/study/
