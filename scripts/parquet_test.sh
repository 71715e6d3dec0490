#!/bin/sh
# Builds the program with the feature `parquet`, runs a sweep, and compares results.parquet with results.jsonl as another program
# (pyarrow, installed into a temporary folder) reads it.
set -eu
cd -- "$(dirname -- "$0")/.."
bracket=${CARGO_TARGET_DIR:-target}/release/bracket
work=$(mktemp -d)
# the other tests use the program without the feature
trap 'rm -rf "$work"; cargo build --quiet --release --locked' EXIT
cargo test --release --locked --features parquet --lib parquet
cargo build --release --locked --features parquet
python3 -m venv "$work/venv"
"$work/venv/bin/pip" install --quiet pyarrow
"$bracket" batch examples/lightest/checks.yaml -o "$work/sweep" --quiet
"$work/venv/bin/python" - "$work/sweep" <<'PYTHON'
import json
import pathlib
import sys

import pyarrow.parquet

folder = pathlib.Path(sys.argv[1])
table = pyarrow.parquet.read_table(folder / "results.parquet")
read = [{key: value for key, value in row.items() if value is not None} for row in table.to_pylist()]
lines = (folder / "results.jsonl").read_text(encoding="utf-8").splitlines()
assert read == [json.loads(line) for line in lines], "results.parquet differs from results.jsonl"
print(f"results.parquet: {table.num_rows} rows, {table.num_columns} columns, equal to results.jsonl")
PYTHON
