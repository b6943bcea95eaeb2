"""kill -9 at random moments; the same command continues, and the night is what it would have been."""
import os
import signal
import time

from . import arena as tools
from . import night as nights
from .row import Row

VICTIMS = ("runner", "worker", "team", "group", "all")


class Kills(Row):
    name = "kills"
    what = "kill -9 of runner, worker, one team, the process group or all, at random moments"
    checks = ("the same command continues to the games, hashes and table of an undisturbed night; at most the game that was hit is "
              "lost or played again; nothing is left behind")
    tries = 100
    least = 5
    seconds = 700

    def text(self, preflight):
        # A third of the games is played twice and a third kept: a kill meets audits and packing, too.
        return nights.design(seed=self.seed % 1000 + 1, pairs=3, limits={"sampled": 0.3, "audited": 0.3})

    def prepare(self):
        night = nights.Night(self.arena, "undisturbed", self.text(True), preflight=True)
        ended = night.run()
        if ended.code != 0:
            raise RuntimeError(f"an undisturbed run ended with {ended.code}: {ended.last()}")
        self.expected, self.table = night.games(), night.table().out
        self.length = ended.seconds
        self.usual = {path.name for path in night.folder.iterdir()}

    def victim(self, night, runner, kind):
        """Kills it; its number and which team it was, or nothing when the run had ended before."""
        until = time.monotonic() + 3
        while runner.running() and time.monotonic() < until:
            if kind == "runner":
                return runner.send(signal.SIGKILL)
            if kind == "group":
                os.killpg(runner.pid, signal.SIGKILL)
                return True
            family = night.family()
            if kind == "all":
                for pid in [*family, runner.pid]:
                    tools.kill(pid, signal.SIGKILL)
                return True
            those = [pid for pid, what in family.items() if what == kind]
            if those:
                pid = self.pick.choice(sorted(those))
                self.program = night.program(pid)
                return tools.kill(pid, signal.SIGKILL)
            time.sleep(0.002)
        return False

    def attempt(self, number, dice):
        kind = VICTIMS[number % len(VICTIMS)]
        preflight = dice.random() < 0.3
        self.pick, self.program = dice, ""
        night = nights.Night(self.arena, f"kill-{number}", self.text(preflight), preflight=preflight)
        for again in range(20):  # until one was hit
            runner = night.start()
            time.sleep(dice.uniform(0, self.length if preflight else 0.6 * self.length))
            hit = self.victim(night, runner, kind)
            ended = runner.wait(90)
            if hit:
                break
            night = nights.Night(self.arena, f"kill-{number}-{again}", self.text(preflight), preflight=preflight)
        else:
            return [f"in {again + 1} runs there was no {kind} to be killed"]
        wrong = []
        if kind in ("worker", "team"):  # the runner lives: it goes on by itself
            wrong += tools.answer(ended, codes=(0, 3, 4), sentence=False)
        elif ended.code != -signal.SIGKILL:
            wrong.append(f"the killed runner ended with {ended.code}")
        wrong += self.arena.left_over()
        ended, more = night.continued(ended)
        wrong += more
        if more:
            return wrong
        wrong += self.compare(night, kind)
        wrong += self.arena.left_over() + nights.tidy(night, self.usual)
        night.run()  # another start: whatever a killed run left is gone by now
        return wrong + self.arena.temporary()

    def compare(self, night, kind):
        attempts = nights.rows(night.folder)
        games = nights.counted(attempts)
        expected = dict(self.expected)
        if kind == "team":  # it lost that game, and no other
            # What is the fault of nobody or of the harness is void: looked at below.
            forfeits = [row for row in attempts if row["outcome"] != "void" and row["at_fault"] != "nobody"]
            if len(forfeits) > 1:
                return [f"{len(forfeits)} games ended by a fault after one kill"]
            for row in forfeits:
                key = row["condition"], row["pair"], row["leg"]
                if row["at_fault"] not in ("yellow", "blue"):
                    return [f"a killed team is the fault of {row['at_fault']}: {row['reason'][:120]}"]
                blamed = nights.PROGRAMS[0 if row["at_fault"] == row["a_colour"] else 1]
                if self.program and blamed != self.program:
                    return [f"{self.program} was killed, but {blamed} is blamed: {row['reason'][:120]}"]
                if key in games:
                    expected.pop(key)
                    games.pop(key)
        wrong = nights.same_games(games, expected)
        voids = [row for row in attempts if row["outcome"] == "void"]
        # Whose cell is killed before the program is in it cannot be told from one that cannot be made.
        excused = 1 if kind == "worker" or kind == "team" and voids and "could not be isolated" in voids[0]["reason"] else 0
        if len(voids) > excused:
            wrong.append(f"{len(voids)} void games after one kill: {voids[0]['reason'][:120]}")
        if kind in ("runner", "group", "all") and night.table().out != self.table:
            wrong.append("the table differs from that of an undisturbed run")
        return wrong
