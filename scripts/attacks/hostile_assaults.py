"""What a team can do to the machine, to the others and to the results; methods as in hostile_faults.py."""
import ctypes
import multiprocessing
import os
import resource
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

MIB = 1 << 20
PIECE = 128 * MIB


class Assaults:
    # --- memory, processes, files

    def tick_eats_memory(self, tick):
        self.eaten = getattr(self, "eaten", []) + [bytearray(16 * MIB)]
        self.eaten[-1][::4096] = b"x" * len(self.eaten[-1][::4096])

    def fork(self, count, session, then=None):
        for _ in range(count):
            if os.fork() == 0:
                if session:
                    os.setsid()
                    if os.fork():
                        os._exit(0)
                (then or self.hang)()

    def once_forks(self, tick):
        self.fork(10, False)

    def once_forks_and_crash(self, tick):
        self.fork(20, False)
        self.crash()

    def once_daemons(self, tick):
        self.fork(10, True)

    def once_daemons_and_crash(self, tick):
        self.fork(10, True)
        self.crash()

    def once_hidden_daemon(self, tick):
        """Without the environment by which it would be found."""
        mark = {key: os.environ[key] for key in ("MATCHDAY_ATTACK",) if key in os.environ}
        self.fork(2, True, lambda: os.execve("/bin/sleep", ["sleep", "600"], mark))

    def once_many_processes(self, tick):
        def family():
            for _ in range(5):
                if os.fork() == 0:
                    self.hang()
            self.hang()
        self.fork(40, True, family)

    def once_fork_bomb(self, tick):
        """1000 processes: each starts three others and leaves, so that none stays long enough to be ended."""
        left = multiprocessing.Value("i", 1000)

        def grow():
            for _ in range(3):
                with left.get_lock():
                    left.value -= 1
                    over = left.value < 0
                if over:
                    self.hang()
                if os.fork() == 0:
                    time.sleep(0.01)
                    grow()
            os._exit(0)
        if os.fork() == 0:
            grow()

    def once_many_files(self, tick):
        resource.setrlimit(resource.RLIMIT_NOFILE, (resource.getrlimit(resource.RLIMIT_NOFILE)[1],) * 2)
        self.files = []
        while len(self.files) < 5000:
            try:
                self.files.append(os.open("/dev/null", os.O_RDONLY))
            except OSError:
                break

    def once_fills_folder(self, tick):
        os.chdir(self.logs)
        for n in range(60):
            Path(f"junk-{n}").write_bytes(bytes(MIB))

    def pieces(self, size, make):
        """Files of PIECE each: the attack bounds the size of one file."""
        self.held = [make(number) for number in range(-(-size // PIECE))]
        for file in self.held:
            os.posix_fallocate(file, 0, PIECE)

    def once_memfd(self, tick):
        """Memory that no process has mapped, twice of what is allowed."""
        self.pieces(512 * MIB, lambda number: os.memfd_create(f"held-{number}"))

    def once_unlinked(self, tick):
        """Files without a name, a fifth above the GiB that is allowed."""
        def make(number):
            path = Path(self.logs) / f"held-{number}"
            file = os.open(path, os.O_CREAT | os.O_RDWR)
            path.unlink()
            return file
        self.pieces(1229 * MIB, make)

    def once_odd_files(self, tick):
        os.chdir(self.logs)
        os.mkfifo("pipe")
        os.symlink("/etc/passwd", "link")
        os.symlink(".", "round")
        Path("-rf *").mkdir()
        Path("\x1b[31m").write_text("")
        os.chmod(".", 0)

    # --- the others

    def others(self):
        """Everything the attack has started and we can see: (number, words)."""
        family = {os.getpid()}
        for entry in Path("/proc").iterdir():
            try:
                if not entry.name.isdigit() or int(entry.name) in family:
                    continue
                if f"MATCHDAY_ATTACK={self.token}".encode() not in (entry / "environ").read_bytes().split(b"\0"):
                    continue
                yield int(entry.name), (entry / "cmdline").read_bytes().decode().split("\0")
            except OSError:
                pass

    def to_others(self, number_of, only=None):
        for pid, words in self.others():
            if only is None or any(only in word for word in words[:4]):
                try:
                    os.kill(pid, number_of)
                except OSError:
                    pass

    def once_kills_other_team(self, tick):
        self.to_others(signal.SIGKILL, "team-reference")

    def once_stops_other_team(self, tick):
        self.to_others(signal.SIGSTOP, "team-reference")

    def once_kills_runner(self, tick):
        self.to_others(signal.SIGKILL, "run")

    def once_stops_host(self, tick):
        self.to_others(signal.SIGSTOP, "worker")

    def once_kills_all(self, tick):
        self.to_others(signal.SIGKILL)

    def once_kills_parent(self, tick):
        if os.getppid() > 1:
            os.kill(os.getppid(), signal.SIGKILL)

    def once_traces_others(self, tick):
        libc = ctypes.CDLL(None)
        for pid, _words in self.others():
            if libc.ptrace(0x4206, pid, 0, 0) == 0:  # PTRACE_SEIZE
                libc.ptrace(0x4207, pid, 0, 0)  # PTRACE_INTERRUPT

    def sockets(self):
        """Of the other games and teams."""
        own = os.environ["MATCHDAY_SOCKET"]
        lines = Path("/proc/net/unix").read_text().splitlines()
        found = {line.split()[7] for line in lines if len(line.split()) > 7}
        for parent in list(Path(own).parents)[:2]:
            try:
                found |= {str(path) for path in parent.rglob("*") if path.is_socket()}
            except OSError:
                pass
        return [path for path in found if path != own and path.startswith("/")]

    def visit(self, path):
        try:
            channel = self.connect(path)
            channel.settimeout(0.2)
            channel.sendall(self.hello(name="impostor"))
            channel.recv(1 << 16)
            self.kept = getattr(self, "kept", []) + [channel]
        except OSError:
            pass

    def start_visits_early(self):
        until = time.monotonic() + 1
        while time.monotonic() < until:
            for path in self.sockets():
                self.visit(path)

    def once_visits_others(self, tick):
        for path in self.sockets():
            self.visit(path)

    def start_connects_twice(self):
        self.first = self.connect()

    def once_connects_again(self, tick):
        self.visit(os.environ["MATCHDAY_SOCKET"])

    def start_removes_socket(self):
        self.socket = self.connect()
        try:
            os.unlink(os.environ["MATCHDAY_SOCKET"])
        except OSError:
            pass
        self.connect = lambda: self.socket

    # --- the result folder

    def once_writes_ledger(self, tick):
        for file in (self.folder / "ledger.sqlite", self.folder / "manifest.json", self.folder / "status.json"):
            try:
                with open(file, "r+b") as stream:
                    stream.write(b"owned" * 1000)
            except OSError:
                pass

    def once_removes_results(self, tick):
        shutil.rmtree(self.folder, ignore_errors=True)

    def once_forges_ledger(self, tick):
        subprocess.run([sys.executable, "-c", "import sqlite3,sys;d=sqlite3.connect(sys.argv[1]);"
                        "d.execute('UPDATE attempts SET goals_yellow=99');d.commit()", str(self.folder / "ledger.sqlite")],
                       stderr=subprocess.DEVNULL)
