#!/bin/sh
# Everything that must pass, from nothing: set up, format, lints, tests (unit, literature, doc), licences, examples.
# --heavy adds the tests that take long (fine meshes, convergence studies, a sweep on a real Slurm, the feature `parquet`).
# One minute of the campaign of random inputs (tests/campaign) is among them, five with --heavy; --campaign runs nothing but that.
set -eu
cd -- "$(dirname -- "$0")/.."
heavy=no
campaign=no
minutes=''
seed=1
usage() {
    echo "usage: scripts/test.sh [--heavy] | --campaign [--minutes N] [--seed S]" >&2
    exit 2
}
while [ $# -gt 0 ]; do
    case "$1" in
        --heavy) heavy=yes ;;
        --campaign) campaign=yes ;;
        --minutes | --seed)
            [ "$campaign" = yes ] && [ $# -gt 1 ] || usage
            case "$2" in '' | *[!0-9]*) usage ;; esac
            if [ "$1" = --minutes ]; then minutes=$2; else seed=$2; fi
            shift
            ;;
        *) usage ;;
    esac
    shift
done
[ "$heavy$campaign" != yesyes ] || usage
if [ -z "$minutes" ]; then
    if [ "$heavy$campaign" = nono ]; then minutes=1; else minutes=5; fi
fi

not_run=''
step() {
    printf '\n== %s\n' "$*" >&2
    "$@"
}

scripts/setup.sh --test

campaign() { step .venv/bin/python tests/campaign/run.py --minutes "$minutes" --seed "$seed" "$@"; }
if [ "$campaign" = yes ]; then
    step cargo build --release --locked
    campaign
    exit
fi

# A toolchain in its minimal profile lacks the two components; rustup adds them where it can.
for component in fmt clippy; do
    package=$(echo "$component" | sed s/fmt/rustfmt/)
    if ! cargo "$component" --version >/dev/null 2>&1; then
        rustup component add "$package" >&2 2>/dev/null || not_run="$not_run cargo-$component"
    fi
done
case $not_run in *fmt*) ;; *) step cargo fmt --all --check ;; esac
# `cargo clippy` would compile every dependency a second time. So its compiler builds the tests and the program, which are then run:
# these two variables are how `cargo clippy -- -D warnings` starts it.
case $not_run in
    *clippy*) ;;
    *)
        export RUSTC_WORKSPACE_WRAPPER=clippy-driver
        export CLIPPY_ARGS=-D__CLIPPY_HACKERY__warnings__CLIPPY_HACKERY__
        ;;
esac

# scripts/paper_joint.sh builds twice
step .venv/bin/python scripts/shared_features.py

# with lints, benches included
step cargo build --release --locked --all-targets
step cargo test --release --locked
step "${CARGO_TARGET_DIR:-target}/release/examples/clamped_block"
if [ "$heavy" = yes ]; then
    step cargo test --release --locked --lib --bins --tests -- --ignored
fi
if cargo deny --version >/dev/null 2>&1; then
    step cargo deny check bans licenses sources
    # known faults stand in a database on GitHub, which is not everywhere within reach
    if cargo deny fetch db >/dev/null 2>&1; then
        step cargo deny check advisories
    else
        not_run="$not_run advisories(database-out-of-reach)"
    fi
else
    not_run="$not_run cargo-deny"
fi
# a machine that tests several things at once is slower: its time limits are three times as long
campaign --patience 3
step "${PWD}/scripts/examples.sh"
# the pages of joints with bolts, used as a reader would
step .venv/bin/python scripts/page_in_browser.py results/one_sided_unstiffened results/splice_flush
# two minutes, most of them Slurm's pause before a requeued task: a real Slurm on this machine
if [ "$heavy" = yes ]; then
    step "${PWD}/scripts/slurm_test.sh"
    step "${PWD}/scripts/parquet_test.sh"
fi
step .venv/bin/python scripts/readme.py --check
# the joints of docs/validation.md are still accepted, and the page shows the stored results
step .venv/bin/python scripts/tests_of_joints/run.py --check
step .venv/bin/python scripts/tests_of_joints/page.py --check

if [ -n "$not_run" ]; then
    printf '\nnot run, because not within reach here:%s\n' "$not_run" >&2
fi
printf '\nall tests passed\n' >&2
