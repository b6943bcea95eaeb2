"""Short nights: their designs, and what stands in their ledgers."""
import json
import os
import re
import shlex
import sqlite3
import time
from pathlib import Path

# Games of a second a half: some 0.15 s, as short as the rules allow.
PROGRAMS = ("team-reference", "team-chaser")
OPEN_LIMITS = {"free_disk": 1, "faults_in_a_row": 1000, "fault_share": 1.0, "sampled": 0.0, "audited": 0.0}


def toml(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value)  # a basic string of TOML but for the escaping of U+007F
    if isinstance(value, list):
        return "[" + ", ".join(toml(one) for one in value) + "]"
    return repr(value)


def design(name="night", seed=1, pairs=2, half_length=1.0, a=None, b=None, conditions=(), limits=None, more=""):
    """The text of a design; `a` and `b` are keys of the teams."""
    lines = [f"name = {toml(name)}", f"seed = {seed}", f"pairs = {pairs}", more, "[rules]", f"half_length = {half_length}"]
    for letter, team, program in (("a", a, PROGRAMS[0]), ("b", b, PROGRAMS[1])):
        lines.append(f"[teams.{letter}]")
        lines += [f"{key} = {toml(value)}" for key, value in {"command": [program], **(team or {})}.items()]
    for condition in conditions:
        lines.append("[[conditions]]")
        lines += [f"{key} = {toml(value)}" for key, value in condition.items()]
    lines.append("[limits]")
    lines += [f"{key} = {toml(value)}" for key, value in {**OPEN_LIMITS, **(limits or {})}.items()]
    return "\n".join(lines) + "\n"


GAME = ("condition", "pair", "leg", "attempt", "seed", "outcome", "termination", "at_fault", "reason", "goals_yellow", "goals_blue",
        "ticks", "hash", "fouls_yellow", "fouls_blue", "stoppages", "a_colour")


def rows(folder):
    """All attempts of a ledger, as dictionaries."""
    database = sqlite3.connect(f"file:{folder / 'ledger.sqlite'}?mode=ro", uri=True, timeout=10)
    try:
        found = database.execute(f"SELECT {', '.join(GAME)} FROM attempts ORDER BY condition, pair, leg, attempt").fetchall()
        health = database.execute("PRAGMA integrity_check").fetchone()[0]
    finally:
        database.close()
    if health != "ok":
        raise sqlite3.DatabaseError(health)
    return [dict(zip(GAME, row)) for row in found]


def counted(attempts):
    """{game: row} of the attempts that count: the last of a pair when both legs of it are no void."""
    last = {}
    for row in attempts:
        pair = (row["condition"], row["pair"])
        last[pair] = max(row["attempt"], last.get(pair, 0))
    games = {}
    for row in attempts:
        if row["attempt"] == last[row["condition"], row["pair"]] and row["outcome"] != "void":
            games[row["condition"], row["pair"], row["leg"]] = row
    return games


def played(row):
    """What must be the same in every run."""
    return {key: row[key] for key in GAME if key not in ("attempt", "reason", "at_fault")}


class Night:
    """One design in one folder, run as often as needed."""

    def __init__(self, arena, name, text, preflight=False, workers=2, env=None):
        # The design lies beside all result folders, not in one of them: those may be on a disk that is full.
        self.arena, self.folder, self.file = arena, arena.folder / name, arena.folder / f"{name.replace('/', '-')}.toml"
        self.file.write_text(text)
        self.env = env
        self.command = [arena.matchday, "run", self.file, "--out", self.folder, "--workers", str(workers)]
        if not preflight:
            self.command.append("--no-preflight")

    def start(self, **options):
        return self.arena.start(*self.command, env=self.env, addresses=0, **options)

    def run(self, limit=90):
        return self.start().wait(limit)

    @property
    def mark(self):
        return f"MATCHDAY_GAME={os.path.realpath(self.folder)}/"

    def family(self):
        """Processes of its games: {pid: worker or team}."""
        return {pid: "worker" if words[1:2] == ["worker"] else "team" for pid, words in self.arena.processes(self.mark).items()}

    def program(self, pid):
        """Which of the two programs the process of a team is or holds; "" when it has ended."""
        try:
            words = Path(f"/proc/{pid}/cmdline").read_bytes().decode("utf-8", "replace").rstrip("\0").split("\0")
        except OSError:
            return ""
        # What isolates a team names its program last.
        return Path(words[-1]).name if Path(words[-1]).name in PROGRAMS else ""

    def games(self):
        return counted(rows(self.folder))

    def table(self, form="csv"):
        return self.arena.run(self.arena.matchday, "report", self.folder, "--format", form)

    def status(self):
        try:
            return json.loads((self.folder / "status.json").read_text())
        except (OSError, ValueError):
            return {}

    def wait_for(self, child, state=None, words=None, limit=20):
        """Whether the run said so, or came so far, before it ended."""
        until = time.monotonic() + limit
        while child.running() and time.monotonic() < until:
            if state and self.status().get("state") == state and self.status().get("process") == child.pid:
                return True
            if words and words in child.said():
                return True
            time.sleep(0.01)
        return False

    def continued(self, ended, times=6, limit=90):
        """Runs the same command until it is done; the last end, and what was wrong on the way."""
        wrong = []
        while ended.code != 0 and times > 0:
            ended = self.run(limit)
            times -= 1
        if ended.code != 0:
            wrong.append(f"continuing ends with code {ended.code}: {ended.last()}")
        return ended, wrong


def same_games(found, expected):
    """What differs between two nights, as a sentence."""
    missing = sorted(set(expected) - set(found))
    if missing:
        return [f"{len(missing)} games are missing, as {missing[0]}"]
    if set(found) - set(expected):
        return [f"there are games too many, as {sorted(set(found) - set(expected))[0]}"]
    differs = [key for key in sorted(expected) if played(found[key]) != played(expected[key])]
    if differs:
        row = found[differs[0]]
        return [f"{len(differs)} games went differently, as {differs[0]}: {row['termination']}, {row['reason'][:100]}"]
    return []


def tidy(night, usual):
    """What lies in the result folder that an undisturbed one does not have."""
    names = {path.name for path in Path(night.folder).iterdir()} - usual - {"games", "audits", "refresh.log"}
    return [f"the result folder has {', '.join(sorted(names))} left"] if names else []


def told_again(ended):
    """The command that continues, as the run printed it; nothing when it did not."""
    found = re.search(r"(?:continue|and start again|, continue) ?with: (.*)$", ended.words, re.M)
    return shlex.split(found.group(1)) if found else None
