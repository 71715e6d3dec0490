#!/usr/bin/env python3
"""Runs the program on random and broken input and under faults. README.md describes the arms."""

import argparse
import importlib
import json
import shutil
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from case import Case  # noqa: E402
from program import Program  # noqa: E402

CHECKOUT = Path(__file__).resolve().parents[2]
ARMS = ["models", "specs", "forgeries", "mutations", "faults"]
# an arm that runs only where it is asked for
ASKED = ["families"]
# cases of an arm that run even where its share of the time is used up
LEAST = 1


class Tally:
    """What an arm has found so far."""

    def __init__(self, name):
        self.name = name
        self.cases, self.failed = 0, 0
        self.counts, self.refusals, self.faults = Counter(), Counter(), Counter()
        self.reasons = Counter()
        self.examples, self.seconds, self.largest = {}, 0.0, 0.0
        self.failures = []

    def add(self, case):
        self.cases += 1
        self.failed += bool(case.faults)
        self.counts.update(case.counts)
        self.refusals.update(case.refusals)
        self.reasons.update(case.reasons)
        for code, words in case.examples.items():
            self.examples.setdefault(code, words)
        self.largest = max(self.largest, getattr(case, "largest", 0.0))
        for fault in case.faults:
            self.faults[fault.kind] += 1
            self.failures.append({"index": case.index, "kind": fault.kind, "detail": fault.detail})

    def report(self):
        return dict(vars(self), counts=dict(self.counts), refusals=dict(self.refusals),
                    reasons=dict(self.reasons), faults=dict(self.faults))


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--minutes", type=float, default=5.0, help="time in all (default: 5)")
    parser.add_argument("--seed", type=int, default=1, help="first number of all random ones")
    parser.add_argument("--arm", action="append", choices=ARMS + ASKED, help="only this arm; repeatable")
    parser.add_argument(
        "--template", action="append", help="arm families: only this template; repeatable"
    )
    parser.add_argument("--bracket", help="program (default: target/release/bracket)")
    parser.add_argument("--keep", help="folder for the failing cases")
    parser.add_argument("--report", help="file for all counts, as JSON")
    parser.add_argument("--index", type=int, help="only this case of each arm")
    parser.add_argument("--cases", type=int, help="so many cases of each arm, whatever the time")
    parser.add_argument(
        "--patience", type=float, default=1.0, help="factor of all time limits (default: 1)"
    )
    return parser.parse_args()


def run_arm(arm, options, program, scratch, seconds):
    tally = Tally(arm.NAME)
    start = time.monotonic()
    index = options.index or 0
    state = {}
    while True:
        folder = Path(scratch, f"{arm.NAME}-{index}")
        case = Case(program, arm.NAME, options.seed, index, folder)
        case.state, case.scratch = state, Path(scratch)
        case.checkout = CHECKOUT
        case.seconds = seconds
        case.templates = options.template
        try:
            arm.run(case)
        except Exception as error:  # the campaign goes on; its own fault counts as one
            case.fault("campaign", f"{type(error).__name__}: {error}")
            import traceback

            case.note(traceback.format_exc())
        tally.add(case)
        for fault in case.faults:
            say(f"{arm.NAME} {index}: {fault.kind}: {fault.detail[:500]}")
        if options.keep and (case.faults or options.index is not None):
            case.keep(options.keep)
        shutil.rmtree(folder, ignore_errors=True)
        progress(f"{arm.NAME}: {tally.cases} cases, {tally.failed} failed")
        index += 1
        spent = time.monotonic() - start
        if options.index is not None or tally.cases == options.cases:
            break
        if options.cases is None and spent > seconds and tally.cases >= LEAST:
            break
    tally.seconds = time.monotonic() - start
    if hasattr(arm, "end"):
        arm.end(state)
    return tally


def progress(words):
    if sys.stderr.isatty():
        sys.stderr.write(f"\r\033[K{words}")
        sys.stderr.flush()


def say(words):
    progress("")
    print(words, file=sys.stderr)


def table(tallies):
    for t in tallies:
        rate = 60 * t.cases / t.seconds if t.seconds else 0
        print(f"\n{t.name}: {t.cases} cases, {t.failed} failed, {rate:.0f} a minute")
        for what, number in sorted(t.counts.items()):
            print(f"  {what:<32} {number:>6}")
        if t.largest:
            print(f"  {'largest difference under a law':<32} {t.largest:>9.1e}")
        for code, number in t.refusals.most_common():
            print(f"  refused {code:<24} {number:>6}  {t.examples.get(code, '')[:110]}")
        for sentence, number in t.reasons.most_common(12):
            print(f"  {number:>6} x {sentence}")
        for kind, number in t.faults.most_common():
            print(f"  FAULT {kind:<26} {number:>6}")


def main():
    options = arguments()
    path = Path(options.bracket or CHECKOUT / "target/release/bracket").resolve()
    if not path.is_file():
        sys.exit(f"no program at {path}: build it with `cargo build --release --locked`")
    program = Program(path, CHECKOUT, options.patience)
    arms = [importlib.import_module(name) for name in options.arm or ARMS]
    whole = sum(arm.SHARE for arm in arms)
    tallies = []
    scratch = tempfile.mkdtemp(prefix="campaign-")
    try:
        for arm in arms:
            seconds = 60 * options.minutes * arm.SHARE / whole
            tallies.append(run_arm(arm, options, program, scratch, seconds))
    finally:
        shutil.rmtree(scratch, ignore_errors=True)
    progress("")
    table(tallies)
    if options.report:
        Path(options.report).write_text(json.dumps([t.report() for t in tallies], indent=1))
    failed = sum(t.failed for t in tallies)
    print(f"\n{sum(t.cases for t in tallies) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
