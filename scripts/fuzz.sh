#!/bin/sh
# Fuzzes the readers of input files with libFuzzer, one after the other: scripts/fuzz.sh [--minutes N] [TARGET ...]
# N minutes for each target (default 10). Inputs that make a reader fail are left in fuzz/artifacts.
# cargo-fuzz asks for a nightly compiler; RUSTC_BOOTSTRAP lets the installed one accept the same options.
set -eu
cd -- "$(dirname -- "$0")/.."
minutes=10
if [ "${1:-}" = --minutes ]; then
    minutes=$2
    shift 2
fi
[ $# -gt 0 ] || set -- spec expression template model msh vtu csv sweep
cargo fuzz --version >/dev/null 2>&1 || cargo install cargo-fuzz --locked
export RUSTC_BOOTSTRAP=1
cargo fuzz build --sanitizer none
for target in "$@"; do
    mkdir -p "fuzz/corpus/$target"
    printf '\n== %s, %s minutes\n' "$target" "$minutes" >&2
    cargo fuzz run --sanitizer none "$target" "fuzz/corpus/$target" "fuzz/seeds/$target" -- \
        -max_total_time=$((minutes * 60)) -timeout=20 -rss_limit_mb=2048 -max_len=65536 -print_final_stats=1
done
printf '\n%s targets fuzzed without a finding\n' "$#" >&2
