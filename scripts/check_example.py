"""Compares a result folder with the expected result of an example.

usage: check_example.py EXAMPLE_FOLDER RESULT_FOLDER EXIT_CODE TIER
       check_example.py --options EXAMPLE_FOLDER TIER   (prints the options to run it with)

expected.json of an example:
  {"exit": 0, "cases": {"CASE": {"overlaps": [low, high], "gap_at_most": 0.05, "strict": true}}}
Further keys: "verdict"; "utilisations": {"TITLE OF A HAND CHECK": 0.62}, the largest of the load cases, to half a per cent;
"resistances": {"SUBJECT: TITLE": 69.2e6} in N and mm, to half a per cent; "quick": "--options of the quick tier"; "heavy": {…}, what
the example gives without these options (tier heavy), with the same keys.
`overlaps`: the bracket must share at least one point with this interval (energies in N mm, load factors in 1).
A case analysed in several ways is called `CASE (ANALYSIS)`. Every key of a case may be left out except one; a case of the result that is not expected is an error, and vice versa.
"""

import json
import pathlib
import sys


KEYS = {"exit", "verdict", "cases", "utilisations", "resistances", "quick", "heavy"}
TOLERANCE = 0.005


def wanted_of(example: pathlib.Path, tier: str) -> dict:
    """What is expected of a tier."""
    expected = json.loads((example / "expected.json").read_text(encoding="utf-8"))
    if tier == "heavy" and "heavy" in expected:
        expected = expected["heavy"]
    return expected


def hand_checks(expected: dict, checks: list[dict]) -> list[str]:
    """Differences of the hand checks."""
    faults = []
    for title, wanted in expected.get("utilisations", {}).items():
        used = [c.get("utilisation", float("nan")) for c in checks if c["title"] == title and "case" in c]
        if not (used and abs(max(used) / wanted - 1.0) <= TOLERANCE):
            faults.append(f"{title}: utilisations {used}, expected {wanted}")
    for name, wanted in expected.get("resistances", {}).items():
        found = [c.get("resistance", float("nan")) for c in checks if f"{c['subject']}: {c['title']}" == name]
        if not (len(found) == 1 and abs(found[0] / wanted - 1.0) <= TOLERANCE):
            faults.append(f"{name}: {found}, expected {wanted}")
    return faults


def check(example: pathlib.Path, result: pathlib.Path, code: int, tier: str) -> list[str]:
    """All differences, as sentences."""
    expected = wanted_of(example, tier)
    faults = [f"expected.json has the unknown key {key}" for key in sorted(set(expected) - KEYS)]
    if code != expected["exit"]:
        faults.append(f"exit code {code}, expected {expected['exit']}")
    if not (result / "result.json").is_file():
        return faults + [f"{result / 'result.json'} was not written"]
    whole = json.loads((result / "result.json").read_text(encoding="utf-8"))
    if "verdict" in expected and whole["verdict"] != expected["verdict"]:
        faults.append(f"verdict {whole['verdict']}, expected {expected['verdict']}")
    faults += hand_checks(expected, whole.get("checks", []))
    found = whole["cases"]
    names = [c["name"] for c in found]
    cases = {c["name"] if names.count(c["name"]) == 1 else f"{c['name']} ({c['analysis']})": c for c in found}
    if sorted(cases) != sorted(expected["cases"]):
        return faults + [f"cases {sorted(cases)}, expected {sorted(expected['cases'])}"]
    for name, wanted in expected["cases"].items():
        case = cases[name]
        unknown = sorted(set(wanted) - {"overlaps", "gap_at_most", "strict"})
        if unknown or not wanted:
            faults.append(f"{name}: expected.json has {unknown or 'nothing'} to compare")
        if "overlaps" in wanted:
            low, high = wanted["overlaps"]
            # `not (a and b)` so that a missing number or a NaN is a fault, never a pass
            if not ("lower" in case and "upper" in case and case["lower"] <= high and case["upper"] >= low):
                faults.append(f"{name}: bracket [{case.get('lower')}, {case.get('upper')}] misses [{low}, {high}]")
        if "gap_at_most" in wanted and not ("gap" in case and 0.0 <= case["gap"] <= wanted["gap_at_most"]):
            faults.append(f"{name}: gap {case.get('gap')}, expected at most {wanted['gap_at_most']}")
        if "strict" in wanted and case.get("certificate", {}).get("strict") is not wanted["strict"]:
            faults.append(f"{name}: certificate strict is not {wanted['strict']}")
    return faults


def main() -> int:
    """Prints the differences; exit 1 if there are any."""
    if len(sys.argv) == 4 and sys.argv[1] == "--options":
        expected = json.loads((pathlib.Path(sys.argv[2]) / "expected.json").read_text(encoding="utf-8"))
        if sys.argv[3] == "heavy" and "quick" in expected and "heavy" not in expected:
            print(f"{sys.argv[2]}: expected.json does not say what the example gives as it stands", file=sys.stderr)
            return 1
        print(expected.get("quick", "") if sys.argv[3] == "quick" else "")
        return 0
    if len(sys.argv) != 5:
        print(__doc__, file=sys.stderr)
        return 2
    faults = check(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), int(sys.argv[3]), sys.argv[4])
    for fault in faults:
        print(f"{sys.argv[1]}: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
