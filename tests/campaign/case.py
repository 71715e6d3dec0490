"""One case of an arm: its folder, its random numbers, and what is noticed about the program."""

import json
import random
import re
import shutil
from collections import Counter
from pathlib import Path

from program import DOCUMENTED, PANIC


class Fault:
    """Something the program must not do."""

    def __init__(self, kind, detail):
        self.kind, self.detail = kind, detail


class Case:
    """A case repeats exactly from the seed, the arm and its index, whatever ran before it."""

    def __init__(self, program, arm, seed, index, folder):
        self.program, self.arm, self.seed, self.index = program, arm, seed, index
        self.random = random.Random(f"{seed}/{arm}/{index}")
        self.folder = Path(folder)
        self.folder.mkdir(parents=True)
        self.counts = Counter()
        self.refusals = Counter()
        self.reasons = Counter()
        self.examples = {}
        self.faults = []
        self.commands = []
        self.lines = []

    # --- what happened -------------------------------------------------------------------------

    def count(self, what, number=1):
        self.counts[what] += number

    def fault(self, kind, detail=""):
        self.faults.append(Fault(kind, detail))

    def refused(self, outcome, expected):
        """Counts a refusal by its code. One that the generator did not expect is a fault."""
        code = outcome.refusal()
        self.refusals[code] += 1
        self.examples.setdefault(code, outcome.message())
        if not expected:
            self.count("valid refused")
            self.fault("valid input refused", f"{code}: {outcome.message()}")

    def reason(self, sentence):
        """Counts a sentence of the program without its numbers."""
        self.reasons[re.sub(r"[\d.,e+-]*\d[\d.e+-]*", "#", sentence)[:150]] += 1

    def note(self, line):
        self.lines.append(line)

    def probe(self):
        """A case beside this one, for a try that is not counted."""
        number = len(list(self.folder.glob("probe*")))
        probe = Case(self.program, self.arm, self.seed, self.index, self.folder / f"probe{number}")
        return probe

    # --- files and commands --------------------------------------------------------------------

    def write(self, name, content):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if isinstance(content, (dict, list)):
            # JSON is YAML
            content = json.dumps(content, indent=1)
        if isinstance(content, bytes):
            path.write_bytes(content)
        else:
            path.write_bytes(content.encode("utf-8", "surrogatepass"))
        return path

    def start(self, *args, **more):
        self.commands.append("bracket " + " ".join(map(str, args)))
        return self.program.start(args, more.pop("cwd", self.folder), **more)

    def run(self, *args, limit=120, documented=DOCUMENTED, **more):
        """Runs the program to its end. What no command may ever do is a fault at once."""
        outcome = self.start(*args, **more).wait(limit)
        self.judge_end(outcome, documented)
        return outcome

    def judge_end(self, outcome, documented=DOCUMENTED):
        what = " ".join(map(str, outcome.args))
        words = next((w for w in PANIC if w in outcome.err), None)
        if words:
            self.fault("panic", f"{what}: {outcome.err.strip()[:600]}")
        if outcome.timed_out:
            self.fault("too slow", f"{what}: not ended after {outcome.seconds:.0f} s")
        elif outcome.code not in documented:
            self.fault("exit code", f"{what}: {outcome.code}: {outcome.err.strip()[:400]}")
        if outcome.orphans:
            self.fault("left a process", f"{what}: {outcome.orphans}")

    def result(self, folder):
        """`result.json` of a folder; `None` where there is none."""
        path = self.folder / folder / "result.json"
        return json.loads(path.read_text()) if path.is_file() else None

    def verify(self, folder, want=0, limit=120):
        """Every finished result must be confirmed."""
        outcome = self.run("verify", folder, limit=limit)
        if outcome.code == want:
            self.count("verified")
        else:
            self.fault("verify", f"exit {outcome.code}: {(outcome.out + outcome.err)[-800:]}")
        return outcome

    def parts(self):
        """Unfinished folders and files that are left."""
        return [str(p.relative_to(self.folder)) for p in self.folder.rglob("*.part*")]

    # --- the end -------------------------------------------------------------------------------

    def keep(self, folder):
        """Copies the case with its commands and faults."""
        place = Path(folder) / f"{self.arm}-{self.seed}-{self.index}"
        if place.exists():
            shutil.rmtree(place)
        shutil.copytree(self.folder, place, symlinks=True, ignore_dangling_symlinks=True)
        words = [f"{f.kind}: {f.detail}\n" for f in self.faults]
        (place / "FAULTS.txt").write_text("\n".join(words) + "\n" + "\n".join(self.lines))
        (place / "COMMANDS.sh").write_text("\n".join(self.commands) + "\n")


def bounds(entry):
    """Lower and upper bound of an entry of `cases`; `None` where there is none."""
    lower, upper = entry.get("lower"), entry.get("upper")
    return lower, (float("inf") if upper == "unbounded" else upper)


def check_bounds(case, result, what=""):
    """Bounds are ordered and strict. Returns them by the name of their entry."""
    found = {}
    for entry in result.get("cases", []):
        lower, upper = bounds(entry)
        name = f"{entry['name']}/{entry['analysis']}"
        found[name] = (lower, upper)
        if lower is None and upper is None:
            continue
        if lower is None and upper == float("inf") and "certificate" not in entry:
            # the solver found no limit: an estimate, and it says so
            case.count("unbounded, not certified")
            continue
        case.count("bounds")
        if not entry.get("certificate", {}).get("strict", False):
            case.count("not strict")
            case.fault("not strict", f"{what}{name}: {entry.get('certificate')}")
        if lower is not None and upper is not None:
            case.count("brackets")
            # equal bounds of an exact solution differ by rounding
            if lower > upper + 1e-12 * abs(upper):
                case.fault("bounds crossed", f"{what}{name}: {lower} > {upper}")
    return found
