"""Compares the folder of a sweep with the expected result of an example.

usage: check_sweep.py --sweeps EXAMPLE_FOLDER TIER                                 the sweeps of a tier, `quick` or `heavy`
       check_sweep.py EXAMPLE_FOLDER SWEEP SWEEP_FOLDER EXIT_CODE TIER

expected.json of an example: {"quick": {"checks": {"exit": 0, "outcomes": {"ok": 19, "not_ok": 5}}}, "heavy": {…}}: for each sweep file
of a tier the exit code and the number of cases with each outcome. "may_differ": so many cases may have another outcome, because a
bracket made in a given time depends on the machine; their sum is always compared. "chosen": the joint of each group. A strict lower
bound above the upper one of the same row is an error.
"""

import collections
import csv
import json
import pathlib
import sys


def expectations(example: str, tier: str) -> dict:
    """What is expected of the sweeps of a tier."""
    return json.loads((pathlib.Path(example) / "expected.json").read_text(encoding="utf-8")).get(tier, {})


def main() -> int:
    """0 if the sweep is as expected."""
    if sys.argv[1] == "--sweeps":
        print(" ".join(expectations(*sys.argv[2:])))
        return 0
    example, sweep, folder, code, tier = sys.argv[1:]
    expected = expectations(example, tier)[sweep]
    text = (pathlib.Path(folder) / "results.jsonl").read_text(encoding="utf-8")
    rows = [json.loads(line) for line in text.splitlines()]
    outcomes = collections.Counter({row["case"]: row["outcome"] for row in rows}.values())
    faults = []
    if int(code) != expected["exit"]:
        faults.append(f"exit code {code}, expected {expected['exit']}")
    wanted = collections.Counter(expected["outcomes"])
    # each case with another outcome is missing in one count
    if outcomes.total() != wanted.total() or (wanted - outcomes).total() > expected.get("may_differ", 0):
        faults.append(f"outcomes {dict(outcomes)}, expected {expected['outcomes']}")
    if "chosen" in expected:
        with (pathlib.Path(folder) / "chosen.csv").open(encoding="utf-8", newline="") as file:
            chosen = {row["group"]: row["chosen"] for row in csv.DictReader(file)}
        if chosen != expected["chosen"]:
            faults.append(f"chosen {chosen}, expected {expected['chosen']}")
    for row in rows:
        if row.get("lambda_low", 0.0) > row.get("lambda_up", float("inf")):
            faults.append(f"{row['case']}: lower bound above the upper bound")
    for fault in faults:
        print(f"{example}/{sweep}: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
