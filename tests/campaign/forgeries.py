"""Arm `forgeries`: `verify` refuses a finished result in which one value was changed."""

import json
import os
import re
import shutil
from pathlib import Path

from blake3 import digest
from case import Case
from forged import NoChange, field_change, json_change, mesh_change, text_change
from grid import Grid
from model_scenes import bolted, outer, Scene
from spec_scenes import text as spec_text

NAME = "forgeries"
SHARE = 0.18
# Keys in the table "recorded, not recomputed"; `verify` prints the same ones.
RESULTS_PAGE = Path(__file__).resolve().parents[2] / "docs" / "results.md"
# Relative changes below this are rounding to `verify`.
SAME = 1e-9
JOINT = {
    "template": "t_stub",
    "members": {"tee": {"profile": "IPE300", "steel": "S235"}},
    "bolts": {"size": "M18", "grade": "8.8", "rows": [0]},
    "parameters": {"length": 70},
    "friction": {"mu": 0.2, "law": "associated"},
    "loads": [{"name": "PULL", "end": "top", "at": "bolt_plane", "N": "60 kN"}],
    "analysis": {"kind": "limit", "max_passes": 1},
}
SPLICE = {
    "project": {"title": "Splice", "date": "2026-01-31"},
    "template": "beam_splice",
    "members": {"beam": {"profile": "IPE300", "steel": "S235"}},
    "plate": {"thickness": 15},
    "bolts": {"size": "M20", "grade": "8.8", "rows": [-90, 90, 190]},
    "parameters": {"flange_weld": 6, "web_weld": 4},
    "loads": [
        {"name": "ULS1", "end": "beam_right", "at": "bolt_plane", "My": "60 kN m", "Vz": "-50 kN"},
        {"name": "ULS2", "end": "beam_right", "at": "bolt_plane", "My": "-40 kN m", "N": "30 kN"},
    ],
}


def block(analysis, law, load, bodies=("A", "B")):
    """Two cubes on each other."""
    axes = [[0.0, 10.0, 20.0], [0.0, 12.0], [0.0, 10.0, 20.0]]
    faces = {"X0": outer(0, 0), "Y0": outer(1, 0), "Z0": outer(2, 0), "Z1": outer(2, 2)}
    grid = Grid(axes, lambda i, j, k: bodies[min(k, len(bodies) - 1)], faces)
    steel = {"E": 210000.0, "nu": 0.3, "fy": 235.0}
    document = {
        "mesh": "m.msh",
        "analysis": analysis,
        "materials": {"steel": steel},
        "bodies": {b: "steel" for b in dict.fromkeys(bodies)},
        "supports": [{"face": "Z0", "fix": ["x", "y", "z"]}],
        "loads": [{"face": "Z1", "traction": load}],
    }
    if law:
        document["interfaces"] = [{"between": ["A", "B"], **law}]
    return document, grid.mesh()


def bases(case):
    """Finished results to change, made once; each is confirmed as it is."""
    import random

    made = {}
    friction = {"law": "contact", "mu": 0.4, "friction": "associated"}
    scene = Scene()
    scene.document = {"mesh": "m.msh", "analysis": "elastic"}
    bolted(random.Random("preload"), scene, "elastic")
    models = {
        "bar": block("limit", None, [80.0, 0.0, 30.0], ("A",)),
        "block": block("elastic", friction, [2.0, 0.0, -30.0]),
        "lap": block("limit", dict(friction, friction="coulomb"), [10.0, 0.0, -40.0]),
        "plastic": block("elastoplastic", friction, [5.0, 0.0, -200.0]),
        "weld": block("limit", {"law": "weld", "strength_traction": 60.0}, [30.0, 5.0, 10.0]),
        "preload": (scene.document, scene.grid.mesh()),
    }
    for name, (document, mesh) in models.items():
        case.write(f"{name}/{name}.yaml", document)
        case.write(f"{name}/m.msh", mesh.text())
        case.run("analyse", f"{name}/{name}.yaml", "-q", "--threads", "1")
        made[name] = case.folder / name / name
    case.write("splice.yaml", spec_text(SPLICE))
    case.run("check", "splice.yaml", "-q")
    made["check"] = case.folder / "splice_check"
    case.write("joint.yaml", spec_text(JOINT))
    case.run("run", "joint.yaml", "-q", "--threads", "1", "--size-factor", "4", limit=300)
    made["run"] = case.folder / "joint"
    good = {}
    for name, folder in made.items():
        if not (folder / "result.json").is_file():
            case.fault("no result", f"base {name}")
            continue
        case.verify(folder)
        good[name] = folder
    return good


def reseal(folder, changed):
    """Writes the digest of a changed file anew."""
    path = folder / "digests.b3"
    lines = path.read_text().splitlines()
    name = str(changed.relative_to(folder))
    found = [i for i, line in enumerate(lines) if line.split("  ", 1)[1] == name]
    new = f"{digest(changed.read_bytes())}  {name}"
    for i in found:
        lines[i] = new
    path.unlink()
    path.write_text("\n".join(lines) + "\n")


def copied(source, target):
    """Links to all files: a changed one is written anew, the others cost nothing."""
    shutil.copytree(source, target, copy_function=os.link)


def replace(path, data):
    path.unlink()
    if isinstance(data, str):
        path.write_text(data)
    else:
        path.write_bytes(data)


def forge(r, folder, sealed):
    """Changes one value below the folder. Returns the file, the key, the old and new value."""
    kinds = ["result", "result", "result", "result", "field", "field", "mesh", "model"]
    kinds += ["load"] if sealed else ["report", "digest", "other"]
    kind = r.choice(kinds)
    if kind == "result":
        path = folder / "result.json"
        document, *what = json_change(r, json.loads(path.read_text()))
        replace(path, json.dumps(document, indent=2) + "\n")
    elif kind == "report":
        path = folder / "report.json"
        document, *what = json_change(r, json.loads(path.read_text()))
        replace(path, json.dumps(document, indent=2) + "\n")
    elif kind == "load":
        # another demand in the spec that the result answers
        path = folder / "report.json"
        document = json.loads(path.read_text())
        if '"end"' not in document["input_text"]:
            raise NoChange
        document["input_text"], *what = spec_load(r, document["input_text"])
        replace(path, json.dumps(document, indent=2) + "\n")
    elif kind == "digest":
        path = folder / "digests.b3"
        lines = path.read_text().split("\n")
        i = r.randrange(len(lines) - 1)
        old = lines[i]
        k = r.randrange(64)
        lines[i] = old[:k] + ("0" if old[k] != "0" else "1") + old[k + 1 :]
        what = ["digest", old, lines[i]]
        replace(path, "\n".join(lines))
    else:
        pattern = {"field": "fields/*.vtu", "mesh": "**/*.msh", "model": "**/*.yaml"}
        files = sorted(p for p in folder.glob(pattern.get(kind, "**/*")) if p.is_file())
        files = [p for p in files if p.name != "digests.b3" and p.stat().st_size]
        if not files:
            raise NoChange
        path = r.choice(files)
        if kind == "field":
            data, *what = field_change(r, path.read_bytes())
        elif kind == "mesh":
            data, *what = mesh_change(r, path.read_text())
        elif kind == "model":
            data, *what = text_change(r, path.read_text())
        else:
            data = bytearray(path.read_bytes())
            k = r.randrange(len(data))
            what = ["byte", data[k], data[k] ^ (1 << r.randrange(8))]
            data[k] = what[2]
            data = bytes(data)
        replace(path, data)
    return kind, path, what


def spec_load(r, text):
    """Another size of one action in the line of the loads."""
    found = [m for m in re.finditer(r'"(N|Vy|Vz|My|Mz|T)": "(-?[\d.]+) ', text)]
    m = r.choice(found)
    old = float(m.group(2))
    new = round(old * r.choice([0.5, 0.9, 1.1, 2.0]), 6)
    return text[: m.start(2)] + repr(new) + text[m.end(2) :], f"load {m.group(1)}", old, new


def recorded_keys():
    """The keys that nothing proves, from the table of docs/results.md."""
    page = RESULTS_PAGE.read_text()
    table = page[page.index("| recorded | why nothing proves it |") :].split("\n\n")[0]
    cells = [row.split("|")[1] for row in table.splitlines()[2:]]
    # other rows describe in words what else is recorded
    keys = [cell for cell in cells if re.fullmatch(r"\s*(`[^`: ]+`,?\s*)+", cell)]
    return [key for cell in keys for key in cell.split("`")[1::2]]


def is_recorded(key, keys):
    """True for a recorded key and what stands below it. That a program ran is checked."""
    place, _, how = key.partition(" ")
    below = any(place.startswith((k + ".", k + "[")) for k in keys)
    program = place.rsplit(".", 1)[-1] in ("kinematic", "static", "static_frictionless")
    return below or place in keys and not (program and how)


def negligible(key, old, new):
    """True for a change that rounding could have made."""
    if key.startswith("cases[].certificate.") and isinstance(old, float):
        # residuals are rounding errors themselves; the tolerance of a strict bound is 1e-9
        return abs(new - old) < 1e-10
    if isinstance(old, (int, float)) and isinstance(new, (int, float)):
        return abs(new - old) <= SAME * max(abs(old), abs(new))
    return old == new


def run(case):
    r = case.random
    if "bases" not in case.state:
        shop = Case(case.program, NAME, case.seed, "bases", case.scratch / "forgeries-bases")
        case.state["bases"] = bases(shop)
        case.faults += shop.faults
        case.counts.update(shop.counts)
        case.state["recorded"] = recorded_keys()
        # the digests of the program are those of this hash
        any_folder = case.state["bases"]["bar"]
        for line in (any_folder / "digests.b3").read_text().splitlines():
            hash_, name = line.split("  ", 1)
            if digest((any_folder / name).read_bytes()) != hash_:
                case.fault("campaign", f"BLAKE3 of {name} differs")
    name = r.choice(sorted(case.state["bases"]))
    sealed = r.random() < 0.7
    folder = case.folder / "result"
    copied(case.state["bases"][name], folder)
    try:
        kind, path, (key, old, new) = forge(r, folder, sealed)
    except NoChange:
        case.count("nothing to change there")
        return
    if negligible(key, old, new):
        case.count("too small to count")
        return
    if sealed:
        reseal(folder, path)
    outcome = case.run("verify", "result", limit=120)
    place = f"{kind} {key}"
    what = f"{name}: {path.relative_to(folder)}: {key}: {old!r} -> {new!r}"
    how = "digests written anew" if sealed else "digests as they were"
    case.note(f"{how}: {what}: exit {outcome.code}")
    if outcome.code in (1, 2):
        case.count(f"refused, {how}")
    elif outcome.code != 0:
        case.fault("exit code", f"{how}: {what}: {outcome.code}")
    elif not sealed:
        case.fault(f"accepted with old digests: {place}", what)
    elif kind == "result" and is_recorded(key, case.state["recorded"]):
        case.count("accepted, recorded only")
    elif kind in ("model", "mesh") and name != "run":
        # the bounds are proved for the changed model too, or the value has no part in them
        case.count("accepted, proved for the changed model")
        case.examples.setdefault(f"proved anyway {key}", what)
    else:
        case.fault(f"accepted: {place}", what)
