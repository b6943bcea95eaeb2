"""Processes that stand still, and signals once and twice, at every stage."""
import contextlib
import os
import signal
import time

from . import arena as tools
from . import night as nights
from .row import NotPossible, Row

SIGNALS = (signal.SIGTERM, signal.SIGINT, signal.SIGHUP)
PLAIN = ("play", "judge", "bench", "replay", "plan")
SECOND = 10  # [s] ours: running games are ended within the 2 s of their grace each, and a busy machine


class Stops(Row):
    name = "stops"
    what = "STOP and CONT of host, teams, runner; TERM, INT, HUP once and twice, in the preflight, waiting for disk"
    checks = ("a pause changes no game; a signal ends the run in time with its code and the command that continues; then the games "
              "are those of an undisturbed night")
    tries = 100
    least = 6
    seconds = 600

    def prepare(self):
        self.text = nights.design(seed=self.seed % 1000 + 2, pairs=4)
        night = nights.Night(self.arena, "undisturbed", self.text)
        ended = night.run()
        if ended.code != 0:
            raise RuntimeError(f"an undisturbed run ended with {ended.code}: {ended.last()}")
        self.expected, self.length = night.games(), ended.seconds
        self.undisturbed = night

    def attempt(self, number, dice):
        kind = ("pause", "once", "disk", "twice", "preflight", "plain")[number % 6]
        return getattr(self, kind)(number, dice) + self.arena.left_over() + self.arena.temporary()

    def finish(self, night, ended):
        ended, wrong = night.continued(ended)
        return wrong or nights.same_games(night.games(), self.expected)

    def pause(self, number, dice):
        """Less than a team may take (5 s): the game is what it would have been."""
        night = nights.Night(self.arena, f"pause-{number}", self.text)
        runner = night.start()
        time.sleep(dice.uniform(0.1, 0.6 * self.length))
        what = dice.choice(("worker", "team", "runner", "everything"))
        family = night.family()
        those = [runner.pid] if what == "runner" else [*family, runner.pid] if what == "everything" else \
            [pid for pid, role in family.items() if role == what]
        stopped = [pid for pid in those if tools.kill(pid, signal.SIGSTOP)]
        time.sleep(dice.uniform(0.3, 2.5))
        for pid in reversed(stopped):
            tools.kill(pid, signal.SIGCONT)
        ended = runner.wait(90)
        wrong = tools.answer(ended, codes=(0,))
        return wrong or nights.same_games(night.games(), self.expected)

    def interrupted(self, ended, number, what):
        """Codes of a signal; 0 when the run had ended before it came."""
        if ended.late:
            return [f"{what}: it did not end"]
        if ended.code not in (0, 128 + number):
            return [f"{what}: {signal.Signals(number).name} ends it with {ended.code}: {ended.last()}"]
        return []

    def once(self, number, dice, preflight=False):
        night = nights.Night(self.arena, f"once-{number}", self.text, preflight=preflight)
        runner, which = night.start(), dice.choice(SIGNALS)
        if preflight:
            night.wait_for(runner, words="first a short game")
            time.sleep(dice.uniform(0, 0.3))
        else:
            time.sleep(dice.uniform(0.05, 0.8 * self.length))
        runner.send(which)
        ended = runner.wait(60)
        # Before its handlers are in place a signal ends it as it ends every program.
        early = ended.code == -which and not night.status()
        wrong = [] if early else self.interrupted(ended, which, "once" + ("in the preflight" if preflight else ""))
        if ended.code == 128 + which and "continue with: " not in ended.words:
            wrong.append("an interrupted run does not print the command that continues")
        return wrong + self.finish(night, ended)

    def preflight(self, number, dice):
        return self.once(number, dice, preflight=True)

    def twice(self, number, dice):
        night = nights.Night(self.arena, f"twice-{number}", self.text)
        runner, which = night.start(), dice.choice(SIGNALS)
        night.wait_for(runner, state="running")
        time.sleep(dice.uniform(0, 0.5 * self.length))
        runner.send(which)
        time.sleep(dice.uniform(0.001, 0.2))
        runner.send(dice.choice(SIGNALS))
        ended = runner.wait(SECOND)
        wrong = [] if ended.code in [0] + [128 + one for one in SIGNALS] and not ended.late else \
            [f"two signals: it ended with {ended.code} after {ended.seconds:.0f} s: {ended.last()}"]
        return wrong + self.finish(night, ended)

    def disk(self, number, dice):
        """A signal while the run waits for room on the disk ends it at once."""
        if not self.arena.alone:
            raise NotPossible("needs a mount namespace of its own")
        place = self.arena.place("small")
        with small_disk(self.arena, place, 64):
            text = self.text.replace("free_disk = 1\n", "free_disk = 40\n").replace("pairs = 4", "pairs = 60")
            night = nights.Night(self.arena, f"small/disk-{number}", text)
            runner, which = night.start(), dice.choice(SIGNALS)
            night.wait_for(runner, state="running")
            with open(place / "filler", "wb") as stream:
                os.posix_fallocate(stream.fileno(), 0, 40 << 20)
            waiting = night.wait_for(runner, state="waiting-for-disk")
            time.sleep(dice.uniform(0.2, 1))
            runner.send(which)
            ended = runner.wait(SECOND)
            if not waiting:
                return [f"it did not wait for disk: {ended.last()}"]
            wrong = self.interrupted(ended, which, "waiting for disk")
            if ended.code == 0:
                wrong.append("waiting for disk: code 0 with games missing")
            return wrong

    def plain(self, number, dice):
        """Commands without a run of games in them: a signal ends them with its code or as a signal does."""
        which, verb = dice.choice(SIGNALS), dice.choice(PLAIN)
        place = self.arena.place(f"plain-{number}")
        teams = ["--blue", "team-reference", "--yellow", "team-reference"]
        words = {"play": ["play", *teams], "bench": ["bench", "--workers", "0"],
                 "judge": ["judge", self.undisturbed.file, "--out", place / "judge"],
                 "replay": ["replay", self.undisturbed.folder, "base-0000-0"],
                 "plan": ["plan", self.undisturbed.file]}[verb]
        child = self.arena.start(self.arena.matchday, *words, addresses=0)
        time.sleep(dice.uniform(0.01, 0.5))
        child.send(which)
        ended = child.wait(30)
        if ended.late or ended.code not in (0, 128 + which, -which):
            return [f"{verb}: {which.name} ends it with {ended.code}: {ended.last()}"]
        return []


@contextlib.contextmanager
def small_disk(arena, place, size):
    """A tmpfs of `size` MiB at `place`."""
    mounted = arena.run("mount", "-t", "tmpfs", "-o", f"size={size}m", "attack", place)
    if mounted.code != 0:
        raise NotPossible(f"no tmpfs can be mounted: {mounted.last()}")
    try:
        yield
    finally:
        arena.end(arena.processes("MATCHDAY_GAME="))
        for _ in range(20):
            if arena.run("umount", place).code == 0:
                break
            time.sleep(0.1)
        else:
            arena.run("umount", "-l", place)
