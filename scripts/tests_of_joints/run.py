"""Runs the tests of joints, one after the other; a test that has a result of the same spec is not run again.

usage: run.py [--only KIND] [--passes N] [ID...]
       run.py --check           `bracket check` accepts the specs (seconds; a test of scripts/test.sh)

KIND is limit, route or stiffness; without ids all tests are run. N meshes for each bound of limit analysis, 3 by default: fewer are
a quick look, and a later call with more takes them on. Results go to results/tests_of_joints/ID_KIND. A run has a time limit of its
own; a machine that is busy gives wider brackets.
"""

import hashlib
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import specs

ROOT = specs.ROOT
OUT = ROOT / "results" / "tests_of_joints"
BRACKET = ROOT / os.environ.get("CARGO_TARGET_DIR", "target") / "release" / "bracket"
# exit codes of a run that ended with a result
ENDED = {0, 1, 3}


def program() -> str:
    """The program: BRACKET, or the release build."""
    return os.environ.get("BRACKET", str(BRACKET))


def digest(name: str, kind: str, tests: dict[str, dict]) -> str:
    """Hash of the joint that is run: spec without limits of the run, strengths, profiles, template."""
    test = tests[name]
    profiles = [specs.PROFILES.get(test[part]["profile"]) for part in ("column", "beam")]
    template = (specs.DATA / "compression_stiffener.yaml").read_text(encoding="utf-8") if "stiffener" in test else ""
    text = [line for line in specs.spec(name, test, kind).splitlines() if not line.startswith(("analysis:", "project:"))]
    whole = json.dumps([text, test["column"], test["beam"], test["plate"], test["bolts"], profiles, template])
    return hashlib.sha256(whole.encode()).hexdigest()[:16]


def finished(name: str, kind: str, tests: dict[str, dict], passes: int) -> bool:
    """Whether the result of this very spec is there, with as many meshes."""
    mark = OUT / f"{name}_{kind}.mark"
    if not mark.is_file() or not (OUT / f"{name}_{kind}" / "result.json").is_file():
        return False
    done = json.loads(mark.read_text(encoding="utf-8"))
    return done["spec"] == digest(name, kind, tests) and (kind != "limit" or done["passes"] >= passes)


def run(name: str, kind: str, tests: dict[str, dict], passes: int) -> None:
    """One run, with its last line on the terminal."""
    folder = OUT / f"{name}_{kind}"
    began = time.monotonic()
    log = OUT / f"{name}_{kind}.log"
    with log.open("w", encoding="utf-8") as file:
        command = [program(), "run", str(OUT / "specs" / f"{name}_{kind}.yaml"), "--out", str(folder)]
        if kind == "limit":
            command += ["--max-passes", str(passes)]
        code = subprocess.run(command, cwd=ROOT, stdout=file, stderr=subprocess.STDOUT, check=False).returncode
    last = log.read_text(encoding="utf-8").strip().splitlines()[-1:]
    print(f"{name} {kind}: exit code {code}, {time.monotonic() - began:.0f} s: {' '.join(last)}", file=sys.stderr, flush=True)
    if code in ENDED and (folder / "result.json").is_file():
        mark = {"spec": digest(name, kind, tests), "passes": passes}
        (OUT / f"{name}_{kind}.mark").write_text(json.dumps(mark), encoding="utf-8")


def check(tests: dict[str, dict]) -> int:
    """Whether `bracket check` accepts the specs: it gives a result, whatever the verdict."""
    faults = 0
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        paths = specs.write(tests, folder / "specs")
        # the kinds differ in loads and analysis alone: all strengths, and the first of each other kind
        firsts = {path.stem.rsplit("_", 1)[1]: path for path in reversed(paths)}
        chosen = [path for path in paths if path.stem.endswith("_limit") or path in firsts.values()]
        for path in chosen:
            command = [program(), "--quiet", "check", str(path), "--out", str(folder / path.stem)]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            if done.returncode not in ENDED or not (folder / path.stem / "result.json").is_file():
                print(f"tests_of_joints: {path.stem} is refused:\n{done.stderr}", file=sys.stderr)
                faults += 1
    return 1 if faults else 0


def main(arguments: list[str]) -> int:
    """Command line."""
    tests = specs.load()
    if arguments == ["--check"]:
        return check(tests)
    only, passes = None, 3
    while len(arguments) > 1 and arguments[0] in ("--only", "--passes"):
        if arguments[0] == "--only":
            only = arguments[1]
        else:
            passes = int(arguments[1])
        arguments = arguments[2:]
    unknown = [name for name in arguments if name not in tests]
    if unknown:
        print(f"tests_of_joints: no test {', '.join(unknown)}; there are {', '.join(tests)}", file=sys.stderr)
        return 2
    specs.write(tests, OUT / "specs")
    asked = [(n, k) for n, k in specs.runs(tests) if (not arguments or n in arguments) and only in (None, k)]
    todo = [(n, k) for n, k in asked if not finished(n, k, tests, passes)]
    print(f"{len(asked)} runs, {len(asked) - len(todo)} of them finished", file=sys.stderr, flush=True)
    for name, kind in todo:
        run(name, kind, tests, passes)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
