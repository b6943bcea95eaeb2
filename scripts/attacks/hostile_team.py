#!/usr/bin/python3
"""A team that attacks the host, the other team or the machine in one way: hostile_team.py MODE [TOKEN [FOLDER]].

It speaks the protocol with bytes made by hand and plays, badly, until its moment comes. TOKEN is in the
environment of all that the attack has started: it harms nothing else. FOLDER is the result folder, in hexadecimal digits.
"""
import os
import resource
import socket
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from attacks.hostile_assaults import Assaults  # noqa: E402
from attacks.hostile_faults import Faults, drive  # noqa: E402
from attacks.hostile_kernel import Kernel  # noqa: E402
from attacks.wire import delimited, frame, kind_of, number, text_of, tick_of  # noqa: E402

AT = 40  # the tick of the attack: the game is on
BROKE = 97  # the code with which it ends when the attack itself was wrong


class Team(Faults, Assaults, Kernel):
    def __init__(self, mode, token, folder):
        self.mode, self.token, self.folder = mode, token, folder
        self.socket = None
        self.logs = None  # the folder where it may write
        self.still = False
        self.buffer = b""

    # --- the protocol

    def connect(self, path=None):
        channel = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        channel.connect(path or os.environ["MATCHDAY_SOCKET"])
        return channel

    def receive(self):
        """The next message of the host; nothing when it is gone."""
        while True:
            size = shift = 0
            for at, byte in enumerate(self.buffer):
                size |= (byte & 0x7F) << shift
                shift += 7
                if byte < 0x80:
                    if len(self.buffer) > at + size:
                        message, self.buffer = self.buffer[at + 1:at + 1 + size], self.buffer[at + 1 + size:]
                        return message
                    break
            data = self.socket.recv(1 << 17)
            if not data:
                return None
            self.buffer += data

    def send(self, data):
        self.socket.sendall(data)

    def hello(self, name="hostile", version=1, keeper=0, more=b""):
        named = name if isinstance(name, bytes) else name.encode()
        return frame(delimited(1, number(1, version) + delimited(2, named) + number(4, keeper) + more))

    def reply(self, tick, control=None, more=b""):
        return frame(delimited(2, number(1, tick) + (b"" if self.still else drive(tick) if control is None else control) + more))

    def play(self):
        early = getattr(self, "start_" + self.mode, None)
        if early:
            early()
        self.socket = self.connect()
        connected = getattr(self, "connected_" + self.mode, None)
        if connected:
            connected()
        while True:
            message = self.receive()
            if message is None:
                return 1
            kind = kind_of(message)
            if kind == "hello":
                self.logs = text_of(message, 1, 5).decode()
                action = getattr(self, "hello_" + self.mode, None)
                self.send(action() or self.hello() if action else self.hello())
            elif kind == "tick":
                tick = tick_of(message)
                action = getattr(self, "tick_" + self.mode, None)
                once = getattr(self, "once_" + self.mode, None)
                data = action(tick) if action and tick >= AT else once(tick) if once and tick == AT else None
                self.send(data or self.reply(tick))
            else:
                action = getattr(self, "end_" + self.mode, None)
                if action:
                    action()
                return 0


def modes():
    stages = ("start_", "connected_", "hello_", "tick_", "once_", "end_")
    found = [name.split("_", 1)[1] for name in dir(Team) if name.startswith(stages)]
    return sorted(set(found))


if __name__ == "__main__":
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    words = sys.argv[1:] + [""] * 3
    if words[0] not in modes():
        sys.exit(f"hostile_team.py: unknown mode; known are: {', '.join(modes())}")
    try:
        sys.exit(Team(words[0], words[1], Path(bytes.fromhex(words[2]).decode() or "/nonexistent")).play())
    except (BrokenPipeError, ConnectionError):
        sys.exit(1)
    except Exception as error:
        print(f"hostile_team.py broke: {error!r}", file=sys.stderr, flush=True)
        os._exit(BROKE)
