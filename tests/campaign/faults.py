"""Arm `faults`: kill -9, signals, two runs at once, full disks, folders that vanish.

After each of them a result is whole or absent, and files of the user are where they were.
"""

import errno
import os
import shutil
import signal
import subprocess
import threading
import time
from pathlib import Path

from forgeries import JOINT, SPLICE, block
from grid import Grid
from model_scenes import outer
from program import quietly_kill, session
from spec_scenes import text as spec_text

NAME = "faults"
SHARE = 0.12
# Seconds within which a signal must end the program, on a machine with nothing else to do. Writing
# the pictures of what is certified takes most of it.
PROMPT = 5
# seconds of the adaptive analysis in which signals come; it takes longer
ADAPTING = 6.0
MINE = "notes of the user.txt"
SWEEP = {
    "base": "joint.yaml",
    "axes": {"plate.thickness": [10, 12, 14, 15, 16, 18, 20, 22, 25]},
    "first": "checks",
}
FOLDER = {
    "run": "stub", "analyse": "block", "adapt": "adapt", "check": "joint_check", "batch": "sweep",
}
COMMAND = {
    "run": ["run", "stub.yaml", "--size-factor", "4", "--kind", "elastic", "--max-passes", "1"],
    "analyse": ["analyse", "block.yaml"],
    "adapt": ["analyse", "adapt.yaml"],
    "check": ["check", "joint.yaml"],
    "batch": ["batch", "sweep.yaml", "--jobs", "1"],
}
WHAT = ["kill"] * 2 + ["signal"] * 3 + ["two"] + ["full"] * 2 + ["stdout", "read-only", "deleted"]


def prompt():
    """The same on this machine as it is now."""
    return PROMPT * max(1.0, os.getloadavg()[0] / (os.cpu_count() or 1))


def inputs(case):
    """Inputs of all commands."""
    law = {"law": "contact", "mu": 0.3, "friction": "coulomb"}
    document, mesh = block("limit", law, [8.0, 2.0, -30.0])
    case.write("block.yaml", document)
    case.write("m.msh", mesh.text())
    axes = [[0.0, 5.0, 10.0, 20.0], [0.0, 12.0], [0.0, 10.0, 20.0]]
    faces = {"Z0": outer(2, 0), "Z1": outer(2, 2)}
    grid = Grid(axes, lambda i, j, k: "AB"[k] if i < 2 or k == 0 else None, faces)
    law = dict(law, mu=0.4, friction="associated")
    document = dict(document, interfaces=[{"between": ["A", "B"], **law}])
    # long enough that each bound has meshes of its own when a signal comes
    limits = {"target_gap": 0.001, "max_passes": 6, "max_macro_tets": 8000}
    case.write("adapt.yaml", dict(document, mesh="a.msh", adapt=limits))
    case.write("a.msh", grid.mesh().text())
    case.write("joint.yaml", spec_text(SPLICE))
    case.write("stub.yaml", spec_text(JOINT))
    case.write("sweep.yaml", spec_text(SWEEP))


def length(case, name):
    """How long a command takes when nothing disturbs it."""
    lengths = case.state.setdefault("lengths", {"adapt": ADAPTING})
    if name not in lengths:
        outcome = case.run(*COMMAND[name], "-q", "--threads", "1")
        lengths[name] = outcome.seconds
        shutil.rmtree(case.folder / FOLDER[name], ignore_errors=True)
    return lengths[name]


def whole(case, what, name, folder=None):
    """The result is absent or confirmed by `verify`; nothing is left beside it."""
    folder = folder or case.folder
    place = folder / FOLDER[name]
    if name != "batch" and (place / "result.json").is_file():
        case.verify(place)
    elif name != "batch" and place.is_dir():
        left = [p.name for p in place.iterdir() if p.name != MINE]
        if left:
            case.fault("half a result", f"{what}: {left[:6]}")


def again(case, what, name):
    """The same command succeeds and leaves nothing unfinished."""
    if name == "adapt":
        return
    outcome = case.run(*COMMAND[name], "-q", "--threads", "1", limit=200)
    if outcome.code == 2:
        case.fault("not repeatable", f"{what}: exit 2: {outcome.message()}")
        return
    whole(case, f"{what}, again", name)
    parts = case.parts()
    if parts:
        case.fault("left .part", f"{what}, again: {parts}")
    case.count("repeated")


def earlier(case, r, name):
    """In half of the cases there is a result with a file of the user in it."""
    if r.random() < 0.5 or name in ("batch", "adapt"):
        return False
    case.run(*COMMAND[name], "-q", "--threads", "1", limit=200)
    case.write(f"{FOLDER[name]}/{MINE}", "mine")
    return True


def kept(case, what, name, had):
    path = case.folder / FOLDER[name] / MINE
    if had and not (path.is_file() and path.read_text() == "mine"):
        case.fault("lost a file of the user", what)


def run(case):
    r = case.random
    inputs(case)
    what = r.choice(WHAT)
    {
        "kill": kill, "signal": interrupt, "two": two, "full": full, "stdout": stdout,
        "read-only": read_only, "deleted": deleted,
    }[what](case, r)
    case.count(what)


def kill(case, r):
    """SIGKILL at any moment. Its helpers end by themselves."""
    name = r.choice(["run", "analyse", "analyse", "adapt", "check", "check", "batch"])
    seconds = length(case, name)
    had = earlier(case, r, name)
    running = case.start(*COMMAND[name], "-q", "--threads", "1")
    delay = r.uniform(0, seconds)
    wait(running, delay)
    running.send(signal.SIGKILL)
    what = f"kill -9 of {name} after {delay:.3f} s"
    case.note(what)
    limit = time.monotonic() + prompt()
    while not running.poll() or session(running.process.pid):
        if time.monotonic() > limit:
            left = session(running.process.pid)
            case.fault("orphan", f"{what}: {len(left)} processes")
            for pid in left:
                quietly_kill(pid)
            break
        time.sleep(0.02)
    running.wait(prompt())
    whole(case, what, name)
    again(case, what, name)
    kept(case, what, name, had)


def wait(running, seconds):
    threading.Event().wait(seconds) if not running.poll() else None


def interrupt(case, r):
    """SIGTERM or SIGINT at any moment ends the program soon and in order."""
    name = r.choice(["run", "analyse", "analyse", "adapt", "adapt", "check", "batch"])
    seconds = length(case, name)
    had = earlier(case, r, name)
    running = case.start(*COMMAND[name], "--threads", "1")
    delay = r.uniform(0, seconds)
    wait(running, delay)
    number = r.choice([signal.SIGTERM, signal.SIGINT, signal.SIGHUP])
    running.send(number)
    outcome = running.wait(prompt())
    what = f"{number.name} to {name} after {delay:.3f} s"
    case.note(f"{what}: exit {outcome.code}")
    # before its handlers stand and in commands that end at once a signal just ends the process
    early = outcome.code == -number and (name in ("check", "batch") or delay < 0.1)
    if early:
        case.count("ended by the signal itself")
    else:
        case.judge_end(outcome)
    if outcome.code == 2:
        case.fault("exit code", f"{what}: exit 2: {outcome.message()}")
    parts = case.parts()
    if parts and not early:
        case.fault("left .part", f"{what}: {parts}")
    whole(case, what, name)
    kept(case, what, name, had)
    if r.random() < 0.5:
        again(case, what, name)
        kept(case, f"{what}, again", name, had)


def two(case, r):
    """Two at once into one folder: one whole result; the other one too, or refused in words."""
    name = r.choice(["analyse", "check", "run"])
    seconds = length(case, name)
    had = earlier(case, r, name)
    first = case.start(*COMMAND[name], "-q", "--threads", "1")
    wait(first, r.uniform(0, seconds))
    second = case.start(*COMMAND[name], "-q", "--threads", "1")
    for outcome in (first.wait(120), second.wait(120)):
        case.judge_end(outcome)
        if outcome.code in (2, 4) and "error" not in outcome.err:
            case.fault("no error said", f"two at once, {name}: exit {outcome.code}")
        if outcome.code in (2, 4):
            case.reason(f"two at once: {outcome.message()}")
    what = f"two at once, {name}"
    if not (case.folder / FOLDER[name] / "result.json").is_file():
        case.fault("no result", what)
    whole(case, what, name)
    parts = case.parts()
    if parts:
        case.fault("left .part", f"{what}: {parts}")
    kept(case, what, name, had)


def full(case, r):
    """A disk of 4 KiB to 4 MiB, in twenty steps."""
    if os.geteuid() != 0:
        case.count("skipped: a small disk needs root")
        return
    name = r.choice(["run", "analyse", "analyse", "check", "check", "batch"])
    kib = round(4 * 1024 ** (r.randrange(20) / 19))
    disk = case.folder / "disk"
    disk.mkdir()
    size = [f"size={kib}k", "-t", "tmpfs", "tmpfs", str(disk)]
    if subprocess.run(["mount", "-o", *size], capture_output=True).returncode:
        case.count("skipped: no mount allowed")
        return
    try:
        place = disk / FOLDER[name]
        option = [] if name == "batch" else ["--out", str(place)]
        if name == "batch":
            option = ["-o", str(place)]
        outcome = case.run(*COMMAND[name], "-q", "--threads", "1", *option)
        what = f"{name} on a disk of {kib} KiB"
        case.note(f"{what}: exit {outcome.code}: {outcome.message()}")
        case.count(f"disk full: exit {outcome.code}")
        finished = (place / "result.json").is_file()
        if outcome.code == 4 and "error" not in outcome.err:
            case.fault("no error said", f"{what}: {outcome.err[:300]}")
        if outcome.code == 2:
            case.fault("exit code", f"{what}: exit 2: {outcome.message()}")
        if name == "batch":
            return
        if not finished and outcome.code not in (3, 4):
            case.fault("exit code", f"{what}: exit {outcome.code} without a result")
        if finished and outcome.code == 4:
            case.fault("exit code", f"{what}: exit 4 with a result: {outcome.message()}")
        whole(case, what, name, disk)
        parts = [p.name for p in disk.rglob("*.part*")]
        if parts:
            case.fault("left .part", f"{what}: {parts}")
    finally:
        subprocess.run(["umount", "-l", str(disk)], capture_output=True)


TALK = [
    ["templates"], ["templates", "t_stub"], ["schema", "spec"], ["catalog", "list", "profiles"],
    ["catalog", "show", "HEB200"], ["new", "t_stub"], ["doctor"], ["--help"], ["verify", "block"],
    ["check", "joint.yaml", "--format", "json"], ["analyse", "block.yaml", "--format", "json"],
    ["batch", "sweep.yaml", "--format", "json"],
    ["mesh", "stub.yaml", "--size-factor", "4", "--format", "json"],
]


def stdout(case, r):
    """Standard output that is full or that nobody reads."""
    command = r.choice(TALK)
    if command[0] == "verify":
        case.run(*COMMAND["analyse"], "-q")
    closed = r.random() < 0.5
    if closed:
        reader, writer = os.pipe()
        os.close(reader)
    else:
        writer = os.open("/dev/full", os.O_WRONLY)
    try:
        outcome = case.run(*command, stdout=writer)
    finally:
        os.close(writer)
    what = f"{' '.join(command)} with {'a closed' if closed else 'a full'} standard output"
    case.note(f"{what}: exit {outcome.code}: {outcome.message()}")
    case.count(f"{'closed' if closed else 'full'} output: exit {outcome.code}")
    if not closed and outcome.code != 4:
        case.fault("exit code", f"{what}: {outcome.code}: {outcome.err[:200]}")
    parts = case.parts()
    if parts:
        case.fault("left .part", f"{what}: {parts}")


def read_only(case, r):
    """A folder in which nothing may be written."""
    name = r.choice(["analyse", "check", "run", "batch"])
    before = sorted(os.listdir(case.folder))
    drop = None
    if os.geteuid() == 0:
        # root writes anywhere: the program runs as nobody
        if not allowed(case):
            case.count("skipped: no other user can start the program")
            return
        drop = 65534
    os.chmod(case.folder, 0o555)
    try:
        outcome = as_user(case, drop, COMMAND[name])
    finally:
        os.chmod(case.folder, 0o755)
    what = f"{name} in a read-only folder"
    case.note(f"{what}: exit {outcome.returncode}: {outcome.stderr[:300]}")
    if outcome.returncode != 4 or "error" not in outcome.stderr:
        case.fault("exit code", f"{what}: {outcome.returncode}: {outcome.stderr[:300]}")
    if "panicked" in outcome.stderr:
        case.fault("panic", f"{what}: {outcome.stderr[:300]}")
    if sorted(os.listdir(case.folder)) != before:
        case.fault("written although read-only", what)


def allowed(case):
    try:
        done = as_user(case, 65534, ["--version"])
    except (OSError, subprocess.SubprocessError):
        return False
    return done.returncode == 0


def as_user(case, uid, command):
    os.chmod(case.scratch, 0o755)
    case.commands.append("bracket " + " ".join(command))
    return subprocess.run(
        [case.program.path, *command],
        cwd=case.folder,
        env=dict(case.program.env, HOME="/nonexistent"),
        user=uid,
        capture_output=True,
        text=True,
        timeout=120,
    )


def deleted(case, r):
    """The working folder, or the result folder, vanishes while the program runs."""
    name = r.choice(["analyse", "check", "run", "adapt"])
    seconds = length(case, name)
    work = case.folder / "work"
    work.mkdir()
    for path in case.folder.iterdir():
        if path.is_file():
            shutil.copy(path, work)
    running = case.start(*COMMAND[name], "-q", "--threads", "1", cwd=work)
    wait(running, r.uniform(0, seconds))
    for _ in range(20):
        try:
            shutil.rmtree(work)
            break
        except FileNotFoundError:
            break
        except OSError as error:
            # a file was written meanwhile
            if error.errno != errno.ENOTEMPTY:
                raise
    # the adaptive analysis may go on to its end
    outcome = running.wait(200)
    case.judge_end(outcome)
    what = f"{name} in a folder that was deleted"
    case.note(f"{what}: exit {outcome.code}: {outcome.message()}")
    case.count(f"deleted: exit {outcome.code}")
    if outcome.code == 0 and not Path(work, FOLDER[name], "result.json").exists():
        case.count("deleted after the end")
