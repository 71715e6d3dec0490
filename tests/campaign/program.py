"""The program under test: it is started as a process, watched, and its end is described."""

import json
import os
import signal
import subprocess
import tempfile
import time
from pathlib import Path

DOCUMENTED = {0, 1, 2, 3, 4}
# words of a Rust program that ended by a fault of its own
PANIC = ("panicked at", "RUST_BACKTRACE", "stack overflow", "fatal runtime error")


class Outcome:
    """How a process ended."""

    def __init__(self, args, code, out, err, seconds, peak_mib, timed_out, orphans):
        self.args, self.code, self.out, self.err = args, code, out, err
        self.seconds, self.peak_mib = seconds, peak_mib
        self.timed_out, self.orphans = timed_out, orphans

    def refusal(self):
        """The code of the first error message: `model/loose-part`."""
        for line in self.err.splitlines():
            if line.startswith("error["):
                return line[6 : line.index("]")]
        return "no code"

    def message(self):
        """The first error message."""
        lines = [line for line in self.err.splitlines() if line.startswith("error")]
        return lines[0] if lines else self.err.strip()[:200]


class Running:
    """A started process. It leads a session of its own, so that what it leaves behind is found."""

    def __init__(self, command, cwd, env, patience, stdin=None, stdout=None):
        self.command = command
        self.patience = patience
        self.out_file = tempfile.TemporaryFile()
        self.err_file = tempfile.TemporaryFile()
        self.start = time.monotonic()
        self.process = subprocess.Popen(
            command,
            cwd=cwd,
            env=env,
            stdin=stdin or subprocess.DEVNULL,
            stdout=stdout or self.out_file,
            stderr=self.err_file,
            start_new_session=True,
        )
        self.status = None
        self.usage = None

    def poll(self):
        """True when it has ended."""
        if self.status is None:
            pid, status, usage = os.wait4(self.process.pid, os.WNOHANG)
            if pid:
                self.status, self.usage = status, usage
                # Popen must not wait for a process that is gone
                self.process.returncode = os.waitstatus_to_exitcode(status)
        return self.status is not None

    def send(self, number):
        if not self.poll():
            os.kill(self.process.pid, number)

    def wait(self, limit):
        """Waits for the end. After `limit` seconds, times the patience, the whole session is
        killed."""
        end = time.monotonic() + self.patience * limit
        pause = 0.002
        while not self.poll() and time.monotonic() < end:
            time.sleep(pause)
            pause = min(0.02, 1.3 * pause)
        timed_out = not self.poll()
        seconds = time.monotonic() - self.start
        left = [p for p in session(self.process.pid) if p != self.process.pid]
        if timed_out:
            for pid in [self.process.pid, *left]:
                quietly_kill(pid)
            while not self.poll():
                time.sleep(0.01)
            left = []
        elif left:
            # a child that ends together with its parent needs a moment
            time.sleep(0.5)
            left = session(self.process.pid)
        orphans = [f"{pid} {name_of(pid)}" for pid in left]
        for pid in left:
            quietly_kill(pid)
        texts = []
        for file in (self.out_file, self.err_file):
            file.seek(0)
            texts.append(file.read().decode("utf-8", "replace"))
            file.close()
        return Outcome(
            self.command[1:],
            os.waitstatus_to_exitcode(self.status),
            *texts,
            seconds,
            self.usage.ru_maxrss / 1024,
            timed_out,
            orphans,
        )


def session(leader):
    """Processes of a session that are alive."""
    found = []
    for entry in os.listdir("/proc"):
        if entry.isdigit():
            try:
                text = Path("/proc", entry, "stat").read_text()
            except OSError:
                continue
            # the name in brackets may hold spaces
            fields = text[text.rindex(")") + 2 :].split()
            if int(fields[3]) == leader and fields[0] not in "ZX":
                found.append(int(entry))
    return found


def name_of(pid):
    try:
        return Path("/proc", str(pid), "cmdline").read_bytes().replace(b"\0", b" ").decode()
    except OSError:
        return "ended meanwhile"


def quietly_kill(pid):
    try:
        os.kill(pid, signal.SIGKILL)
    except ProcessLookupError:
        pass


class Program:
    """The program with its environment. `patience` multiplies all time limits: a machine that does
    other work is slower."""

    def __init__(self, path, checkout, patience=1.0):
        self.path = str(path)
        self.patience = patience
        self.env = dict(os.environ, RUST_BACKTRACE="0")
        # temporary folders lie outside the checkout, where the search for `.venv` ends in nothing
        tools = Path(checkout, ".venv", "bin")
        for key, name in (("BRACKET_GMSH", "gmsh"), ("BRACKET_MMG", "mmg3d")):
            if key not in self.env and (tools / name).exists():
                self.env[key] = json.dumps([str(tools / "python"), str(tools / name)])

    def start(self, args, cwd, **more):
        return Running([self.path, *map(str, args)], cwd, self.env, self.patience, **more)

    def json(self, *args):
        """The data that a listing command prints."""
        done = self.start([*args, "--format", "json"], "/").wait(60)
        return json.loads(done.out)
