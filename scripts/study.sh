#!/bin/sh
# Speed against error: uniform and adaptive meshes of the paper's joint, in elastic and in limit analysis, and of a splice in limit
# analysis. Writes docs/study; then run scripts/readme.py. About 35 minutes on two cores with nothing beside.
set -eu
cd -- "$(dirname -- "$0")/.."
bracket=${CARGO_TARGET_DIR:-target}/release/bracket
[ -x "$bracket" ] || { echo "study: build first (cargo build --release --locked)" >&2; exit 4; }
mkdir -p docs/study results

# study NAME SPEC OPTIONS...: table and plots against tets and time
study() {
    name=$1 spec=$2
    shift 2
    "$bracket" study "$spec" --uniform 3 --out "results/study_$name" "$@"
    cp "results/study_$name/study.csv" "docs/study/$name.csv"
    for plot in tets time; do cp "results/study_$name/$plot.png" "docs/study/${name}_$plot.png"; done
}

study paper_elastic examples/paper_joint/joint.yaml --size-factor 1.3 --target-gap 0.01 --max-passes 5 --max-macro-tets 50000
sed 's/kind: elastic/kind: limit, time_limit: 10 min/' examples/paper_joint/joint.yaml > results/paper_limit.yaml
study paper_limit results/paper_limit.yaml --size-factor 1.3 --max-macro-tets 25000
study splice_limit examples/splice_extended/joint.yaml --max-macro-tets 50000
