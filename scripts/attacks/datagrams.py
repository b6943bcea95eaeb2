"""Random and mutated datagrams at ssl-sim, which must go on answering."""
import os
import select
import socket
import time
from pathlib import Path

from . import arena as tools
from . import damage
from .row import Row
from .wire import delimited, floating, number, text

BATCH = 1000  # datagrams a try: then it must answer, and hold no more than before
BURST = 50  # sent before its answers are read
PORTS = {"control": 31300, "blue": 31301, "yellow": 31302}
GROWTH = 32 << 20  # [byte] ours: what it may hold more than after the first tries; robots, cameras and specs are bounded


def robot_id(dice):
    return number(1, dice.choice((0, 1, 5, 15, 16, 2**32 - 1))) + number(2, dice.choice((0, 1, 2, 3)))


def value(dice):
    return dice.choice((0.0, 1.0, -1.0, 1e-30, 1e30, float("nan"), float("inf"), -float("inf"), dice.uniform(-10, 10)))


def command(dice):
    """RobotControl, more or less as it should be."""
    robots = b""
    for _ in range(dice.choice((0, 1, 6, 20))):
        kind = dice.choice((1, 2, 3))
        move = b"".join(floating(field, value(dice)) for field in range(1, 5 if kind == 1 else 4))
        robots += delimited(1, number(1, dice.choice((0, 3, 15, 200))) + delimited(2, delimited(kind, move)) + floating(3, value(dice))
                            + floating(4, value(dice)) + floating(5, value(dice)))
    return robots


def control(dice):
    """SimulatorCommand: teleports, specs, realism; its speed stays, so that the world moves on."""
    ball = b"".join(floating(field, value(dice)) for field in range(1, 7)) + b"".join(number(field, dice.randrange(2)) for field in (7, 8, 9))
    robot = delimited(1, robot_id(dice)) + b"".join(floating(field, value(dice)) for field in range(2, 8)) + number(8, dice.randrange(2))
    specs = delimited(1, robot_id(dice)) + b"".join(floating(field, value(dice)) for field in (2, 3, 4, 7, 8, 9))
    specs += delimited(10, b"".join(floating(field, value(dice)) for field in range(1, 7)))
    any_field = text(1, "type.googleapis.com/matchday.simulation.RealismMatchday") + delimited(2, text(1, dice.choice(("none", "harsh", "x"))))
    parts = [delimited(1, delimited(1, ball)), delimited(1, delimited(2, robot)), delimited(2, delimited(2, specs)),
             delimited(2, delimited(3, delimited(1, any_field))), b""]
    return b"".join(dice.choice(parts) for _ in range(dice.choice((1, 1, 2, 8))))


class Datagrams(Row):
    name = "datagrams"
    what = f"random and mutated datagrams at ssl-sim's three ports, {BATCH} a try; it goes on answering"
    checks = "ssl-sim answers plain questions after each try; memory and files stay bounded"
    tries = 225
    least = 3
    seconds = 100

    def prepare(self):
        self.simulator = self.arena.start(self.arena.sim, *[word for name, port in PORTS.items() for word in (f"--{name}-port", port)],
                                          "--vision-port", "31320", "--duration", "900")
        self.arena.known.add(self.simulator.pid)
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", 0))
        self.socket.setblocking(False)
        self.sent = self.answered = 0
        self.held = self.files = None
        if not self.alive(patience=10):
            raise RuntimeError(f"ssl-sim did not start: {self.simulator.said()[-200:]}")

    def drain(self, until, wanted):
        """Reads answers until there are so many or the time is over."""
        found = 0
        while found < wanted and time.monotonic() < until:
            if select.select([self.socket], [], [], max(0, until - time.monotonic()))[0]:
                try:
                    while found < wanted:
                        self.socket.recv(65536)
                        found += 1
                except BlockingIOError:
                    pass
        return found

    def alive(self, patience=3):
        """Whether each port answers a plain question."""
        for port in PORTS.values():
            until = time.monotonic() + patience
            while True:
                self.drain(time.monotonic() + 0.001, 10_000)
                self.send(b"", port)
                if self.drain(time.monotonic() + 0.2, 1):
                    break
                if time.monotonic() > until or not self.simulator.running():
                    return False
        return True

    def send(self, data, port):
        try:
            self.socket.sendto(data, ("127.0.0.1", port))
        except (BlockingIOError, ConnectionRefusedError):
            pass

    def datagram(self, dice):
        name = dice.choice(tuple(PORTS))
        data = (control if name == "control" else command)(dice)
        kind = dice.random()
        if kind < 0.25:
            data = dice.randbytes(dice.choice((0, 1, 10, 200, 1400, 8192, 8193, 60_000)) if dice.random() < 0.1 else dice.randint(0, 200))
        elif kind < 0.7:
            data = damage.bytes_of(data, dice)[0][:60_000]
        return data, PORTS[name]

    def attempt(self, _number, dice):
        for _ in range(BATCH // BURST):
            for _ in range(BURST):
                self.send(*self.datagram(dice))
            self.sent += BURST
            self.answered += self.drain(time.monotonic() + 0.05, BURST)
        if not self.alive():
            ended = self.simulator.wait(0.1) if not self.simulator.running() else None
            self.prepare() if ended else None
            return [f"ssl-sim ended with {ended.code}: {ended.last()}" if ended else "ssl-sim does not answer any more"]
        fields = Path(f"/proc/{self.simulator.pid}/status").read_text()
        held = int(fields.split("VmRSS:")[1].split()[0]) * 1024
        files = len(os.listdir(f"/proc/{self.simulator.pid}/fd"))
        self.held = self.held or held
        self.notes = [f"{self.sent} datagrams, {self.answered} answers; it holds {held / 2**20:.1f} MiB, {files} files"]
        wrong = []
        if held > self.held + GROWTH:
            wrong.append(f"ssl-sim grew from {self.held >> 20} to {held >> 20} MiB")
        self.files = self.files or files
        if files > self.files:
            wrong.append(f"ssl-sim has {files} open files after {self.files}")
        return wrong

    def clean(self):
        if hasattr(self, "simulator") and self.simulator.running():
            self.simulator.send(15)
            ended = self.simulator.wait(10)
            if ended.code != 0 or tools.RAW.search(ended.out + ended.err):
                self.notes.append(f"ssl-sim ended with {ended.code} after TERM: {ended.last()}")
        if hasattr(self, "socket"):
            self.socket.close()
        super().clean()
