#!/bin/sh
# The main job from nothing: set up, build, and bracket the paper's joint. Results go to results/paper_joint.
# Further options go to `bracket run`, for example: scripts/paper_joint.sh --threads 2
set -eu
cd -- "$(dirname -- "$0")/.."
scripts/setup.sh
cargo build --release --locked
exec "${CARGO_TARGET_DIR:-target}/release/bracket" run examples/paper_joint/joint.yaml --out results/paper_joint "$@"
