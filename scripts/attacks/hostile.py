"""Teams that attack: the night goes on, the right one is blamed, and the other games are what they would have been."""
import json
import re
import sqlite3
import sys
import time
from pathlib import Path

from . import arena as tools
from . import hostile_cases, hostile_team
from . import night as nights
from .row import Row

PROGRAM = Path(__file__).resolve().parent / "hostile_team.py"
LARGEST = 192 << 20  # [byte] of the result folder at any time, ours: two games' logs (4 MiB a program), replies and 60 MiB of
                     # a team's own files each

HALF = 15.0  # [s] as in the preflight of a run: both teams take a kickoff

MEMORY = 256  # [MiB] of a team: a Python program takes 10
SECOND = 1.3  # [s] of own time per simulated second: above the 1 s of `pauses`, below the 2.94 s of `slow_ticks`

class Hostile(Row):
    name = "hostile"
    what = "teams that attack host, other team, runner or machine, one way each, beside an ordinary game"
    checks = ("each team's game ends in the one way that is right for it, the fault is its own, no game is void; the games beside it "
              "are as undisturbed; nothing is left behind")
    least = 6
    seconds = 640

    def __init__(self, arena, seed):
        super().__init__(arena, seed)
        self.cases = [(mode, [sys.executable, str(PROGRAM), mode]) for mode in hostile_team.modes()]
        self.cases += [("fake " + mode, ["fake-team", "--mode", mode, "--at", "40"]) for mode in hostile_cases.FAKES]
        self.outcomes = hostile_cases.outcomes()
        without = {mode for mode, _ in self.cases} ^ set(self.outcomes)
        if without:
            raise RuntimeError(f"hostile_cases.py and the teams differ in: {', '.join(sorted(without))}")

    def prepare(self):
        night = nights.Night(self.arena, "undisturbed", self.text(["team-chaser"]))
        ended = night.run()
        if ended.code != 0:
            raise RuntimeError(f"an undisturbed run ended with {ended.code}: {ended.last()}")
        self.expected = {key: row for key, row in night.games().items() if key[0] == "quiet"}
        self.isolation = json.loads((night.folder / "manifest.json").read_text())["isolation"]
        self.most = 0

    def text(self, hostile, patient=False):
        return nights.design(seed=self.seed % 1000 + 9, pairs=1, half_length=HALF, b={"command": ["team-reference"]},
                             limits={"team_memory": MEMORY, **({} if patient else {"team_second": SECOND})},
                             conditions=[{"name": "hostile", "a.command": hostile, "a.name": "hostile"},
                                         {"name": "quiet", "a.command": ["team-chaser"], "a.name": "quiet"}])

    def attempt(self, number, _dice):
        mode, command = self.chosen(self.cases, number)
        folder = self.arena.folder / f"hostile-{number}"
        if command[0] == sys.executable:
            command = [*command, self.arena.token, str(folder).encode().hex()]  # who is told a folder may see it
        night = nights.Night(self.arena, folder.name, self.text(command, mode in hostile_cases.PATIENT))
        runner = night.start()
        until, size = time.monotonic() + 150, 0
        while runner.running() and time.monotonic() < until:
            size = max(size, used(folder))
            time.sleep(0.1)
        ended = runner.wait(max(0, until - time.monotonic()) + 0.1)
        wrong = tools.answer(ended, codes=(0,), memory=8 << 30)
        try:
            wrong += self.judged(night, mode)
        except sqlite3.Error as error:
            wrong.append(f"the ledger: {error}")
        if size > LARGEST:
            wrong.append(f"the result folder held {size >> 20} MiB")
        for form in ("text", "csv"):
            if not wrong:
                wrong += tools.answer(night.table(form), codes=(0,))
        wrong += self.arena.left_over()
        if (folder / "owned").exists() or (self.arena.folder / "owned").exists():
            wrong.append("a name ran a command")
        self.arena.temporary() if wrong else wrong.extend(self.arena.temporary())
        self.most = max(self.most, size)
        self.notes = [f"{self.isolation}; result folders of at most {self.most >> 20} MiB"]
        return [f"{mode}: {sentence}" for sentence in wrong]

    def judged(self, night, mode):
        attempts = nights.rows(night.folder)
        games = nights.counted(attempts)
        wrong = nights.same_games({key: row for key, row in games.items() if key[0] == "quiet"}, self.expected)
        for row in attempts:
            if row["condition"] != "hostile":
                continue
            if row["outcome"] == "void":
                return wrong + [f"a void game, at fault {row['at_fault']}: {row['reason'][:140]}"]
            if row["at_fault"] not in ("nobody", row["a_colour"]):
                return wrong + [f"the fault of {row['at_fault']}, but A was {row['a_colour']}: {row['reason'][:140]}"]
            problem = self.ended_otherwise(row, mode)
            if problem:
                return wrong + [problem]
            if row["goals_yellow"] > 50 or row["goals_blue"] > 50:
                wrong.append("a row of the ledger was forged")
        if len([key for key in games if key[0] == "hostile"]) != 2:
            wrong.append("games are missing")
        return wrong

    def ended_otherwise(self, row, mode):
        """A sentence when the game did not end as it must."""
        said = f"{row['termination']}, the fault of {row['at_fault']}: {row['reason'][:140]}"
        if f"code {hostile_team.BROKE}" in row["reason"] or "hostile_team.py broke" in row["reason"]:
            return "the attack itself broke: " + row["reason"][:200]
        if row["at_fault"] != "nobody" and not row["reason"]:
            return "a forfeit without a reason"
        if mode in hostile_cases.OUT_OF_REACH and not re.match("isolation (files|network)", self.isolation):
            return ""
        wanted = self.outcomes[mode]
        if row["termination"] != wanted or (row["at_fault"] == "nobody") != (wanted == "finished"):
            return f"must end as {wanted}, but ended as {said}"
        return ""


def used(folder):
    """[byte] of all files; they come and go."""
    total = 0
    try:
        for path in folder.rglob("*"):
            try:
                total += path.lstat().st_blocks * 512
            except OSError:
                pass
    except OSError:
        pass
    return total


Hostile.tries = len(hostile_team.modes()) + len(hostile_cases.FAKES)
