"""Compares a result folder with the expected result of an example.

usage: check_example.py EXAMPLE_FOLDER RESULT_FOLDER EXIT_CODE

expected.json of an example:
  {"exit": 0, "cases": {"CASE": {"overlaps": [low, high], "gap_at_most": 0.05, "strict": true}}}
`overlaps`: the bracket must share at least one point with this interval (energies in N mm, load factors in 1).
A case analysed in several ways is called `CASE (ANALYSIS)`. Every key of a case may be left out except one; a case of the result that is not expected is an error, and vice versa.
"""

import json
import pathlib
import sys


def check(example: pathlib.Path, result: pathlib.Path, code: int) -> list[str]:
    """All differences, as sentences."""
    expected = json.loads((example / "expected.json").read_text(encoding="utf-8"))
    faults = []
    if code != expected["exit"]:
        faults.append(f"exit code {code}, expected {expected['exit']}")
    if not (result / "result.json").is_file():
        return faults + [f"{result / 'result.json'} was not written"]
    found = json.loads((result / "result.json").read_text(encoding="utf-8"))["cases"]
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
    if len(sys.argv) != 4:
        print(__doc__, file=sys.stderr)
        return 2
    faults = check(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), int(sys.argv[3]))
    for fault in faults:
        print(f"{sys.argv[1]}: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
