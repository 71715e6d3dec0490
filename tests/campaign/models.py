"""Arm `models`: random models through `bracket analyse` and `bracket verify`."""

import copy
import json

from case import check_bounds
from model_laws import laws
from model_scenes import scene
from reduce import smaller

NAME = "models"
SHARE = 0.28
# Bounds of equal models under a change of axes or units differ by the accuracy of the solver alone.
# README.md has the measured differences.
AGREE = 1e-3
# The kinematic program of limit analysis ends with forces unbalanced by up to 1e-3 of the loads
# (docs/theory.md, Stop). The bound stays above the true factor, but not by the same part.
AGREE_MECHANISM = 0.05
# Two values of one bound that are this near to zero, relative to the other bound, count as equal.
FLAT = 1e-9
# a load factor next to zero: a structure that only friction or a dead load could hold
NOTHING = 1e-3


def analyse(case, name, document, mesh, *options):
    """Runs one model. Returns the outcome, the result and its bounds."""
    folder = name.replace(" ", "_").replace(":", "")
    case.write(f"{folder}/model.yaml", document)
    case.write(f"{folder}/m.msh", mesh.text())
    outcome = case.run("analyse", f"{folder}/model.yaml", "--threads", "1", "-q", *options)
    result = case.result(f"{folder}/model")
    found = check_bounds(case, result, f"{name}: ") if result else {}
    return outcome, result, next(iter(found.values()), (None, None))


def finished(case, name, outcome, result, wanted):
    """Exit code, bounds and `verify` of a model that was not refused."""
    folder = name.replace(" ", "_").replace(":", "")
    if outcome.code == 2:
        if result:
            case.fault("exit code", f"{name}: exit 2 with a result")
        return False
    if result is None:
        case.fault("no result", f"{name}: exit {outcome.code}: {outcome.err[-400:]}")
        return False
    case.verify(f"{folder}/model")
    entry = result["cases"][0] if result["cases"] else {}
    strict = entry.get("certificate", {}).get("strict", False)
    complete = strict and all(key in entry for key in wanted)
    if (outcome.code == 0) != complete or outcome.code not in (0, 3):
        ends = f"{entry.get('lower')}, {entry.get('upper')}"
        case.fault("exit code", f"{name}: {outcome.code} with {ends}")
    if outcome.code == 3:
        case.count("no bracket")
        warnings = entry.get("warnings", []) + result.get("warnings", [])
        case.reason("no bracket: " + (warnings or ["without a warning"])[0])
        case.note(f"{name}: exit 3: {warnings}")
    return True


def overlap(case, what, one, two):
    """Every lower bound is at most every upper bound of the same body."""
    for a, b in ((one, two), (two, one)):
        if a[0] is not None and b[1] is not None and a[0] > b[1]:
            # rounding of the factor between the two
            if a[0] - b[1] > FLAT * max(abs(a[0]), abs(b[1])):
                case.fault("brackets of two runs exclude each other", f"{what}: {one} {two}")


def agree(case, what, one, two, limit):
    """Both bounds of the same model agree."""
    for a, b, name in zip(one, two, ("lower", "upper")):
        if (a is None) != (b is None):
            # an end without a certificate is documented; how often it happens is counted
            case.count("bound missing under a law")
            case.reason(f"{what} loses a bound")
            case.note(f"{what}: {name} {a} {b}")
        elif a is not None and a != b:
            size = max(abs(x) for x in (*one, *two) if x is not None and abs(x) < float("inf"))
            off = abs(a - b) / size if size else 0.0
            case.largest = max(getattr(case, "largest", 0.0), off)
            # of a factor that is zero only the size beside that of a loaded structure is accurate
            nothing = limit and size < NOTHING
            agreed = AGREE_MECHANISM if limit and name == "upper" else AGREE
            if off > agreed and not nothing:
                case.fault("a law is broken", f"{what}: {name} {a!r} {b!r}, {off:.1e}")


def run(case):
    r = case.random
    s = scene(r)
    document = s.document
    mesh = s.grid.mesh(1, s.jitter, r)
    case.features = sorted(s.features)
    wanted = {"kinematic": ["upper"], "static": ["lower"]}.get(
        document.get("bounds"), ["lower", "upper"]
    )
    outcome, result, both = analyse(case, "given", document, mesh)
    case.note(f"{document['analysis']} {sorted(s.features)} {len(mesh.tets)} tets: {both}")
    if outcome.code == 2:
        known = s.refusals and outcome.refusal() in s.refusals
        case.refused(outcome, known)
        finished(case, "given", outcome, result, wanted)
        shrink(case, document, mesh)
        return
    if not finished(case, "given", outcome, result, wanted):
        return
    case.count("finished")
    first = result["cases"][0] if result["cases"] else {}
    stable = "adapt" not in s.features and first.get("problem") != "shifted_cones"
    if outcome.code in (0, 3) and stable and "spoilt" not in s.features:
        if r.random() < 0.3:
            finer(case, s, document, both, wanted)
        if r.random() < 0.45:
            name, other, moved, factor = r.choice(list(laws(s, mesh)))
            law(case, name, other, moved, factor, both, wanted)
        if r.random() < 0.12 and len(mesh.tets) < 150:
            law(case, "clarabel", document, mesh, 1.0, both, wanted, "--solver", "clarabel")
    shrink(case, document, mesh)


def finer(case, s, document, both, wanted):
    """The same body on a mesh of twice as many cells along each axis."""
    if s.cells() > 10:
        return
    # bodies alike: nodes move inside bodies only
    outcome, result, other = analyse(case, "finer", document, s.grid.mesh(2))
    if finished(case, "finer", outcome, result, wanted):
        case.count("refined")
        overlap(case, "finer mesh", both, other)
    elif outcome.code == 2:
        case.refused(outcome, False)


def law(case, name, document, mesh, factor, both, wanted, *options):
    outcome, result, found = analyse(case, name, document, mesh, *options)
    if outcome.code == 2:
        case.refused(outcome, False)
        return
    if not finished(case, name, outcome, result, wanted):
        return
    case.count("laws")
    found = tuple(None if x is None else x / factor for x in found)
    overlap(case, name, both, found)
    if name == "clarabel" and (outcome.code == 3 or None in both or almost(result)):
        # the general solver may end without a certificate, or near its tolerance with a bound that
        # holds but is weaker, in a documented way
        return
    agree(case, name, both, found, document["analysis"] == "limit")


def almost(result):
    """True if a solve ended near its tolerance only."""
    rows = [row for c in result["cases"] for row in c.get("history", [])]
    programs = [p for row in rows for p in row.values() if isinstance(p, dict)]
    return any(p.get("status") == "almost optimal" for p in programs)


def shrink(case, document, mesh):
    """Drops keys while the first fault of the given model stays."""
    kinds = {"panic", "verify", "bounds crossed", "not strict", "valid input refused", "no result"}
    kinds &= {f.kind for f in case.faults if "finer" not in f.detail}
    if not kinds:
        return
    code = next(iter(case.refusals), None)

    def still(candidate):
        probe = case.probe()
        outcome, result, _ = analyse(probe, "given", candidate, mesh)
        if outcome.code == 2:
            return "valid input refused" in kinds and outcome.refusal() == code
        finished(probe, "given", outcome, result, [])
        return bool(kinds & {f.kind for f in probe.faults})

    reduced = smaller(copy.deepcopy(document), still, 40)
    if reduced != document:
        case.write("reduced/model.yaml", json.dumps(reduced, indent=1))
        case.write("reduced/m.msh", mesh.text())
