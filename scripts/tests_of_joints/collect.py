"""Gathers what the page needs of the finished runs into docs/study/tests_of_joints.json.

usage: collect.py     tests that were not run, or whose spec has changed since, are left as they stand in the file
"""

import json
import pathlib
import sys

import run
import specs

STORED = specs.ROOT / "docs" / "study" / "tests_of_joints.json"
# parts of a joint by the first letters of their names
GROUPS = (("PLATE", "plate"), ("COLUMN", "column"), ("BEAM", "beam"), ("BOLT", "bolts"), ("OUTER", "bolts"))


def group(part: str) -> str:
    """Plate, column, beam or bolts."""
    return next((name for start, name in GROUPS if part.startswith(start)), part)


def mechanism(case: dict) -> dict[str, float]:
    """Shares of plates, column, beams, bolts and welds in the dissipation of the mechanism, the largest first."""
    shares: dict[str, float] = {}
    for row in case.get("dissipation", []):
        shares[group(row["part"])] = shares.get(group(row["part"]), 0.0) + row["share"]
    # the limits of bolts pay for their forces, those of welds for the opening of their faces
    shares["bolts"] = shares.get("bolts", 0.0) + sum(row["share"] for row in case.get("resultants", []))
    shares["welds"] = sum(row.get("share", 0.0) for row in case.get("welds", []))
    return {k: round(v, 3) for k, v in sorted(shares.items(), key=lambda item: -item[1]) if v >= 0.005}


def bolt_use(case: dict) -> dict[str, float]:
    """The most used limits of the bolts at the lower bound: tension (with shear too), and the others."""
    use: dict[str, float] = {}
    for row in case.get("resultants", []):
        if "utilisation" not in row:
            continue
        what = row["limit"].rsplit(": ", 1)[-1]
        kind = "tension" if what in ("tension", "tension and shear") else "shear, bearing, punching"
        use[kind] = max(use.get(kind, 0.0), row["utilisation"])
    return {k: round(v, 3) for k, v in use.items()}


def strength(folder: pathlib.Path, passes: int) -> dict:
    """The bracket of a test as factors of M_max, what yields, and the component method [kN m]."""
    result = json.loads((folder / "result.json").read_text(encoding="utf-8"))
    case = result["cases"][0]
    found = {key: round(case[key], 4) for key in ("lower", "upper") if key in case}
    found |= {"meshes": len(case["history"]), "asked": passes, "macro_tets": max(row["macro_tets"] for row in case["history"])}
    found |= {"strict": case["certificate"].get("strict", False), "mechanism": mechanism(case), "bolts": bolt_use(case)}
    if "limiting_part" in case:
        found["limiting"] = group(case["limiting_part"])
    methods = case.get("demand", {}).get("component_method", [])
    if methods:
        # why the lower bound alone decides nothing: bolts may break first
        found["brittle"] = "brittle" in case["demand"]
        # with the axial force at M_max, where there is one
        title = "moment and axial force of the joint"
        moment = min(c["resistance"] for c in result["checks"] if c["title"] == title and "case" in c)
        found["component_method"] = {"moment": round(moment / 1e6, 1), "limited_by": methods[0]["limited_by"]}
    return found


def route(folder: pathlib.Path) -> dict:
    """Verdict and steps of the route of analysis."""
    result = json.loads((folder / "result.json").read_text(encoding="utf-8"))
    demand = next(c["demand"] for c in result["cases"] if "steps" in c.get("demand", {}))
    keys = ("step", "state", "utilisation", "finding")
    steps = [{k: row[k] for k in keys if k in row} for row in demand["steps"]]
    return {"by_analysis": demand["by_analysis"], "steps": steps}


def stiffness(folder: pathlib.Path) -> dict:
    """Bounds of the initial stiffness [kN m/mrad] and that of the component method."""
    case = json.loads((folder / "result.json").read_text(encoding="utf-8"))["cases"][0]
    found = case.get("joint_stiffness", {})
    return {k: round(found[k] / 1e9, 2) for k in ("lower", "upper", "component_method") if found.get(k) is not None}


def main() -> int:
    """Updates the stored file."""
    tests = specs.load()
    stored = json.loads(STORED.read_text(encoding="utf-8")) if STORED.is_file() else {}
    for name, kind in specs.runs(tests):
        if not run.finished(name, kind, tests, 0):
            continue
        folder = run.OUT / f"{name}_{kind}"
        if kind == "limit":
            mark = json.loads((run.OUT / f"{name}_{kind}.mark").read_text(encoding="utf-8"))
            found = strength(folder, mark["passes"])
        else:
            found = route(folder) if kind == "route" else stiffness(folder)
        stored.setdefault(name, {})[kind] = {"spec": run.digest(name, kind, tests), **found}
    ordered = {name: stored[name] for name in tests if name in stored}
    STORED.write_text(json.dumps(ordered, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
