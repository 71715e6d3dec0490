#!/bin/sh
# Runs every example and compares it with its expected result (examples/NAME/expected.json). Needs a built program.
# usage: examples.sh [--heavy] [NAME...]
# Results go to results/NAME. An example whose expected.json has "quick" is run with these options, a coarse mesh or a cheaper
# analysis; --heavy runs it as it stands and compares it with "heavy".
set -eu
cd -- "$(dirname -- "$0")/.."
bracket=${CARGO_TARGET_DIR:-target}/release/bracket
[ -x .venv/bin/python ] || { echo "examples: run scripts/setup.sh first" >&2; exit 4; }
[ -x "$bracket" ] || { echo "examples: build first (cargo build --release --locked)" >&2; exit 4; }
tier=quick
if [ "${1:-}" = --heavy ]; then
    tier=heavy
    shift
fi
[ "$#" -gt 0 ] || set -- examples/*/
for folder in "$@"; do
    name=$(basename -- "$folder")
    folder=examples/$name
    if [ -f "$folder/sweep.yaml" ]; then
        for sweep in $(.venv/bin/python scripts/check_sweep.py --sweeps "$folder" "$tier"); do
            echo "== bracket batch $folder/$sweep.yaml" >&2
            code=0
            out=results/${name}_$sweep
            rm -rf "$out"
            "$bracket" batch "$folder/$sweep.yaml" -o "$out" || code=$?
            .venv/bin/python scripts/check_sweep.py "$folder" "$sweep" "$out" "$code" "$tier"
        done
        continue
    fi
    if [ -f "$folder/joint.yaml" ]; then
        command=run input=$folder/joint.yaml
    elif [ -f "$folder/model.yaml" ]; then
        command=analyse input=$folder/model.yaml
    else
        echo "examples: $folder has neither joint.yaml nor model.yaml nor sweep.yaml" >&2
        exit 1
    fi
    # an example may bring a step that makes its mesh
    if [ -f "$folder/make_mesh.sh" ]; then sh "$folder/make_mesh.sh" >&2; fi
    options=$(.venv/bin/python scripts/check_example.py --options "$folder" "$tier")
    echo "== bracket $command $input $options" >&2
    code=0
    # options are words without blanks
    # shellcheck disable=SC2086
    "$bracket" "$command" "$input" $options --out "results/$name" || code=$?
    .venv/bin/python scripts/check_example.py "$folder" "results/$name" "$code" "$tier"
    # what the program claims, the independent certificate must confirm
    "$bracket" verify "results/$name"
done
