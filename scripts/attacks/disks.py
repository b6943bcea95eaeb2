"""Disks that are full, shrink, cannot be written, or lose the result folder; outputs that cannot be written."""
import os
import re
import shutil
import subprocess
import time

from . import arena as tools
from . import night as nights
from .row import NotPossible, Row
from .stops import SECOND, small_disk

WAITS = re.compile(r"waiting until|no game is started")  # what a run says that has no room
PATIENCE = 60  # [s] ours: the whole run takes 2
CASES = ("full", "shrinking", "read_only", "removed", "moved", "replaced", "file_instead", "verbs", "full_at_start")


class Disks(Row):
    name = "disks"
    what = "full, shrinking, read-only disks; result folder removed or replaced meanwhile; every verb to /dev/full"
    checks = ("without room a run says so, waits and goes on by itself, or TERM ends it; else code 5 and one sentence; then the games of "
              "an undisturbed night; code 74 for output that is lost")
    tries = 36
    least = 9
    seconds = 260

    def prepare(self):
        self.text = nights.design(seed=self.seed % 1000 + 4, pairs=8, limits={"free_disk": 0, "sampled": 0.5})
        night = nights.Night(self.arena, "undisturbed", self.text)
        ended = night.run()
        if ended.code != 0:
            raise RuntimeError(f"an undisturbed run ended with {ended.code}: {ended.last()}")
        self.expected, self.table, self.length = night.games(), night.table().out, ended.seconds
        self.undisturbed = night
        self.runs = self.met = 0

    def attempt(self, number, dice):
        case = CASES[number % len(CASES)]
        if case in ("full", "shrinking", "read_only", "full_at_start"):
            if not self.arena.alone:
                raise NotPossible("needs a mount namespace of its own")
            place = self.arena.place("disk")
            with small_disk(self.arena, place, 24):
                wrong = getattr(self, case)(number, dice, place)
        else:
            wrong = getattr(self, case)(number, dice)
        return [f"{case}: {sentence}" for sentence in wrong] + self.arena.left_over() + self.arena.temporary()

    def without_room(self, night, runner, dice, make_room):
        """The run says that it waits. Then there is room, and it goes on by itself; or TERM ends it."""
        self.runs += 1
        while runner.running() and runner.seconds() < PATIENCE and not WAITS.search(runner.said()):
            time.sleep(0.05)
        waits = runner.running() and WAITS.search(runner.said())
        ends = waits and dice.random() < 0.3
        if waits:
            self.met += 1
            time.sleep(dice.uniform(0.1, 1.5))
            runner.send(15) if ends else make_room()
        ended = runner.wait(PATIENCE)
        self.notes = [f"of {self.runs} runs on such disks {self.met} had to wait for room"]
        wrong = tools.answer(ended, codes=(143,) if ends else (0,) if waits else (0, 5))
        if ends and not wrong and ended.after > SECOND:
            wrong.append(f"TERM while it waits for room ends it after {ended.after:.0f} s")
        make_room()
        if not wrong and ended.code != 0 and (night.folder / "ledger.sqlite").exists():
            wrong += tools.answer(night.table("text"), codes=(0, 5))
        return wrong or self.whole(night, ended)

    def whole(self, night, ended=None):
        ended, wrong = night.continued(ended or night.run(), times=2)
        wrong = wrong or nights.same_games(night.games(), self.expected)
        void = any(row["outcome"] == "void" for row in nights.rows(night.folder))  # those stand in the table
        return wrong or ([] if void or night.table().out == self.table else ["the table differs after continuing"])

    def full(self, number, dice, place):
        night = nights.Night(self.arena, f"disk/full-{number}", self.text)
        runner = night.start()
        time.sleep(dice.uniform(0.05, 0.6 * self.length))
        fill(place, leave=dice.choice((0, 4096, 65536)))
        return self.without_room(night, runner, dice, lambda: (place / "filler").unlink(missing_ok=True))

    def full_at_start(self, number, dice, place):
        fill(place, leave=dice.choice((0, 4096, 20000)))
        night = nights.Night(self.arena, f"disk/start-{number}", self.text)
        before = self.met
        wrong = self.without_room(night, night.start(), dice, lambda: (place / "filler").unlink(missing_ok=True))
        if self.met == before and not wrong:
            wrong.append("no ledger has room here, but the run did not wait for it")
        return wrong

    def shrinking(self, number, dice, place):
        night = nights.Night(self.arena, f"disk/shrink-{number}", self.text)
        runner = night.start()
        for _ in range(8):
            time.sleep(dice.uniform(0.02, 0.1) * self.length)
            used = shutil.disk_usage(place).used
            self.arena.run("mount", "-o", f"remount,size={used + dice.choice((4096, 65536, 500000))}", place)
        return self.without_room(night, runner, dice, lambda: self.arena.run("mount", "-o", "remount,size=24m", place))

    def read_only(self, number, dice, place):
        night = nights.Night(self.arena, f"disk/read-{number}", self.text)
        runner = night.start()
        time.sleep(dice.uniform(0.3, 0.7) * self.length)
        runner.send(15)
        runner.wait(60)
        self.arena.run("mount", "-o", "remount,ro", place)
        wrong = tools.answer(night.run(60), codes=(0, 5))
        for form in ("text", "json"):
            wrong += tools.answer(night.table(form), codes=(0,))
        self.arena.run("mount", "-o", "remount,rw", place)
        return wrong or self.whole(night)

    def meanwhile(self, number, dice, action):
        night = nights.Night(self.arena, f"meanwhile-{number}", self.text)
        runner = night.start()
        night.wait_for(runner, state="running")
        time.sleep(dice.uniform(0.1, 0.6) * self.length)
        action(night.folder)
        ended = runner.wait(60)
        return night, ended

    def gone(self, number, dice, action):
        """The folder is no longer what it was: the run says so, and does not say that it is done without its games."""
        night, ended = self.meanwhile(number, dice, action)
        wrong = tools.answer(ended, codes=(0, 4, 5))
        if ended.code == 0 and not wrong:
            try:
                wrong = nights.same_games(night.games(), self.expected)
            except Exception as error:
                wrong = [f"ended with 0, but there is no ledger: {error}"]
        if night.folder.is_file():
            night.folder.unlink()
        return wrong

    def removed(self, number, dice):
        return self.gone(number, dice, lambda folder: shutil.rmtree(folder, ignore_errors=True))

    def moved(self, number, dice):
        moved = self.arena.folder / f"moved-{number}"
        wrong = self.gone(number, dice, lambda folder: folder.rename(moved))
        if wrong:
            return wrong
        moved_night = nights.Night(self.arena, f"moved-{number}", self.text)
        return self.whole(moved_night)

    def replaced(self, number, dice):
        def action(folder):
            folder.rename(self.arena.folder / f"replaced-{number}")
            folder.mkdir()
        return self.gone(number, dice, action)

    def file_instead(self, number, dice):
        def action(folder):
            folder.rename(self.arena.folder / f"file-{number}")
            folder.write_text("nothing\n")
        return self.gone(number, dice, action)

    def verbs(self, number, dice):
        """Whoever prints to a full disk says so by its exit code."""
        night, matchday = self.undisturbed, self.arena.matchday
        recording, log = self.arena.folder / "verbs.replies", self.arena.folder / "verbs.log.gz"
        teams = ["--blue", "team-reference", "--yellow", "team-chaser", "--half-length", "1"]
        self.arena.run(matchday, "play", *teams, "--record", recording, "--log", log, addresses=0)
        judged = self.arena.place(f"judged-{number}")
        commands = [["play", *teams], ["play", *teams, "--json"], ["run", *night.command[2:]], ["plan", night.file],
                    ["replay", night.folder, "base-0000-0"], ["continue", recording], ["realism"], ["--help"], ["run", "--help"],
                    ["--version"], ["judge", night.file, "--games", "1", "--out", judged / "out"],
                    ["bench", "--half-length", "1", "--workers", "0"]]
        commands += [["report", night.folder, "--format", form] for form in ("text", "markdown", "csv", "json", "latex")]
        commands = [[matchday, *words] for words in commands]
        commands += [[self.arena.autoref, *words] for words in (["replay", log], ["replay", log, "--json"], ["calibrate", log],
                                                               ["automaton"], ["positions"], ["--help"])]
        wrong = []
        for words in commands:
            with open("/dev/full", "wb") as full:
                code = subprocess.run([str(word) for word in words], stdin=subprocess.DEVNULL, stdout=full, timeout=90,
                                      stderr=subprocess.PIPE, env={**os.environ, tools.MARK: self.arena.token}).returncode
            if code != 74:  # sysexits.h, EX_IOERR, as matchday --help says
                wrong.append(f"{words[0].name} {words[1]} ends with {code}")
        return [f"> /dev/full, of {len(commands)} commands {len(wrong)} do not end with 74: {', '.join(wrong)}"] if wrong else []


def fill(place, leave):
    """Fills a disk to the last byte but `leave`, whatever is written there or removed meanwhile."""
    with open(place / "filler", "wb") as stream:
        for _ in range(100):
            free = shutil.disk_usage(place).free - leave
            if free <= 0:
                return
            try:
                os.posix_fallocate(stream.fileno(), 0, os.fstat(stream.fileno()).st_size + free)
            except OSError:
                pass  # it was filled meanwhile
