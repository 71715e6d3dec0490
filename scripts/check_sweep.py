"""Compares the folder of a sweep with the expected result of an example.

usage: check_sweep.py EXAMPLE_FOLDER SWEEP_FOLDER EXIT_CODE TIER

expected.json of an example: {"exit": 0, "outcomes": {"ok": 19, "not_ok": 5}, "heavy": {…}}: the exit code and the number of cases
with each outcome; "heavy" with the same keys for the sweep as it stands, if it differs from the quick one; "may_differ": so many cases
may have another outcome, because a bracket made in a given time depends on the machine. A strict lower bound above the upper one of
the same row is an error.
"""

import collections
import json
import pathlib
import sys


def main() -> int:
    """0 if the sweep is as expected."""
    example, folder, code, tier = sys.argv[1:]
    expected = json.loads((pathlib.Path(example) / "expected.json").read_text(encoding="utf-8"))
    if tier == "heavy" and "heavy" in expected:
        expected = expected["heavy"]
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
    for row in rows:
        if row.get("lambda_low", 0.0) > row.get("lambda_up", float("inf")):
            faults.append(f"{row['case']}: lower bound above the upper bound")
    for fault in faults:
        print(f"{example}: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
