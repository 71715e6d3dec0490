"""Writes the generated blocks of README.md and docs/, so that nothing the program says is typed by hand.

usage: readme.py            rewrite the blocks (run scripts/paper_joint.sh first)
       readme.py --check    exit 1 if a block differs; numbers may differ by 1 % (other machines round differently)

A block stands between `<!-- generated:NAME … -->` and `<!-- /generated:NAME -->`. `BLOCKS` says in which file:
  picture    the picture of the mesh, copied from results/paper_joint to docs/
  spec       examples/paper_joint/joint.yaml without its comments
  result     the history table and the bracket, from results/paper_joint/result.json
  worked     the expected result of examples/one_sided_stiffened (expected.json, `heavy`)
  templates  what `bracket templates NAME` prints of every template
  annexes    what `bracket catalog list annexes` prints
  study, limit_study   tables and plots of docs/study, written by scripts/study.sh (their times are of one machine: never checked)
  help       what `bracket --help` prints
"""

import csv
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys

import json

ROOT = pathlib.Path(__file__).resolve().parent.parent
EXAMPLE = ROOT / "examples" / "paper_joint"
RESULT = ROOT / "results" / "paper_joint"
WORKED = ROOT / "examples" / "one_sided_stiffened"
PICTURE = pathlib.PurePosixPath("docs/paper_joint.png")
TOLERANCE = 0.01


class Fault(Exception):
    """Something the blocks are made of is missing; the text says what to run."""


def result() -> dict:
    """The finished result of the paper's joint."""
    path = RESULT / "result.json"
    if not path.is_file():
        raise Fault(f"{path.relative_to(ROOT)} is missing: run scripts/paper_joint.sh")
    return json.loads(path.read_text(encoding="utf-8"))


def picture(check: bool) -> str:
    """The first picture of the result: mesh.png, or whatever stands first by name."""
    found = sorted(RESULT.glob("*.png"), key=lambda p: (p.name != "mesh.png", p.name))
    if not found:
        raise Fault(f"no picture in {RESULT.relative_to(ROOT)}: run scripts/paper_joint.sh")
    if not check:
        (ROOT / PICTURE).parent.mkdir(exist_ok=True)
        shutil.copyfile(found[0], ROOT / PICTURE)
    elif not (ROOT / PICTURE).is_file():
        raise Fault(f"{PICTURE} is missing: run scripts/readme.py")
    return f"![The meshed joint, drawn by the program]({PICTURE})"


def spec(_check: bool) -> str:
    """The spec as it is run."""
    lines = (EXAMPLE / "joint.yaml").read_text(encoding="utf-8").splitlines()
    body = "\n".join(line for line in lines if not line.lstrip().startswith("#")).strip("\n")
    return f"```yaml\n{body}\n```"


def number(value, direction=None) -> str:
    """Six figures, rounded towards `direction` (math.floor or math.ceil): a bound stays a bound. Words stay words."""
    if not isinstance(value, float):
        return str(value)
    if direction and value:
        step = 10.0 ** (math.floor(math.log10(abs(value))) - 5)
        value = direction(value / step) * step
    return f"{value:.6g}"


def table(case: dict) -> list[str]:
    """One row per mesh."""
    head = ["macro tets", "lower", "upper", "gap %"]
    lines = ["| " + " | ".join(head) + " |", "|" + " ---: |" * len(head)]
    for row in case["history"]:
        cells = [number(row.get(key, "–"), way) for key, way in (("macro_tets", None), ("lower", math.floor), ("upper", math.ceil))]
        cells.append(f"{math.ceil(1e4 * row['gap']) / 100:.2f}" if "gap" in row else "–")
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def bracket(_check: bool) -> str:
    """Every case: what was bracketed, the history, the certificate."""
    lines = []
    for case in result()["cases"]:
        unit = " N mm" if case["quantity"] == "potential_energy" else ""
        lower, upper = number(case.get("lower", "–"), math.floor), number(case.get("upper", "–"), math.ceil)
        quantity = case["quantity"].replace("_", " ")
        word = "lies between" if case["certificate"]["strict"] else "is estimated between"
        lines.append(f"`{case['name']}`, {case['analysis']}: the {quantity} {word} **{lower}** and **{upper}**{unit}.")
        if "load_displacement" in case:
            near, far = (number(v, way) for v, way in zip(case["load_displacement"], (math.floor, math.ceil)))
            lines.append(f"So the load moves by between {near} and {far} mm.")
        lines += ["", *table(case), ""]
        residuals = [f"{key.replace('_', ' ')} {value:.0e}" for key, value in case["certificate"].items() if key != "strict"]
        lines += ["Certificate, largest residuals: " + ", ".join(residuals) + ".", ""]
    return "\n".join(lines).rstrip("\n")


def study_table(name: str) -> list[str]:
    """The rows of a stored study."""
    path = ROOT / "docs" / "study" / f"{name}.csv"
    if not path.is_file():
        raise Fault(f"{path.relative_to(ROOT)} is missing: run scripts/study.sh")
    lines = ["| meshes | macro tets | certified gap | all meshes so far [s] | peak memory [MiB] |", "| --- | ---: | ---: | ---: | ---: |"]
    with path.open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            gap = f"{math.ceil(1e4 * float(row['gap'])) / 100:.2f} %" if row["gap"] else "–"
            seconds = f"{float(row['total_seconds']):.0f}"
            lines.append(f"| {row['meshes']} | {row['macro_tets']} | {gap} | {seconds} | {row['peak_memory_mib']} |")
    return lines


def study(_check: bool) -> str:
    """The stored study of the paper's joint in elastic analysis, and its plot."""
    plot = "![Certified gap against the number of tetrahedra](study/paper_elastic_tets.png)"
    return "\n".join([*study_table("paper_elastic"), "", plot])


def limit_study(_check: bool) -> str:
    """The stored studies in limit analysis, and their plots."""
    lines = []
    for name, title in (("paper_limit", "The joint of the README"), ("splice_limit", "`examples/splice_extended`")):
        lines += [f"{title}:", "", *study_table(name), ""]
        lines += [f"![Certified gap against wall time](study/{name}_time.png)", ""]
    return "\n".join(lines).rstrip("\n")


def worked(_check: bool) -> str:
    """The expected result of the worked example, in sentences."""
    expected = json.loads((WORKED / "expected.json").read_text(encoding="utf-8"))["heavy"]
    (case, wanted), *_ = expected["cases"].items()
    lower, upper = wanted["overlaps"]
    least, most = math.floor(1e3 / upper) / 1e3, math.ceil(1e3 / lower) / 1e3
    used = expected["utilisations"]["moment and axial force of the joint"]
    moment = expected["resistances"]["tension at the top: moment resistance of the joint"]
    verdict = expected["verdict"].replace("_", " ").upper()
    return "\n".join(
        [
            f"- By analysis: the load factor of `{case}` at collapse lies between **{lower}** and **{upper}**. So the load uses",
            f"  between {least} and {most} of the capacity.",
            f"- By code: M_j,Rd = {moment / 1e6:.1f} kN m by the component method, utilisation {used:.2f}.",
            f"- Verdict: **{verdict}**, exit code {expected['exit']}.",
        ]
    )


def program(*arguments: str) -> str:
    """What the program prints."""
    path = ROOT / os.environ.get("CARGO_TARGET_DIR", "target") / "release" / "bracket"
    if not path.is_file():
        raise Fault("the program is not built: cargo build --release --locked")
    return subprocess.run([path, *arguments], check=True, capture_output=True, text=True).stdout


def templates(_check: bool) -> str:
    """Every template with its parameters, sections and member ends."""
    lines = []
    for row in program("templates").splitlines():
        template = json.loads(program("templates", row.split()[0], "--format", "json"))
        roles = ", ".join(f"`{m['role']}`" for m in template["members"]) or "none"
        lines += [f"### `{template['name']}`: {template['title']}", "", template["about"], "", f"Members: {roles}.", ""]
        lines += ["| parameter | meaning |", "| --- | --- |"]
        for p in template["parameters"]:
            required = " (required)" if p["required"] else ""
            lines.append(f"| `{p['name']}` | {p['about']}{required} |")
        lines.append("")
        if template["sections"]:
            lines += ["| section for `section:` | meaning |", "| --- | --- |"]
            lines += [f"| `{s['name']}` | {s['about']} |" for s in template["sections"]] + [""]
        if template["ends"]:
            lines += ["| member end for `end:` | points for `at:` | meaning |", "| --- | --- | --- |"]
            for e in template["ends"]:
                points = ", ".join(f"`{a}`" for a in e["at"])
                lines.append(f"| `{e['name']}` | {points} | {e['about']} |")
            lines.append("")
    return "\n".join(lines).rstrip("\n")


def annexes(_check: bool) -> str:
    """The partial factors of the annexes."""
    return "```text\n" + "\n".join(line.rstrip() for line in program("catalog", "list", "annexes").splitlines()) + "\n```"


def help_text(_check: bool) -> str:
    """The subcommands."""
    return "```text\n" + "\n".join(line.rstrip() for line in program("--help").strip().splitlines()) + "\n```"


BLOCKS = {
    "README.md": {"picture": picture, "spec": spec, "result": bracket, "worked": worked},
    "docs/guide.md": {"templates": templates, "annexes": annexes, "study": study, "limit_study": limit_study},
    "docs/contract.md": {"help": help_text},
}


def same(old: str, new: str) -> bool:
    """Equal word for word; numbers within the tolerance, residuals (`1e-13`) not compared."""
    # residuals are rounding noise: only that they are there is compared
    old, new = (re.sub(r"\d+e[+-]\d+", "RESIDUAL", t).split() for t in (old, new))
    if len(old) != len(new):
        return False
    for a, b in zip(old, new):
        try:
            x, y = (float(word.strip("*.")) for word in (a, b))
        except ValueError:
            if a != b:
                return False
        else:
            if not abs(x - y) <= TOLERANCE * max(abs(x), abs(y)):
                return False
    return True


def rewrite(name: str, blocks: dict, check: bool) -> list[str]:
    """Rewrites the blocks of a file, or only compares them; the names of those that differ."""
    path = ROOT / name
    text = path.read_text(encoding="utf-8")
    stale = []
    for block, make in blocks.items():
        pattern = re.compile(rf"(<!-- generated:{block}\b[^>]*-->\n)(.*?)(<!-- /generated:{block} -->)", re.DOTALL)
        match = pattern.search(text)
        if match is None:
            raise Fault(f"{name} has no block `{block}`")
        try:
            new = make(check) + "\n"
        except Fault as fault:
            raise Fault(f"{name}, block `{block}`: {fault}") from fault
        if not same(match.group(2), new):
            stale.append(block)
        if not check:
            text = text[: match.start(2)] + new + text[match.end(2) :]
    if not check:
        path.write_text(text, encoding="utf-8")
    return stale


def main() -> int:
    """Rewrites or checks the blocks."""
    check = sys.argv[1:] == ["--check"]
    if sys.argv[1:] and not check:
        print(__doc__, file=sys.stderr)
        return 2
    code = 0
    for name, blocks in BLOCKS.items():
        try:
            stale = rewrite(name, blocks, check)
        except Fault as fault:
            print(f"readme: {fault}", file=sys.stderr)
            return 1
        for block in stale if check else []:
            print(f"readme: {name}, block `{block}` is stale: run scripts/readme.py", file=sys.stderr)
            code = 1
    return code


if __name__ == "__main__":
    sys.exit(main())
