"""Arm `specs`: random specs through `check`, `mesh`, `run` and `verify`."""

import copy

from case import check_bounds
from drawn_specs import draw
from reduce import smaller
from spec_scenes import Catalogue, NoRoom, doubled, text, upside_down

NAME = "specs"
SHARE = 0.30
# What `check` may say of a spec whose parts collide: the generator does not know every part.
REDRAW = {
    "spec/rule", "spec/range", "geometry/clash", "geometry/clearance",
    # a steel thicker than its table, or one whose standard has no table of that kind
    "catalog/thickness", "catalog/no-bands",
}
VERDICT = {"ok": 0, "not_ok": 1, "undecided": 3}
DRAWS = 60
# `time_limit` of a run [s]
SHORTEST, LONGEST = 15, 60
# mesh, model, fields and pictures of a coarse joint
REST_MIB = 150


def fits(case, outcome, result, what):
    """The exit code is that of the verdict, or of the certificates where nothing is demanded.

    A joint that is OK by code needs no bound.
    """
    verdict = result["verdict"]
    codes = {VERDICT[verdict]} if verdict in VERDICT else {0}
    cases = result.get("cases", [])
    incomplete = len(cases) < len(result.get("asked", [])) or any(
        not c.get("certificate", {}).get("strict") or "lower" not in c or "upper" not in c
        for c in cases
    )
    if incomplete and verdict != "ok":
        codes = codes | {3} if verdict in ("not_ok",) else {3}
    if outcome.code not in codes:
        words = f"verdict {verdict}, incomplete {incomplete}"
        case.fault("exit code", f"{what}: {outcome.code}, {words}")


def check(case, spec, flow=False):
    """`check` of a spec. True if it is valid."""
    case.write("joint.yaml", text(spec, flow))
    outcome = case.run("check", "joint.yaml", "-q", "--threads", "1", limit=60)
    result = case.result("joint_check")
    if outcome.code == 2:
        code = outcome.refusal()
        if code in REDRAW:
            case.count(f"drawn again {code}")
        else:
            case.refused(outcome, False)
        if result:
            case.fault("exit code", "check: exit 2 with a result")
        return False
    if result is None:
        case.fault("no result", f"check: exit {outcome.code}: {outcome.err[-400:]}")
        return False
    fits(case, outcome, result, "check")
    case.verify("joint_check", limit=60)
    return True


def valid(case, names=None):
    """A spec that `check` takes, drawn from these templates; `None` where a fault was found."""
    r = case.random
    if "catalogue" not in case.state:
        case.state["catalogue"] = Catalogue(case.program)
    for _ in range(DRAWS):
        try:
            spec = draw(r, case.state["catalogue"], names)
        except NoRoom:
            case.count("drawn again")
            continue
        flow = r.random() < 0.05
        taken = check(case, spec, flow)
        if case.faults:
            shrink(case, spec, flow)
            return None
        if taken:
            case.count(f"valid {spec['template']}")
            return spec
    case.count("no spec drawn")
    return None


def run(case):
    r = case.random
    spec = valid(case)
    if spec is None:
        return
    choice = r.random()
    if choice < 0.3:
        mesh(case, spec, r)
    elif choice < 0.95:
        analyse(case, spec, r)


def mesh(case, spec, r):
    # coarse ones more often: large profiles take minutes at a factor of 2
    factor = round(2 + 2 * r.random() ** 0.5, 2)
    options = ["--no-step"] if r.random() < 0.7 else []
    outcome = case.run(
        "mesh", "joint.yaml", "-q", "--threads", "1", "--size-factor", factor,
        "--time-limit", "120", "--out", "mesh", *options, limit=200,
    )
    if outcome.code == 0:
        case.count("meshed")
    elif outcome.code == 2:
        case.refused(outcome, False)
    elif outcome.refusal() == "mesher/time":
        # a large joint, or a busy machine
        case.count("mesh not ready within 120 s")
    else:
        words = outcome.message()
        case.fault("valid spec not meshed", f"exit {outcome.code}: {words}")


def analyse(case, spec, r):
    """One coarse pass; then, of some, the whole joint, twice the load, or the mirrored joint."""
    # limit analyses take longer
    kind = r.choice(["elastic", "elastic", "limit"])
    # bounds hold on any mesh, and coarse ones are solved soon
    factor = round(r.uniform(3.5, 6), 2)
    spec = copy.deepcopy(spec)
    first_case_only(spec)
    # what a verdict by analysis needs takes longest: of small joints only
    decide = kind == "limit" and spec["template"] == "t_stub" and r.random() < 0.5
    # at most the time of the arm, so that a campaign of one minute does not take four
    seconds = round(min(LONGEST, max(SHORTEST, case.seconds)))
    spec["analysis"] = {"kind": kind, "decide": decide, "time_limit": f"{seconds} s"}
    found, outcome = one(case, "joint", spec, factor)
    if not found or outcome.code == 2:
        return
    case.count(f"{kind} runs")
    bounds = next(iter(found.values()))
    choice = r.random()
    simple = kind == "limit" and not any(
        load.get("dead") or "factor" in load for load in spec["loads"]
    )
    if choice < 0.12:
        other, _ = one(case, "whole", spec, factor, "--full")
        compare(case, "--full", bounds, other, 1.0)
    elif choice < 0.24 and simple:
        other, _ = one(case, "doubled", doubled(spec), factor)
        compare(case, "loads x 2", bounds, other, 0.5)
    elif choice < 0.36 and spec["template"] == "beam_splice":
        at_plane = copy.deepcopy(spec)
        for load in at_plane["loads"]:
            load["at"] = "bolt_plane"
        here, _ = one(case, "upright", at_plane, factor)
        other, _ = one(case, "mirrored", upside_down(spec), factor)
        if here:
            compare(case, "mirrored", next(iter(here.values())), other, 1.0)


def first_case_only(spec):
    """One load case: a run is long."""
    first = spec["loads"][0]["name"]
    spec["loads"] = [load for load in spec["loads"] if load["name"] == first]


def one(case, name, spec, factor, *options):
    """A `run` of a spec. Returns the bounds by entry, or nothing, and the outcome."""
    case.write(f"{name}.yaml", text(spec))
    outcome = case.run(
        "run", f"{name}.yaml", "-q", "--threads", "1", "--max-passes", "1",
        "--size-factor", factor, *options, limit=240,
    )
    result = case.result(name)
    if result is None:
        if outcome.code == 2:
            case.refused(outcome, False)
        elif outcome.refusal() == "mesher/time":
            # a large joint, or a busy machine
            case.count("mesh not ready within the time limit")
        else:
            words = outcome.message()
            case.fault("no result", f"{name}: exit {outcome.code}: {words}")
        return {}, outcome
    limit = spec["analysis"]["time_limit"]
    # forty seconds for the mesh, the certificates and a step that is under way
    allowed = max(LONGEST, float(limit.split()[0])) + 40
    if outcome.seconds > allowed * case.program.patience:
        case.fault("time limit", f"{name}: {outcome.seconds:.0f} s with a limit of {limit}")
    fits(case, outcome, result, name)
    within_forecast(case, name, result)
    case.verify(name, limit=200)
    return check_bounds(case, result, f"{name}: "), outcome


def within_forecast(case, name, result):
    """Memory stays within 1.5 times the forecast of the programs, which may run at once, and what
    the rest of a run needs. Time depends on what else runs on the machine and is only counted."""
    for row in (row for entry in result["cases"] for row in entry.get("history", [])):
        keys = ("kinematic", "static", "static_frictionless")
        # a program that was stopped has had its memory, one that was not started has none
        begun = [row[key] for key in keys if key in row]
        runs = [run for run in begun if run["status"] != "too large"]
        # without both programs: bolts were tightened first, and the time ended before they began again
        if not runs or not {"peak_memory_mib", "kinematic", "static"} <= row.keys():
            continue
        case.count("forecasts")
        expected = sum(run["forecast_memory_mib"] for run in runs)
        if row["peak_memory_mib"] > 1.5 * expected + REST_MIB:
            words = f"{row['peak_memory_mib']} MiB, forecast {expected} MiB"
            case.fault("memory over forecast", f"{name}: {words}")
        for run in runs:
            if run["status"] == "optimal" and run["seconds"] > 1.5 * run["forecast_seconds"] + 1:
                case.count("slower than the forecast")


def compare(case, what, bounds, other, factor):
    """The brackets of the same joint on two meshes have a value in common."""
    if not other:
        return
    case.count(f"compared {what}")
    lower, upper = next(iter(other.values()))
    for low, up in ((bounds[0], scaled(upper, factor)), (scaled(lower, factor), bounds[1])):
        # lengths of the model are rounded to 1e-9 of its size
        if low is not None and up is not None and low > up + 1e-7 * abs(up):
            case.fault("brackets exclude each other", f"{what}: {bounds} {other}")


def scaled(value, factor):
    return None if value is None else value / factor


def shrink(case, spec, flow):
    """Drops keys of a spec while `check` fails in the same way."""
    kinds = {f.kind for f in case.faults}
    code = next(iter(case.refusals), None)

    def still(candidate):
        probe = case.probe()
        check(probe, candidate, flow)
        same = kinds & {f.kind for f in probe.faults}
        return bool(same) and next(iter(probe.refusals), None) == code

    reduced = smaller(spec, still, 60)
    if reduced != spec:
        case.write("reduced.yaml", text(reduced, flow))
