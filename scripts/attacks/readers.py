"""Other programs that hold the ledger open while a run writes it."""
import shutil
import sqlite3
import time

from . import arena as tools
from . import night as nights
from .row import Row

CASES = ("select-long", "copy", "immediate", "report", "immediate-long", "backup", "exclusive", "select")


class Readers(Row):
    name = "readers"
    what = "an open SELECT, a BEGIN IMMEDIATE, a copy, a backup, reports, while a run writes"
    checks = "the run ends with 0 and all its games as undisturbed; copies and backups are sound"
    tries = 24
    least = 3
    seconds = 160

    def prepare(self):
        self.text = nights.design(seed=self.seed % 1000 + 3, pairs=6)
        night = nights.Night(self.arena, "undisturbed", self.text)
        night.run()
        self.expected = night.games()

    def attempt(self, number, dice):
        case = CASES[number % len(CASES)]
        night = nights.Night(self.arena, f"read-{number}", self.text)
        runner = night.start()
        until = time.monotonic() + 20
        while runner.running() and time.monotonic() < until and not self.begun(night):
            time.sleep(0.01)
        try:
            wrong = getattr(self, case.split("-")[0])(night, runner, 13 if case.endswith("long") else dice.uniform(0.5, 3))
        except sqlite3.OperationalError as error:  # our reader may be told to wait
            wrong = [] if "locked" in str(error) else [f"{case}: the reader was told: {error}"]
        ended = runner.wait(120)
        wrong += [f"{case}: {sentence}" for sentence in tools.answer(ended, codes=(0,))]
        if ended.code == 0:
            wrong += nights.same_games(night.games(), self.expected)
        return wrong + self.arena.left_over()

    def begun(self, night):
        try:
            return len(nights.rows(night.folder)) > 0
        except sqlite3.Error:
            return False

    def open(self, night):
        # Not read-only: BEGIN IMMEDIATE is what an editor of databases does.
        return sqlite3.connect(night.folder / "ledger.sqlite", isolation_level=None, timeout=5)

    def hold(self, night, runner, seconds, begin):
        """A transaction that is open for `seconds`, longer than the run waits for a lock (10 s) where it is 13."""
        database = self.open(night)
        try:
            for statement in begin:
                database.execute(statement).fetchone()
            until = time.monotonic() + seconds
            while time.monotonic() < until and runner.running():
                time.sleep(0.05)
        finally:
            database.close()
        return []

    def select(self, night, runner, seconds):
        return self.hold(night, runner, seconds, ["BEGIN", "SELECT * FROM attempts"])

    def immediate(self, night, runner, seconds):
        return self.hold(night, runner, seconds, ["BEGIN IMMEDIATE"])

    def exclusive(self, night, runner, seconds):
        return self.hold(night, runner, seconds, ["BEGIN EXCLUSIVE"])

    def copy(self, night, runner, _seconds):
        """A plain copy may be torn, but must not disturb."""
        while runner.running():
            shutil.rmtree(self.arena.folder / "copy", ignore_errors=True)
            try:
                shutil.copytree(night.folder, self.arena.folder / "copy")
            except (shutil.Error, OSError):
                pass  # files come and go
            time.sleep(0.01)
        return []

    def backup(self, night, runner, _seconds):
        while runner.running():
            source, target = self.open(night), sqlite3.connect(":memory:")
            try:
                source.backup(target, pages=8)
                if target.execute("PRAGMA integrity_check").fetchone()[0] != "ok":
                    return ["a backup made during the run is damaged"]
            finally:
                source.close()
                target.close()
        return []

    def report(self, night, runner, _seconds):
        wrong = []
        while runner.running() and not wrong:
            wrong = tools.answer(night.table("text"), codes=(0,))
        return wrong
