"""Result folders with damaged ledgers, manifests, recordings; damaged designs: every command answers in a sentence."""
import re
import shutil
import sqlite3
from contextlib import closing

from . import arena as tools
from . import damage
from . import night as nights
from .row import Row

KINDS = ("bytes", "row", "record", "bytes", "schema", "experiment", "row", "record", "manifest", "recording", "design", "bytes", "odd")
FORMATS = ("text", "markdown", "csv", "json", "latex")
PROMPT = 15  # [s] ours: to refuse takes 0.1 s, verify 2 s
ROUND = 0.25  # share of the tries that also continue the run, which is the slowest command


class Folders(Row):
    name = "folders"
    what = "damaged ledgers, rows, numbers, schemas, manifests, recordings, designs, and pipes or devices in their place, into every command that reads them"
    checks = ("an exit code and one sentence of its own, within its time and memory, no control characters; verify notices what "
              "changes a report")
    tries = 240
    least = 8
    seconds = 300

    def prepare(self):
        # All games are sampled and audited, so there are recordings, logs and verdicts to be damaged.
        self.text = nights.design(seed=self.seed % 1000 + 5, pairs=2, limits={"sampled": 1.0, "audited": 1.0},
                                  conditions=[{"name": "base"}, {"name": "slow", "b.speed_factor": 0.5}])
        self.night = nights.Night(self.arena, "sound", self.text)
        ended = self.night.run()
        if ended.code != 0:
            raise RuntimeError(f"an undisturbed run ended with {ended.code}: {ended.last()}")
        helped = self.arena.run(self.arena.matchday, "--help")
        self.verifies = re.search(rb"^ +verify ", helped.out, re.M) is not None
        if not self.verifies:
            self.notes.append("there is no matchday verify yet")
        elif self.arena.run(self.arena.matchday, "verify", self.night.folder, addresses=0).code != 0:
            raise RuntimeError("verify finds something in an undisturbed folder")
        self.told = self.asked = 0

    def attempt(self, number, dice):
        kind = KINDS[number % len(KINDS)]
        folder = self.arena.folder / f"damaged-{number}"
        shutil.copytree(self.night.folder, folder)
        if kind == "odd":
            what, wrong = self.odd(folder, dice)
        else:
            what, meant = getattr(self, "damage_" + kind)(folder, dice)
            wrong = self.design(what, dice) if kind == "design" else self.commands(folder, dice, meant)
        shutil.rmtree(folder, ignore_errors=True)
        return [f"{kind} ({what}): {sentence}" for sentence in wrong]

    # --- what is damaged; and whether it changes what a report says, so that verify must notice

    def damage_bytes(self, folder, dice):
        file = folder / "ledger.sqlite"
        data, what = damage.bytes_of(file.read_bytes(), dice)
        file.write_bytes(data)
        return what, False

    def edit(self, folder, statement, values=()):
        with closing(sqlite3.connect(folder / "ledger.sqlite")) as database, database:
            database.execute(statement, values)

    def one(self, folder, columns, table, dice):
        with closing(sqlite3.connect(folder / "ledger.sqlite")) as database:
            return dice.choice(database.execute(f"SELECT rowid, {columns} FROM {table}").fetchall())

    def damage_row(self, folder, dice):
        column = dice.choice(nights.GAME)
        number, before = self.one(folder, column, "attempts", dice)
        value = dice.choice((*damage.NUMBERS[:11], 1e308, *damage.TEXTS, None, b"\xff\xfe", before))
        if isinstance(before, int) and dice.random() < 0.5:
            value = before + 1  # the forger's: nothing else would notice it
        if value == before:
            value = "other"
        try:
            self.edit(folder, f"UPDATE attempts SET {column} = ? WHERE rowid = ?", (value, number))
        except (sqlite3.Error, OverflowError):
            self.edit(folder, "DELETE FROM attempts WHERE rowid = ?", (number,))
            return "a row is missing", False
        return f"{column} = {str(value)[:30]!r}", True

    def damage_record(self, folder, dice):
        number, record = self.one(folder, "record", "attempts", dice)
        if dice.random() < 0.2:
            data, what = damage.bytes_of(record.encode(), dice)
            changed = data.decode("utf-8", "replace")
        else:
            changed, what = damage.json_value(record, dice)
        self.edit(folder, "UPDATE attempts SET record = ? WHERE rowid = ?", (changed, number))
        return "record: " + what, changed != record

    def damage_schema(self, folder, dice):
        statement = dice.choice((
            "PRAGMA user_version = 99", "PRAGMA user_version = -1", "PRAGMA application_id = 7", "DROP TABLE attempts", "DROP VIEW games",
            "ALTER TABLE attempts RENAME TO gone", "DELETE FROM experiment", "ALTER TABLE attempts ADD COLUMN more TEXT",
            "ALTER TABLE attempts RENAME COLUMN hash TO hsah", "CREATE TRIGGER t AFTER INSERT ON attempts BEGIN DELETE FROM attempts; END",
            "DROP TABLE audits", "UPDATE audits SET verdict = 'fine'", "DELETE FROM attempts", "PRAGMA journal_mode = WAL",
            "CREATE VIEW v AS SELECT 1", "DROP TABLE experiment", "PRAGMA encoding = 'UTF-16'"))
        self.edit(folder, statement)
        return statement, False

    def damage_experiment(self, folder, dice):
        key = dice.choice(("hash", "design"))
        changed = dice.choice(damage.TEXTS) if key == "hash" else damage.toml_text(self.text, dice).decode("utf-8", "replace")
        self.edit(folder, "UPDATE experiment SET value = ? WHERE key = ?", (changed, key))
        return key, changed != self.text

    def damage_manifest(self, folder, dice):
        file = folder / dice.choice(("manifest.json", "status.json", "report.html"))
        if dice.random() < 0.5 and file.suffix == ".json":
            file.write_text(damage.json_value(file.read_text(), dice)[0])
        else:
            file.write_bytes(damage.bytes_of(file.read_bytes(), dice)[0])
        return file.name, False

    def damage_recording(self, folder, dice):
        files = sorted(path for path in (folder / "games").rglob("game.*") if path.is_file())
        file = dice.choice(files)
        data, what = damage.bytes_of(file.read_bytes(), dice)
        file.write_bytes(data)
        return f"{file.name}, {what}", True

    def damage_design(self, _folder, dice):
        self.damaged = damage.toml_text(self.text, dice)
        return repr(self.damaged[:0]) if not self.damaged else "a design", False

    # --- what is no file, where a file should be: refused at once

    def odd(self, folder, dice):
        place, kind = dice.choice(("design", "ledger", "journal", "recording", "manifest")), dice.choice(("pipe", *damage.ODD))
        wrong = getattr(self, "odd_" + place)(folder, kind)
        return f"{place} is a {kind}", wrong + self.arena.left_over() + self.arena.temporary()

    def refused(self, codes, *words):
        """The command ends soon, with one of these codes."""
        ended = self.arena.run(self.arena.matchday, *words, limit=PROMPT, addresses=0)
        return tools.answer(ended, codes=codes, sentence=words[0] != "verify")  # that one tells what it finds

    def odd_design(self, _folder, kind):
        file, out = self.arena.folder / "odd.toml", self.arena.folder / "of-odd"
        damage.odd_file(file, kind)
        wrong = self.refused((2,), "plan", file) + self.refused((2,), "judge", file, "--games", "1", "--out", out)
        wrong += self.refused((2,), "run", file, "--out", out, "--no-preflight")
        if out.exists():
            wrong.append("a design that is refused has a result folder")
            shutil.rmtree(out)
        file.rmdir() if kind == "folder" else file.unlink()
        return wrong

    def readers(self, folder, codes):
        return self.refused(codes, "report", folder) + self.refused(codes, "replay", folder, "base-0000-1") + \
            self.refused(codes, "verify", folder) + self.refused(codes, "run", self.night.file, "--out", folder, "--no-preflight")

    def odd_ledger(self, folder, kind):
        damage.odd_file(folder / "ledger.sqlite", kind)
        return self.readers(folder, (2, 5))

    def odd_journal(self, folder, kind):
        damage.odd_file(folder / "ledger.sqlite-journal", kind)
        return self.readers(folder, (0, 2, 5))

    def odd_recording(self, folder, kind):
        for file in [path for path in (folder / "games").rglob("game.*") if path.is_file()]:
            damage.odd_file(file, kind)
        return self.refused((2, 4, 5), "replay", folder, "base-0000-1", "--recorded") + self.refused((5,), "verify", folder) + \
            self.refused((0,), "report", folder)

    def odd_manifest(self, folder, kind):
        for name in ("manifest.json", "status.json"):
            damage.odd_file(folder / name, kind)
        return self.refused((4, 5), "verify", folder) + self.refused((0, 2, 5), "report", folder, "--html")

    # --- the commands

    def design(self, _what, dice):
        file = self.arena.folder / "damaged.toml"
        file.write_bytes(self.damaged)
        matchday, out = self.arena.matchday, self.arena.folder / "of-damaged"
        wrong = tools.answer(self.arena.run(matchday, "plan", file, limit=90))
        # A design that is still one may ask for a long night: then TERM ends it as it should.
        child = self.arena.start(matchday, "run", file, "--out", out, "--no-preflight", addresses=0)
        until = child.begin + 8
        while child.running() and tools.time.monotonic() < until:
            tools.time.sleep(0.02)
        for _ in range(2):
            child.send(15)
        wrong += tools.answer(child.wait(20), codes=(*tools.CODES, 143))
        shutil.rmtree(out, ignore_errors=True)
        return wrong

    def commands(self, folder, dice, meant):
        matchday = self.arena.matchday
        wrong = []
        for form in dice.sample(FORMATS, 2):
            wrong += tools.answer(self.arena.run(matchday, "report", folder, "--format", form))
        wrong += tools.answer(self.arena.run(matchday, "report", folder, "--html"))
        if dice.random() < 0.2:
            wrong += tools.answer(self.arena.run(matchday, "report", folder, "--figures", folder / "figures"))
        recorded = ["--recorded"] if dice.random() < 0.5 else []
        wrong += tools.answer(self.arena.run(matchday, "replay", folder, "base-0000-1", *recorded, addresses=0))
        if self.verifies:
            verified = self.arena.run(matchday, "verify", folder, addresses=0, limit=120)
            wrong += tools.answer(verified, sentence=False)
            self.asked += meant
            if meant and verified.code not in (2, 5):
                wrong.append(f"verify finds nothing: code {verified.code}")
            self.told += meant and verified.code in (2, 5)
            self.notes = [f"verify noticed {self.told} of {self.asked} damages that change what a report says"]
        if dice.random() < ROUND:
            ended = self.arena.run(matchday, "run", self.night.file, "--out", folder, "--no-preflight", "--workers", "2", addresses=0,
                                   limit=120)
            wrong += tools.answer(ended)
        return wrong + self.arena.left_over() + self.arena.temporary()
