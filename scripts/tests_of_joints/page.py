"""Writes the generated blocks of docs/validation.md and the plot from the stored results.

usage: page.py            rewrite
       page.py --check    exit 1 if page or plot are not those of the stored results
"""

import json
import re
import sys

import plot
import run
import specs
from collect import STORED

PAGE = specs.ROOT / "docs" / "validation.md"
PLOT = specs.ROOT / "docs" / "study" / "tests_of_joints.svg"


def number(value: float | None, digits: int = 3) -> str:
    """Significant figures; a dash for what there is not."""
    return "–" if value is None else f"{value:.{digits}g}"


def ratio(a: float | None, b: float | None) -> str:
    """a/b to two decimals."""
    return "–" if a is None or b is None else f"{a / b:.2f}"


def moments(test: dict, found: dict) -> dict[str, float | None]:
    """Measured and computed moments [kN m]."""
    measured, limit = test["measured"], found.get("limit", {})
    most = measured["M_max"]
    bound = {key: limit[key] * most if key in limit else None for key in ("lower", "upper")}
    method = limit.get("component_method", {}).get("moment")
    return {"int": measured.get("M_int"), "max": most, "low": bound["lower"], "up": bound["upper"], "method": method}


def joint(name: str, test: dict) -> str:
    """Profiles and what is special, in short."""
    words = [f"{test['column']['profile']}, {test['beam']['profile']}, plate {test['plate']['size'][0]:g}"]
    if "axial" in test:
        words.append(f"N = {test['axial']:g} kN")
    if test.get("two_sided"):
        words.append("two beams")
    if "outer_gauge" in test["bolts"]:
        words.append("four bolts a row")
    if test.get("minor_axis"):
        words.append("minor axis")
    return "; ".join(words)


def strength(tests: dict, stored: dict) -> list[str]:
    """Moments of each test."""
    lines = [
        "| test | joint | M_int | M_max | M_low | M_up | M_low/M_int | M_low/M_max | M_up/M_max | component method | /M_int | /M_max |",
        "| --- | --- |" + " ---: |" * 10,
    ]
    for name, test in tests.items():
        m = moments(test, stored.get(name, {}))
        cells = [number(m[k]) for k in ("int", "max", "low", "up")]
        cells += [ratio(m["low"], m["int"]), ratio(m["low"], m["max"]), ratio(m["up"], m["max"])]
        cells += [number(m["method"]), ratio(m["method"], m["int"]), ratio(m["method"], m["max"])]
        lines.append(f"| {name} | {joint(name, test)} | " + " | ".join(cells) + " |")
    return lines


def governs(tests: dict, stored: dict) -> list[str]:
    """What yields or breaks: in the test, in the mechanism, in the static field, by the component method."""
    lines = [
        "| test | failure | mechanism (share of the dissipation) | limits of the bolts used at M_low | component method limited by |",
        "| --- | --- | --- | --- | --- |",
    ]
    for name, test in tests.items():
        limit = stored.get(name, {}).get("limit", {})
        shares = ", ".join(f"{k} {100 * v:.0f} %" for k, v in limit.get("mechanism", {}).items() if v >= 0.02) or "–"
        bolts = ", ".join(f"{k} {v:.2f}" for k, v in limit.get("bolts", {}).items()) or "–"
        method = limit.get("component_method", {}).get("limited_by", "–")
        lines.append(f"| {name} | {test['failure']} | {shares} | {bolts} | {method} |")
    return lines


def stiffness(tests: dict, stored: dict) -> list[str]:
    """Initial stiffness against the measured secant."""
    lines = ["| test | measured | lower bound | upper bound | component method | measured/lower bound |", "| --- |" + " ---: |" * 5]
    for name, test in tests.items():
        found = stored.get(name, {}).get("stiffness")
        if found:
            measured = test["measured"]["S"]
            cells = [number(measured), *(number(found.get(k)) for k in ("lower", "upper", "component_method"))]
            lines.append(f"| {name} | " + " | ".join(cells) + f" | {ratio(measured, found.get('lower'))} |")
    return lines


def route(tests: dict, stored: dict) -> list[str]:
    """Utilisation of the steps of the route of analysis; `open` where a step is not decided."""
    steps = ("strength", "bolts", "strain", "stability", "welds")
    lines = [f"| test | moment | {' | '.join(steps)} | most used | moment where it reaches 1 | /M_max | most used force of the bolts |"]
    lines.append("| --- |" + " ---: |" * 6 + " --- | ---: | ---: | --- |")
    for name, test in tests.items():
        rows = {row["step"]: row for row in stored.get(name, {}).get("route", {}).get("steps", [])}
        if not rows:
            continue
        moment = specs.ROUTE_SHARE * test["measured"]["M_max"]
        cells = [used(rows.get(step)) for step in steps]
        step, most = max(((s, rows[s].get("utilisation", 0.0)) for s in steps if s in rows), key=lambda item: item[1])
        bolt = rows.get("bolts", {}).get("finding", "–")
        reach = [number(moment / most), ratio(moment / most, test["measured"]["M_max"])]
        lines.append("| " + " | ".join([name, number(moment), *cells, step, *reach, bolt]) + " |")
    return lines


def used(row: dict | None) -> str:
    """Utilisation of a step, and whether it is open."""
    if row is None:
        return "–"
    value = number(row.get("utilisation"))
    return value if row["state"] in ("proved", "estimated") else f"{value} (open)"


def meshes(tests: dict, stored: dict) -> list[str]:
    """Size of the runs."""
    limits = [found["limit"] for name in tests if (found := stored.get(name, {})).get("limit")]
    if not limits:
        return []
    most, least = max(row["macro_tets"] for row in limits), min(row["macro_tets"] for row in limits)
    strict = sum(row["strict"] for row in limits)
    return [f"{len(limits)} tests, {least} to {most} macro tets in the largest mesh of a test; the bounds of {strict} tests are strict."]


def models(tests: dict, _stored: dict) -> list[str]:
    """What is assumed and where the model differs."""
    lines = ["| test | paper | assumed by the database | model |", "| --- | --- | --- | --- |"]
    for name, test in tests.items():
        lines.append(f"| {name} | {test['paper']} | {', '.join(test.get('assumed', [])) or '–'} | {test.get('model', '–')} |")
    return lines


BLOCKS = {"models": models, "strength": strength, "meshes": meshes, "governs": governs, "stiffness": stiffness, "route": route}


def main(arguments: list[str]) -> int:
    """Rewrites or checks page and plot."""
    tests = specs.load()
    stored = json.loads(STORED.read_text(encoding="utf-8")) if STORED.is_file() else {}
    old = PAGE.read_text(encoding="utf-8")
    text = old
    for block, make in BLOCKS.items():
        pattern = re.compile(rf"(<!-- generated:{block}\b[^>]*-->\n)(.*?)(<!-- /generated:{block} -->)", re.DOTALL)
        found = pattern.search(text)
        if found is None:
            print(f"tests_of_joints: {PAGE.name} has no block `{block}`", file=sys.stderr)
            return 1
        text = text[: found.start(2)] + "\n".join(make(tests, stored)) + "\n" + text[found.end(2) :]
    picture = plot.draw([(name, moments(test, stored.get(name, {}))) for name, test in tests.items()])
    if arguments == ["--check"]:
        stale = differs = text != old or not PLOT.is_file() or PLOT.read_text(encoding="utf-8") != picture
        for name, kind in specs.runs(tests):
            known = stored.get(name, {}).get(kind, {}).get("spec")
            if known not in (None, run.digest(name, kind, tests)):
                print(f"tests_of_joints: {name} {kind} was run with other data: run scripts/tests_of_joints.sh {name}", file=sys.stderr)
                stale = True
        if differs:
            print("tests_of_joints: docs/validation.md or its plot is stale: run scripts/tests_of_joints/page.py", file=sys.stderr)
        return 1 if stale else 0
    PAGE.write_text(text, encoding="utf-8")
    PLOT.write_text(picture, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
