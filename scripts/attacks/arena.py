"""Where the attacks happen: one folder, children with limits, and what they leave behind."""
import dataclasses
import os
import re
import resource
import shutil
import signal
import subprocess
import time
from pathlib import Path

USED = ("matchday", "ssl-", "team-reference", "team-chaser", "fake-team", "libshifted_clock")
MARK = "MATCHDAY_ATTACK"  # in the environment of every child
CODES = (0, 1, 2, 3, 4, 5, 10, 11, 74)  # of experiments/exit_code.h, without 70 (a mistake of ours) and signals
MEMORY = 1 << 30  # [byte] ours: reading a folder or log of these sizes takes under 64 MiB
ADDRESSES = 8 << 30  # [byte] of one process, so that a hole cannot take the machine
PRINTED = 256 << 20  # [byte] of one file a child writes
QUOTED = 1 << 20  # [byte] of an output that are read
# Words of a program that was surprised, instead of a sentence of its own.
SURPRISE = re.compile(r"terminate called|Assertion|internal error|what\(\):|Traceback|basic_string|vector::|std::|Sanitizer"
                      r"|stoi|stod|stoul|bad_alloc|map::at|type_error|Unexpected|SEGV")
# Control characters but line feed and tab, their 8-bit twins in UTF-8, and what turns the direction of text (U+202A to
# U+202E, U+2066 to U+2069).
RAW = re.compile(rb"[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]|\xe2\x80[\xaa-\xae]|\xe2\x81[\xa6-\xa9]")


@dataclasses.dataclass
class Ended:
    """A child that has ended, or was ended because its time was over."""
    command: list
    code: int
    out: bytes
    err: bytes
    seconds: float
    memory: int  # [byte] greatest of it and of its children
    late: bool
    after: float = 0  # [s] that it went on after the last signal it was sent

    @property
    def words(self):
        return self.err.decode("utf-8", "replace")

    def last(self):
        lines = [line for line in self.words.splitlines() if line.strip()]
        return printable(lines[-1])[:200] if lines else "nothing"


def printable(text):
    return "".join(c if c.isprintable() else f"\\x{ord(c):02x}" for c in text)


def kill(pid, number):
    try:
        os.kill(pid, number)
        return True
    except ProcessLookupError:
        return False


class Child:
    """One program with limits of memory and output, in a session of its own."""

    def __init__(self, arena, command, cwd=None, env=None, addresses=ADDRESSES):
        self.arena, self.command, self.begin = arena, [str(word) for word in command], time.monotonic()
        arena.children += 1
        base = arena.folder / f"child-{arena.children}"
        self.files = [base.with_suffix(".out"), base.with_suffix(".err")]
        environment = {**os.environ, MARK: arena.token, "TMPDIR": str(arena.scratch), "HOME": str(arena.home), **(env or {})}

        def limits():
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            resource.setrlimit(resource.RLIMIT_FSIZE, (PRINTED, PRINTED))
            if addresses:
                resource.setrlimit(resource.RLIMIT_AS, (addresses, addresses))

        with open(self.files[0], "wb") as out, open(self.files[1], "wb") as err:
            self.process = subprocess.Popen(self.command, stdin=subprocess.DEVNULL, stdout=out, stderr=err, env=environment,
                                            cwd=cwd or arena.folder, preexec_fn=limits, start_new_session=True)
        self.pid, self.status, self.usage = self.process.pid, None, None
        self.sent = self.begin
        arena.started[self.pid] = self

    def running(self):
        if self.status is None:
            pid, status, usage = os.wait4(self.pid, os.WNOHANG)
            if pid:
                self.status, self.usage = status, usage
                del self.arena.started[self.pid]
                self.process.returncode = os.waitstatus_to_exitcode(status)
        return self.status is None

    def said(self):
        """What it has printed to standard error so far."""
        return self.files[1].read_bytes()[:QUOTED].decode("utf-8", "replace")

    def seconds(self):
        return time.monotonic() - self.begin

    def send(self, number):
        self.sent = time.monotonic()
        return self.running() and kill(self.pid, number)

    def wait(self, limit):
        """Its end; after `limit` seconds it is ended with all it has started."""
        late = False
        pause = 0.002
        until = time.monotonic() + limit
        while self.running():
            if not late and time.monotonic() > until:
                late = True
                self.arena.end(self.arena.started_by(self.pid) + [self.pid])
            time.sleep(pause)
            pause = min(pause * 1.5, 0.05)
        texts = []
        for file in self.files:
            with open(file, "rb") as stream:
                text = stream.read(QUOTED)
                stream.seek(max(0, os.path.getsize(file) - 4096))
                texts.append(text if len(text) < QUOTED else text + b"\n" + stream.read())
            file.unlink()
        return Ended(self.command, self.process.returncode, *texts, time.monotonic() - self.begin,
                     self.usage.ru_maxrss * 1024, late, time.monotonic() - self.sent)


class Arena:
    """@param folder  of everything that is written; the caller removes it
    @param alone   whether we are in a process and mount namespace of our own: all other processes are ours"""

    def __init__(self, folder, programs, alone):
        self.folder, self.alone = folder, alone
        self.programs = folder / "programs"  # a copy: a build meanwhile would change what is attacked
        self.programs.mkdir()
        for file in programs.iterdir():
            if file.name.startswith(USED):
                shutil.copy2(file, self.programs / file.name)
        self.token = folder.name
        self.scratch, self.home = folder / "scratch", folder / "home"
        self.started = {}  # number -> Child
        self.scratch.mkdir()
        self.home.mkdir()
        self.children = 0
        self.known = set()  # processes of a row that are meant to stay
        self.matchday, self.autoref, self.sim = (self.programs / name for name in ("matchday", "ssl-autoref", "ssl-sim"))

    def start(self, *command, **options):
        return Child(self, command, **options)

    def run(self, *command, limit=60, **options):
        return Child(self, command, **options).wait(limit)

    def place(self, name):
        """A fresh folder."""
        folder = self.folder / name
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        return folder

    def processes(self, sign=None):
        """Living processes that the attack has started, {pid: words}; with `sign` those with it in their environment."""
        found = {}
        own = {os.getpid(), os.getppid()}
        for entry in Path("/proc").iterdir():
            if not entry.name.isdigit() or int(entry.name) in own:
                continue
            try:
                state = (entry / "stat").read_text().rsplit(")", 1)[1].split()[0]
                if state in "ZX":
                    continue
                environment = (entry / "environ").read_bytes().split(b"\0")
                if not self.alone and f"{MARK}={self.token}".encode() not in environment:
                    continue
                if sign and not any(line.startswith(sign.encode()) for line in environment):
                    continue
                found[int(entry.name)] = (entry / "cmdline").read_bytes().decode("utf-8", "replace").split("\0")
            except OSError:
                pass  # it has ended
        return found

    def started_by(self, pid):
        """Its descendants."""
        parents = {}
        for other in self.processes():
            try:
                text = Path(f"/proc/{other}/stat").read_text().rsplit(")", 1)[1].split()
                parents[other] = int(text[1])
            except OSError:
                pass
        found, group = [], {pid}
        while group:
            group = {child for child, parent in parents.items() if parent in group}
            found += group
        return found

    def end(self, pids):
        for pid in pids:
            kill(pid, signal.SIGKILL)

    def reap(self):
        """Orphans come to us in a process namespace of our own; those that have ended are taken off the table."""
        if not self.alone:
            return
        for entry in Path("/proc").iterdir():
            try:
                if entry.name.isdigit() and int(entry.name) not in self.started:
                    fields = (entry / "stat").read_text().rsplit(")", 1)[1].split()
                    if fields[0] == "Z" and int(fields[1]) == os.getpid():
                        os.waitpid(int(entry.name), os.WNOHANG)
            except OSError:
                pass  # it has gone

    def left_over(self, patience=3):
        """Processes that are still there after `patience` seconds; they are ended, and told."""
        self.reap()
        until = time.monotonic() + patience
        while True:
            found = {pid: words for pid, words in self.processes().items() if pid not in self.known}
            if not found:
                return []
            if time.monotonic() > until:
                break
            time.sleep(0.05)
        self.end(found)
        names = sorted({printable(" ".join(words[:2])) for words in found.values()})
        return [f"{len(found)} processes are left over: {', '.join(names)[:160]}"]

    def temporary(self):
        """Temporary files that are left; they are removed, and told."""
        left = sorted(path.name for path in self.scratch.iterdir())
        for name in left:
            path = self.scratch / name
            shutil.rmtree(path, ignore_errors=True) if path.is_dir() else path.unlink()
        return [f"temporary files are left: {', '.join(left)[:160]}"] if left else []


def answer(ended, codes=CODES, memory=MEMORY, raw=True, sentence=True):
    """What is wrong with how a program ended, as sentences: it may refuse, in one sentence of its own."""
    who = " ".join(Path(word).name if number == 0 else word for number, word in enumerate(ended.command[:2]))
    wrong = []
    if ended.late:
        wrong.append(f"{who} did not end within its time; it had said: {ended.last()}")
    elif ended.code < 0:
        wrong.append(f"{who} ended by {signal.Signals(-ended.code).name}: {ended.last()}")
    elif ended.code not in codes:
        wrong.append(f"{who} ended with code {ended.code}: {ended.last()}")
    surprise = SURPRISE.search(ended.words)
    if surprise and not wrong:
        begin = ended.words.rfind("\n", 0, surprise.start()) + 1
        wrong.append(f"{who} was surprised: {printable(ended.words[begin:].splitlines()[0])[:200]}")
    if ended.memory > memory:
        wrong.append(f"{who} took {ended.memory >> 20} MiB")
    if raw and (RAW.search(ended.out) or RAW.search(ended.err.replace(b"\r", b""))):
        wrong.append(f"{who} printed a control character")
    if sentence and not wrong and ended.code in (2, 5):
        # Before it may stand the game that it is about.
        own = [line for line in ended.words.splitlines() if re.match(r"([\w.-]+-\d+-\d: )?(matchday|ssl-autoref|ssl-sim): ", line)]
        if len(own) != 1:
            wrong.append(f"{who} refused (code {ended.code}) in {len(own)} sentences instead of one: {ended.last()}")
    return wrong
