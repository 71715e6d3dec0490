"""Arm `mutations`: broken input ends in order, with an error that says so."""

import shutil

from broken import changed
from case import Case
from forgeries import SPLICE, block
from spec_scenes import text as spec_text

NAME = "mutations"
SHARE = 0.12
SECONDS = 20
# MiB of a process
MEMORY = 2048
SWEEP = {
    "base": "joint.yaml",
    "table": "joints.csv",
    "axes": {"plate.thickness": [12, 15], "bolts.size, bolts.gauge": [["M16", 100], ["M20", 110]]},
    "set": {"bolts.rows": ["60 mm - beam.h / 2", "beam.h / 2 - 60 mm"]},
    "where": ["plate.thickness >= bolt.d / 2"],
    "first": "checks",
    "choose": {"least": "3 * mass + bolts"},
    "expect": ["failed == 0"],
}
TABLE = "name,members.beam.profile,loads.ULS1.My [kN m]\nA,IPE300,40\nB,IPE360,60\n"
# what each kind of file is read by: file to break, command, files that the command may write
KINDS = {
    "spec": ("joint.yaml", ["check", "joint.yaml"]),
    "spec meshed": (
        "joint.yaml", ["mesh", "joint.yaml", "--size-factor", "4", "--time-limit", "8"],
    ),
    "template": ("own.yaml", ["check", "with_template.yaml"]),
    "catalogue": ("tables/profiles.csv", ["check", "with_table.yaml"]),
    "model": ("block.yaml", ["analyse", "block.yaml"]),
    "mesh": ("m.msh", ["analyse", "block.yaml"]),
    "sweep": ("sweep.yaml", ["batch", "sweep.yaml", "--jobs", "1"]),
    "table": ("joints.csv", ["batch", "sweep.yaml", "--jobs", "1"]),
    "result verified": ("result/result.json", ["verify", "result"]),
    "result reported": ("result/report.json", ["report", "result"]),
    "result printed": ("result/result.json", ["report", "result", "--full"]),
    "field": ("result/fields/*", ["verify", "result"]),
    "digests": ("result/digests.b3", ["verify", "result"]),
}
WEIGHTS = [5, 0.5, 4, 3, 5, 4, 3, 2, 4, 1, 1, 2, 1]


def prepare(case):
    """Valid inputs of all kinds, made once."""
    document, mesh = block(
        "elastic", {"law": "contact", "mu": 0.3, "friction": "associated"}, [1.0, 0.0, -20.0]
    )
    case.write("block.yaml", document)
    case.write("m.msh", mesh.text())
    case.write("joint.yaml", spec_text(SPLICE))
    case.write("sweep.yaml", spec_text(SWEEP))
    case.write("joints.csv", TABLE)
    # the built-in template and table, as files of the user
    templates = case.checkout / "templates"
    own = (templates / "beam_splice.yaml").read_text().replace("name: beam_splice", "name: own")
    case.write("own.yaml", own)
    case.write("with_template.yaml", spec_text(dict(SPLICE, template="own.yaml")))
    rows = (case.checkout / "catalogs" / "profiles_i.csv").read_text().splitlines()
    head = [i for i, row in enumerate(rows) if row.startswith("name,")][0]
    row = next(r for r in rows if r.startswith("IPE300,")).replace("IPE300,", "OWN300,", 1)
    case.write("tables/profiles.csv", "# source: mill sheet\n" + rows[head] + "\n" + row + "\n")
    own = dict(SPLICE, members={"beam": {"profile": "OWN300", "steel": "S235"}}, catalog="tables")
    case.write("with_table.yaml", spec_text(own))
    for kind, (_, command) in KINDS.items():
        if kind.startswith(("result", "field", "digests")):
            continue
        outcome = case.run(*command, limit=120)
        if outcome.code == 2:
            case.fault("campaign", f"{kind}: the valid file is refused: {outcome.message()}")
    (case.folder / "block").rename(case.folder / "result")
    for made in ("joint", "joint_check", "with_template_check", "with_table_check", "sweep"):
        shutil.rmtree(case.folder / made, ignore_errors=True)


def everything(folder):
    """Names and sizes of all files and folders."""
    return {
        str(p.relative_to(folder)): p.stat().st_size if p.is_file() else -1
        for p in folder.rglob("*")
    }


def run(case):
    r = case.random
    if "valid" not in case.state:
        shop = Case(case.program, NAME, case.seed, "valid", case.scratch / "mutations-valid")
        shop.checkout = case.checkout
        prepare(shop)
        case.faults += shop.faults
        case.state["valid"] = shop.folder
    kind = r.choices(list(KINDS), WEIGHTS)[0]
    name, command = KINDS[kind]
    shutil.copytree(case.state["valid"], case.folder, dirs_exist_ok=True)
    files = sorted(case.folder.glob(name))
    path = r.choice(files)
    valid = path.read_bytes()
    names, data = changed(r, valid)
    path.write_bytes(data)
    if data == valid:
        case.count("unchanged")
        return
    before = everything(case.folder)
    outcome = case.start(*command, "--threads", "1").wait(SECONDS)
    sweep = command[0] == "batch" and "plan:" in outcome.err
    if sweep and outcome.timed_out:
        # what is left of the sweep is valid and asks for analyses
        case.count("sweep that analyses")
        return
    case.judge_end(outcome)
    case.note(f"{kind}: {names} in {path.name}: exit {outcome.code}, {outcome.seconds:.1f} s")
    case.count(f"{kind}: exit {outcome.code}")
    what = f"{kind} {names}"
    if outcome.peak_mib > MEMORY:
        case.fault("too much memory", f"{what}: {outcome.peak_mib:.0f} MiB")
    if outcome.code == 2 and sweep:
        # some joints of the sweep are refused; its tables say which
        case.count("sweep with bad input")
    elif outcome.code == 2:
        case.refusals[outcome.refusal()] += 1
        if "error" not in outcome.err:
            case.fault("no error said", f"{what}: {outcome.err[:300]!r}")
        after = everything(case.folder)
        if after != before:
            new = [n for n in after if before.get(n) != after[n]]
            lost = [n for n in before if n not in after]
            case.fault("written although refused", f"{what}: new {new[:5]}, lost {lost[:5]}")
    elif outcome.code in (1, 3, 4) and not outcome.err + outcome.out:
        case.fault("no error said", f"{what}: exit {outcome.code} without a word")
    if any(ord(c) < 32 and c not in "\n\t\r" for c in outcome.err + outcome.out):
        case.fault("control characters", f"{what}: {(outcome.err + outcome.out)[:200]!r}")
    parts = case.parts()
    if parts and not outcome.timed_out:
        case.fault("left .part", f"{what}: {parts}")
