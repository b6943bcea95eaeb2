"""Damaged league logs, recordings and judged games into everything that reads them."""
import gzip
import shutil
import struct

from . import arena as tools
from . import damage
from . import night as nights
from .row import Row

MEMORY = 384 << 20  # [byte] ours: twice what the largest of these sound files takes with all its shadows (judge)
KINDS = ("log", "replies", "judged", "log", "judged", "packed", "replies", "calibrate", "judged", "amplifier", "odd")
MESSAGE = struct.Struct(">qii")  # receive time [ns], type, size: SSL logs, after a header of 16 bytes
PROMPT = 10  # [s] ours: to refuse takes 0.1 s
KEPT = 3000  # messages of the log: some 10 s of a game, so that a try takes 0.1 s


class Logs(Row):
    name = "logs"
    what = "damaged logs and recordings into ssl-autoref replay and calibrate, matchday continue, judge --again; amplifiers; pipes and devices"
    checks = "an exit code and one sentence of its own, within a minute and 384 MiB; damaged files are bad input (2)"
    tries = 1100
    least = 20
    seconds = 250

    def prepare(self):
        place = self.arena.place("games")
        file = place / "design.toml"
        file.write_text(nights.design(seed=self.seed % 1000 + 6, pairs=1))
        self.design = file
        played = self.arena.run(self.arena.matchday, "play", "--blue", "team-reference", "--yellow", "team-chaser", "--half-length", "1",
                                "--log", place / "game.log", "--record", place / "game.replies", addresses=0)
        judged = self.arena.run(self.arena.matchday, "judge", file, "--games", "1", "--keep", place / "kept", "--out", place / "judge",
                                addresses=0)
        for ended in (played, judged):
            if ended.code != 0:
                raise RuntimeError(f"{ended.command[1]} ended with {ended.code}: {ended.last()}")
        self.log = shortened((place / "game.log").read_bytes(), KEPT)
        self.replies = (place / "game.replies").read_bytes()
        self.judged_name = next((place / "kept").glob("*.judged")).name
        self.judged = (place / "kept" / self.judged_name).read_bytes()
        self.most = 0

    def attempt(self, number, dice):
        kind = KINDS[number % len(KINDS)]
        place = self.arena.place("try")
        what, ended = getattr(self, "try_" + kind)(place, dice)
        self.most = max(self.most, ended.memory)
        self.notes = [f"at most {self.most >> 20} MiB"]
        wrong = tools.answer(ended, memory=MEMORY)
        if kind == "odd" and not wrong and ended.code != 2:
            wrong.append(f"{ended.command[1]} of what is no file ends with code {ended.code} instead of 2")
        if ended.code == 5 and kind != "judged":
            wrong.append("a damaged file is bad input (2), not a result folder (5)")
        shutil.rmtree(place, ignore_errors=True)
        return [f"{kind} ({what}): {sentence}" for sentence in wrong]

    def read(self, verb, file, *flags):
        return self.arena.run(self.arena.autoref, verb, file, *flags, limit=60)

    def log_bytes(self, dice):
        """Damage anywhere, or in the frame of a message: its time, type and size."""
        if dice.random() < 0.6:
            return damage.bytes_of(self.log, dice)
        data = bytearray(self.log)
        at, hops = 16, dice.randrange(KEPT)
        while hops and at + 16 <= len(data):
            size = MESSAGE.unpack_from(data, at)[2]
            following = at + MESSAGE.size + size
            if following + MESSAGE.size > len(data):
                break
            at, hops = following, hops - 1
        moment, kind, size = MESSAGE.unpack_from(data, at)
        field = dice.choice(("time", "type", "size"))
        odd = dice.choice((-1, 0, 1, 2**31 - 1, -(2**31), 65_508, 1 << 24))
        new = {"time": (dice.choice((0, -1, 2**63 - 1, -(2**63), moment - 10**15)), kind, size), "type": (moment, odd, size),
               "size": (moment, kind, odd)}[field]
        MESSAGE.pack_into(data, at, *new)
        return bytes(data), field

    def written(self, place, name, data):
        (place / name).write_bytes(data)
        return place / name

    def try_log(self, place, dice):
        data, what = self.log_bytes(dice)
        return what, self.read("replay", self.written(place, "game.log", data), *(["--json"] if dice.random() < 0.3 else []))

    def try_packed(self, place, dice):
        """Damage outside and inside the packing."""
        if dice.random() < 0.5:
            data, what = damage.bytes_of(gzip.compress(self.log, 1), dice)
        else:
            data, what = self.log_bytes(dice)
            data = gzip.compress(data, 1)
        return what, self.read(dice.choice(("replay", "calibrate")), self.written(place, "game.log.gz", data))

    def try_calibrate(self, place, dice):
        data, what = self.log_bytes(dice)
        return what, self.read("calibrate", self.written(place, "game.log", data))

    def try_replies(self, place, dice):
        packed = dice.random() < 0.3
        data, what = damage.bytes_of(self.replies, dice)
        file = self.written(place, "game.replies.gz" if packed else "game.replies", gzip.compress(data, 1) if packed else data)
        more = ["--from", "5"] if dice.random() < 0.3 else []
        return what, self.arena.run(self.arena.matchday, "continue", file, *more, limit=60, addresses=0)

    def again(self, place, data):
        (place / "kept").mkdir()
        self.written(place / "kept", self.judged_name, data)
        return self.arena.run(self.arena.matchday, "judge", self.design, "--games", "1", "--again", place / "kept", "--out", place / "out",
                              "--workers", "1", limit=60, addresses=0)

    def try_judged(self, place, dice):
        data, what = damage.bytes_of(self.judged, dice)
        return what, self.again(place, data)

    def try_odd(self, place, dice):
        """A pipe, a device, a folder in place of a file: refused at once."""
        kind, packed = dice.choice(("pipe", *damage.ODD)), dice.choice(("", ".gz"))
        log, replies = place / ("game.log" + packed), place / ("game.replies" + packed)
        matchday, autoref = self.arena.matchday, self.arena.autoref
        words = dice.choice(([autoref, "replay", log], [autoref, "calibrate", log], [matchday, "continue", replies],
                             [matchday, "continue", replies, "--from", "1"], [matchday, "judge", self.design, "--again", place / "kept",
                                                                              "--games", "1", "--out", place / "out"]))
        (place / "kept").mkdir()
        for file in (log, replies, place / "kept" / self.judged_name):
            damage.odd_file(file, kind)
        return f"a {kind}, {words[1]}", self.arena.run(*words, limit=PROMPT, addresses=0)

    def try_amplifier(self, place, dice):
        """Few bytes that ask for many."""
        header = self.log[:16]
        large = dice.choice((64, 256, 1000)) << 20
        bomb = dice.choice(("zeros", "messages", "size", "replies-zeros", "replies-length", "judged-length"))
        if bomb == "zeros":
            return bomb, self.read(dice.choice(("replay", "calibrate")), self.packed(place, "bomb.log.gz", header, bytes(1 << 20), large >> 20))
        if bomb == "messages":  # legal frames of nothing but zeros, a megabyte each
            message = MESSAGE.pack(1_700_000_000 * 10**9, 4, 1 << 20) + bytes(1 << 20)
            return bomb, self.read("replay", self.packed(place, "bomb.log.gz", header, message, large >> 20))
        if bomb == "size":
            data = header + MESSAGE.pack(1, dice.choice((2, 3, 4)), 2**31 - 1) + bytes(100)
            return bomb, self.read("replay", self.written(place, "bomb.log", data))
        if bomb == "replies-zeros":
            file = self.packed(place, "bomb.replies.gz", self.replies[:4000], bytes(1 << 20), large >> 20)
            return bomb, self.arena.run(self.arena.matchday, "continue", file, limit=60, addresses=0)
        if bomb == "replies-length":
            data = self.replies[:dice.randrange(4, 2000)] + b"\xff\xff\xff\xff\x07" + bytes(100)
            return bomb, self.arena.run(self.arena.matchday, "continue", self.written(place, "bomb.replies", data), limit=60, addresses=0)
        at = dice.randrange(0, 3000)
        return bomb, self.again(place, self.judged[:at] + b"\xff" * 7 + b"\x7f" + self.judged[at + 8:])

    def packed(self, place, name, begin, piece, times):
        with gzip.open(place / name, "wb", compresslevel=9) as stream:
            stream.write(begin)
            for _ in range(times):
                stream.write(piece)
        return place / name


def shortened(log, messages):
    """The beginning of a log, with the last message whole."""
    at = 16
    while messages and at + MESSAGE.size <= len(log):
        at += MESSAGE.size + MESSAGE.unpack_from(log, at)[2]
        messages -= 1
    return log[:at]
