"""Thousands of short games in one ledger: what the runner holds must not grow with them."""
import os
import statistics
import time
from pathlib import Path

from . import arena as tools
from . import night as nights
from .hostile import used
from .row import Row

# All ours. Of the runner:
BYTES_A_GAME = 1024  # of memory: a game leaves its hash and its place in the schedule, some 300; a leaked record has 2 kB
STEADY = 4 << 20  # [byte] the heap's own unrest: it grows by steps of a megabyte
FILES = 64  # open at once: two workers with five each, ledger, locks, the report's renewal
GAINED = 3  # files or processes between the first and the last quarter: one lost in 1000 games is 7
# Of the machine:
DISK_A_GAME = 30_000  # [byte] twice what is usual: a row has some 5 kB, and one game in a hundred is kept, with 0.9 MB
DISK_STEADY = 8 << 20  # [byte] games that are being played
TEMPORARY = 4 << 20  # [byte] of two games: sockets and inputs
PROCESSES = 32  # at once: two games of a worker, two teams and what isolates each, the report's renewal, ourselves
SLOWER = 1.6  # of the last quarter against the first, in processor time; seen with other work on the machine: 1.2
STEP = 0.002  # [s] a game: processor time is counted in steps of 10 ms
TICKS = os.sysconf("SC_CLK_TCK")


class Growth(Row):
    name = "growth"
    what = "10,000 short games in one ledger, played beside the other rows"
    checks = "no void game, no game twice; memory, disk, files, processes and time a game stay what they were"
    tries = 10_000
    least = 40
    seconds = 3600
    bulk = True

    def attempt(self, _number, _dice):
        pairs = (self.planned + 1) // 2
        # Of teams that cost nothing, so that it is the runner that is measured; 1 % is sampled and played again, as usual.
        text = nights.design(name="growth", seed=self.seed % 1000 + 7, pairs=pairs, half_length=1.0, a={"command": ["team-chaser"]},
                             limits={"sampled": 0.01, "audited": 0.01})
        night = nights.Night(self.arena, "growth", text)
        runner = night.start()
        samples, wrong = [], []
        while runner.running():
            sample = self.sample(night, runner)
            if sample:
                samples.append(sample)
            if self.over():
                runner.send(15)  # what is there is looked at
                break
            time.sleep(min(1.0, 0.05 + self.planned / 2000))
        ended = runner.wait(60)
        wrong += tools.answer(ended, codes=(0, 143), memory=8 << 30)
        rows = nights.rows(night.folder)
        games = nights.counted(rows)
        if ended.code == 0 and len(games) != 2 * pairs:
            wrong.append(f"{len(games)} of {2 * pairs} games are in the ledger")
        void = [row for row in rows if row["outcome"] == "void"]
        if void:
            wrong.append(f"{len(void)} games are void: {void[0]['reason'][:120]}")
        if len({row["hash"] for row in rows}) != len(rows):
            wrong.append("two games have the same hash")
        wrong += self.flat(samples) + self.arena.left_over() + self.arena.temporary()
        table = night.table("text")
        wrong += tools.answer(table, codes=(0,))
        self.notes.append(f"the report of it: {table.memory >> 20} MiB, {table.seconds:.1f} s")
        return len(rows), wrong

    def sample(self, night, runner):
        status = night.status()
        try:
            fields = dict(line.split(":", 1) for line in Path(f"/proc/{runner.pid}/status").read_text().splitlines() if ":" in line)
            files = len(os.listdir(f"/proc/{runner.pid}/fd"))
            times = [int(word) / TICKS for word in Path(f"/proc/{runner.pid}/stat").read_text().rsplit(")", 1)[1].split()[11:15]]
            memory = int(fields["VmRSS"].split()[0]) * 1024
        except (OSError, KeyError):
            return None
        # At the end all games are read for the table, which is no growth.
        if status.get("process") != runner.pid or status.get("state") != "running" or not status.get("played"):
            return None
        # In a process namespace of our own these are all there are, those that have ended and are not reaped too.
        processes = sum(entry.name.isdigit() for entry in Path("/proc").iterdir()) if self.arena.alone else len(night.family())
        return {"games": status["played"], "seconds": sum(times), "own": times[0] + times[1], "memory": memory, "files": files, "processes": processes,
                "disk": used(night.folder), "temporary": used(self.arena.scratch)}

    def flat(self, samples):
        """What grew, as sentences."""
        samples = samples[len(samples) // 20:]  # it warms up
        if len(samples) < 8:
            return [f"only {len(samples)} samples: nothing can be said about growth"]
        games = max(1, samples[-1]["games"] - samples[0]["games"])
        quarter = max(2, len(samples) // 4)
        first, last = samples[:quarter], samples[-quarter:]

        def usual(part, key):
            return statistics.median(one[key] for one in part)

        def pace(part, key):
            return (part[-1][key] - part[0][key]) / max(1, part[-1]["games"] - part[0]["games"])

        apart = usual(last, "games") - usual(first, "games")
        # Processor time: the clock depends on what else the machine does.
        early, late, own, own_late = pace(first, "seconds"), pace(last, "seconds"), pace(first, "own"), pace(last, "own")
        memory, disk = (usual(last, key) - usual(first, key) for key in ("memory", "disk"))
        self.notes.append(f"over {games} games: memory {samples[0]['memory'] / 2**20:.1f} to {samples[-1]['memory'] / 2**20:.1f} MiB, "
                          f"disk {disk / max(1, apart):.0f} bytes a game, temporary files at most "
                          f"{max(one['temporary'] for one in samples) >> 10} KiB; files {usual(first, 'files'):.0f} to "
                          f"{usual(last, 'files'):.0f}, processes {usual(first, 'processes'):.0f} to {usual(last, 'processes'):.0f}, at most "
                          f"{max(one['processes'] for one in samples)}; processor time a game {1000 * early:.0f} ms at first, {1000 * late:.0f} at last, the runner's own "
                          f"{1000 * own:.1f} and {1000 * own_late:.1f}")
        wrong = []
        if memory > STEADY + BYTES_A_GAME * apart:
            wrong.append(f"the runner's memory grew by {int(memory) >> 10} KiB over {apart:.0f} games")
        if disk > DISK_STEADY + DISK_A_GAME * apart:
            wrong.append(f"the result folder grew by {disk / max(1, apart):.0f} bytes a game")
        if max(one["temporary"] for one in last) > TEMPORARY:
            wrong.append(f"there were {max(one['temporary'] for one in last) >> 10} KiB of temporary files")
        for key, most in (("files", FILES), ("processes", PROCESSES)):
            # Two games more or less are no growth; that the usual number is another one is.
            if usual(last, key) - usual(first, key) > GAINED:
                wrong.append(f"its {key} went from {usual(first, key):.0f} to {usual(last, key):.0f}")
            if max(one[key] for one in samples) > most:
                wrong.append(f"there were {max(one[key] for one in samples)} {key} at once")
        for what, before, after in (("a game", early, late), ("the runner itself", own, own_late)):
            if games > 500 and after > SLOWER * before + STEP:
                wrong.append(f"{what} took {1000 * after:.1f} ms of processor time at the end, {1000 * before:.1f} at the beginning")
        return wrong

    def prepare(self):
        """The judgement is judged: made-up samples that leak a little are refused, those without growth are not."""
        def made(**leaks):
            usual = {"seconds": 0.1, "own": 0.005, "memory": 0.0, "disk": 14_000.0, "files": 0.0, "processes": 0.0, "temporary": 0.0, **leaks}
            begin = {"memory": 40 << 20, "files": 30, "processes": 14}
            return [{"games": n, **{key: int(begin.get(key, 0) + n * a_game) if key not in ("seconds", "own") else n * a_game
                                    for key, a_game in usual.items()}} for n in range(0, self.tries, 100)]

        leaks = {"memory": 2000.0, "disk": 36_000.0, "files": 1e-3, "processes": 1e-3, "temporary": 1000.0}
        if self.flat(made()):
            raise RuntimeError(f"samples without growth are refused: {self.flat(made())}")
        for key, a_game in leaks.items():
            if not self.flat(made(**{key: a_game})):
                raise RuntimeError(f"{a_game:g} of {key} a game are not noticed")
        for key, a_game in (("seconds", 0.1), ("own", 0.005)):
            slowing = made()
            for one in slowing:
                one[key] = a_game * one["games"] * (1 + one["games"] / self.tries)  # at last three times as long
            if not self.flat(slowing):
                raise RuntimeError(f"games that take ever more time ({key}) are not noticed")
        self.notes.clear()
