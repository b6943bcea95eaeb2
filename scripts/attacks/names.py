"""Texts from outside that would be commands, markup or terminal sequences if anybody took them for such."""
import html.parser
import json
import os
import re
import shutil
import sqlite3
import sys
from contextlib import closing
from pathlib import Path

from . import arena as tools
from . import night as nights
from .hostile import PROGRAM
from .row import Row

FORMATS = ("text", "markdown", "csv", "json", "latex")
CASES = ("design", "ledger", "branch", "program", "flags", "design", "folder", "ledger", "temporary", "condition", "said", "branch")
MARKS = ("owned", "owned2")
EVIL = ("`touch owned`", "$(touch owned)", "${IFS}`touch${IFS}owned`", "\";touch owned;\"", "';touch owned;'", "|touch owned", "&& touch owned",
        "\\\"`touch owned`", "@{[system('touch owned')]}", "$(system \"touch owned\")", "\\input{/etc/passwd}", "\\write18{touch owned}", "x\n\\input{/etc/passwd}",
        "<script>alert(1)</script>", "\"><img src=x onerror=alert(1)>", "\" onmouseover=\"alert(1)", "\x1b]0;owned\x07", "\x1b[2J", "\x9b2J", "a\nb", "a\rb", "a\tb", "\x7f",
        "-", "--help", "..", "../../owned", "/", "%s%n%n%n", "\u202eevil", "n" * 5000, "{0}", "=cmd|' /C calc'!A0", "\ufeff", "'", "\\", "{/Symbol a}",
        "^x_y", "a\u0000b")


class Markup(html.parser.HTMLParser):
    """Whether a page has a script or a handler that came with a name."""

    def __init__(self, data):
        super().__init__()
        self.found, self.inside = False, ""
        self.feed(data.decode("utf-8", "replace"))

    def handle_starttag(self, tag, attrs):
        self.inside = tag
        self.found |= any(key.startswith("on") and "alert" in (value or "") for key, value in attrs)

    def handle_data(self, data):
        self.found |= self.inside == "script" and "alert" in data

    def handle_endtag(self, tag):
        self.inside = ""


class Names(Row):
    name = "names"
    what = "backticks, $(), quotes, control characters, markup, long names in designs, ledgers, branches, flags, folders, TMPDIR"
    checks = "no name is a command, markup, LaTeX or a terminal sequence; an exit code and one sentence"
    tries = 144
    least = 6
    seconds = 230

    def prepare(self):
        self.sound = nights.Night(self.arena, "sound", nights.design(seed=self.seed % 1000 + 10, pairs=2))
        ended = self.sound.run()
        if ended.code != 0:
            raise RuntimeError(f"an undisturbed run ended with {ended.code}: {ended.last()}")
        self.repository = None

    def attempt(self, number, dice):
        case = CASES[number % len(CASES)]
        evil = dice.choice(EVIL) if dice.random() < 0.7 else dice.choice(EVIL) + dice.choice(EVIL)
        self.place = self.arena.place("here")  # where everything is started, and where a command would leave its mark
        wrong = getattr(self, case)(evil, dice)
        for mark in MARKS:
            for place in (self.place, self.arena.folder, self.arena.home, Path("/")):
                if (place / mark).exists():
                    wrong.append("a name ran a command")
                    (place / mark).unlink()
        return [f"{case} {ascii(evil)[:60]}: {sentence}" for sentence in wrong] + self.arena.left_over() + self.arena.temporary()

    def run(self, *words, codes=tools.CODES, **options):
        ended = self.arena.run(*words, cwd=self.place, addresses=0, **options)
        return ended, tools.answer(ended, codes=codes)

    def read(self, folder):
        """Everything that reports write."""
        wrong = []
        matchday = self.arena.matchday
        for form in FORMATS:
            ended, more = self.run(matchday, "report", folder, "--format", form)
            wrong += more
            if form == "latex" and re.search(rb"^[^%\n]*\\(input|write18)\b", ended.out, re.M):
                wrong.append("a name is a command of LaTeX")
        for words in (["--html"], ["--figures", self.place / "figures"]):
            wrong += self.run(matchday, "report", folder, *words)[1]
        pages = [folder / "report.html", *(self.place / "figures").glob("*.svg")]
        for page in pages:
            data = page.read_bytes() if page.exists() else b""
            if Markup(data).found:
                wrong.append(f"a name is markup in {page.name}")
            if tools.RAW.search(data):
                wrong.append(f"{page.name} has a control character")
        return wrong

    def teams(self, evil):
        return {"a": {"name": evil}, "b": {"name": evil + "2"}}

    def night(self, text):
        """A run of a design and all its reports."""
        night = nights.Night(self.arena, "here/night", text)
        wrong = self.run(*night.command)[1]
        return wrong + (self.read(night.folder) if (night.folder / "ledger.sqlite").exists() else [])

    def design(self, evil, dice):
        conditions = [{"name": "one"}, {"name": "two", "b.name": evil + "3", "b.speed_factor": 0.5}] if dice.random() < 0.5 else ()
        return self.night(nights.design(seed=2, pairs=2, **self.teams(evil), conditions=conditions, more=f"description = {json.dumps(evil)}"))

    def condition(self, evil, dice):
        if dice.random() < 0.5:
            return self.night(nights.design(name=evil, pairs=1))
        return self.night(nights.design(pairs=1, conditions=[{"name": evil}, {"name": "c" * dice.choice((90, 101, 300))}]))

    def said(self, evil, dice):
        """What a team says of itself."""
        mode = dice.choice(("escape_name", "backtick_name", "prints_escapes"))
        return self.night(nights.design(pairs=1, a={"command": [sys.executable, str(PROGRAM), mode, self.arena.token]}))

    def ledger(self, evil, _dice):
        """Somebody else's results, which are only read."""
        folder = self.place / "theirs"
        shutil.copytree(self.sound.folder, folder)
        with closing(sqlite3.connect(folder / "ledger.sqlite")) as database, database:
            text = nights.design(seed=self.seed % 1000 + 10, pairs=2, **self.teams(evil))
            database.execute("UPDATE experiment SET value = ? WHERE key = 'design'", (text,))
            database.execute("UPDATE attempts SET reason = ?, started = ?", (evil, evil))
        return self.read(folder)

    def program(self, evil, _dice):
        """A team whose file has the name."""
        name = evil.replace("/", "_").replace("\0", "_")[:200]
        if name in (".", "..", ""):
            return []
        os.symlink(self.arena.programs / "team-chaser", self.place / name)
        return self.night(nights.design(pairs=1, a={"command": [str(self.place / name)]}))

    def flags(self, evil, dice):
        if "\0" in evil:
            return []
        matchday, teams = self.arena.matchday, ["--blue", "team-chaser", "--yellow", "team-chaser", "--half-length", "1"]
        words = dice.choice((["play", *teams, "--blue-name", evil], ["play", *teams, "--blue", evil], ["play", *teams, "--rules", evil],
                             ["play", *teams, "--realism", evil], ["play", *teams, "--set", evil], ["report", evil], ["run", evil],
                             ["replay", self.sound.folder, evil], ["continue", evil], ["plan", evil], [evil], ["realism", evil],
                             ["judge", evil], ["report", self.sound.folder, "--format", evil]))
        wrong = self.run(matchday, *words, codes=(*tools.CODES,))[1]
        return wrong + self.run(self.arena.autoref, "replay", evil)[1] + self.run(self.arena.sim, "--duration", "0.1", "--realism", evil)[1]

    def folder(self, evil, _dice):
        """A result folder of that name, with figures and a page."""
        name = evil.replace("/", "_").replace("\0", "_")[:200]
        if name in (".", "..", ""):
            return []
        folder = self.place / name
        shutil.copytree(self.sound.folder, folder)
        figures = self.place / (name[:190] + "-figures")
        wrong = self.run(self.arena.matchday, "report", folder, "--figures", figures)[1]
        wrong += self.run(self.arena.matchday, "report", folder, "--html")[1]
        return wrong + self.run(self.arena.matchday, "run", self.sound.file, "--out", folder, "--no-preflight")[1]

    def temporary(self, evil, dice):
        """TMPDIR with that name, or too long for a socket, or missing."""
        name = evil.replace("/", "_").replace("\0", "_")[:200]
        place = self.place / dice.choice((name, "t" * 90, "missing"))
        if place.name not in ("missing", ".", ".."):
            place.mkdir(exist_ok=True)
        env = {"TMPDIR": str(place)}
        folder = self.place / "out"
        wrong = self.run(self.arena.matchday, "run", self.sound.file, "--out", folder, "--no-preflight", env=env)[1]
        return wrong + self.run(self.arena.matchday, "report", self.sound.folder, "--figures", self.place / "f", env=env)[1]

    def branch(self, evil, _dice):
        """A branch of somebody's repository, compared with main."""
        repository = self.place / "repository"
        repository.mkdir()
        team = repository / "team"
        team.write_text(f"#!/bin/sh\nexec '{self.arena.programs / 'team-chaser'}'\n")
        team.chmod(0o755)
        git = ["git", "-C", repository, "-c", "user.name=attack", "-c", "user.email=attack@localhost"]
        name = evil.replace(" ", "${IFS}").replace("..", "").replace("\\", "")
        if not re.fullmatch(r"[^\x00-\x20\x7f~^:?*\[\\]+", name) or name.startswith(("-", "/")):
            name = "`touch${IFS}owned`"
        for words in (["init", "-q", "-b", "main"], ["add", "team"], ["commit", "-q", "-m", "one"], ["branch", "--", name[:200]]):
            made = self.arena.run(*git, *words)
            if made.code != 0 and words[0] != "branch":
                raise RuntimeError(f"git {words[0]}: {made.last()}")
        named = name[:200] if made.code == 0 else "main"
        out = self.place / "compared"
        wrong = self.run(self.arena.matchday, "compare", "main", named, "--team-repo", repository, "--build", "true", "--run", "./team",
                         "--games", "2", "--half-length", "1", "--no-preflight", "--out", out)[1]
        return wrong + (self.read(out) if (out / "ledger.sqlite").exists() else [])
