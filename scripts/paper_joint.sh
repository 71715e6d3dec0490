#!/bin/sh
# The main job from nothing: set up, build, and bracket the paper's joint. Results go to results/paper_joint.
# Further options go to `bracket run`, for example: scripts/paper_joint.sh --threads 2
#
# Half of a first build is the printed report. So the program is first built without it and shows the bracket; the whole program
# is built after that and adds report.pdf.
set -eu
cd -- "$(dirname -- "$0")/.."
bracket=${CARGO_TARGET_DIR:-target}/release/bracket
result=results/paper_joint
scripts/setup.sh
if [ -x "$bracket" ]; then
    cargo build --release --locked
    exec "$bracket" run examples/paper_joint/joint.yaml --out "$result" "$@"
fi
cargo build --release --locked --no-default-features --features faer-sparse
code=0
"$bracket" run examples/paper_joint/joint.yaml --out "$result" "$@" || code=$?
echo "building the rest of the program: the printed report" >&2
cargo build --release --locked
# wrong input leaves no result
[ ! -f "$result/result.json" ] || "$bracket" report "$result" >&2
exit "$code"
