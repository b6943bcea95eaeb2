"""Thousands of short games in one ledger: what the runner holds must not grow with them."""
import os
import time
from pathlib import Path

from . import arena as tools
from . import night as nights
from .row import Row

BYTES_A_GAME = 1024  # ours: a game leaves its hash and its place in the schedule, some 300 bytes; a leaked record has 2 kB
STEADY = 4 << 20  # [byte] the heap's own unrest: it grows by steps of a megabyte
SLOWER = 1.6  # ours: of the last quarter against the first; seen on a machine with other work: 1.2


def slope(points):
    """Least squares."""
    middle = sum(x for x, _ in points) / len(points)
    mean = sum(y for _, y in points) / len(points)
    spread = sum((x - middle) ** 2 for x, _ in points)
    return sum((x - middle) * (y - mean) for x, y in points) / spread if spread else 0.0


class Growth(Row):
    name = "growth"
    what = "short games in one ledger without growth of memory, files, processes or time a game"
    tries = 10_000
    least = 40
    seconds = 1200
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
            memory = int(fields["VmRSS"].split()[0]) * 1024
        except (OSError, KeyError):
            return None
        # At the end all games are read for the table, which is no growth.
        if status.get("process") != runner.pid or status.get("state") != "running" or not status.get("played"):
            return None
        return {"games": status["played"], "seconds": status["seconds"], "memory": memory, "files": files,
                "processes": len(night.family())}

    def flat(self, samples):
        samples = samples[len(samples) // 20:]  # it warms up
        if len(samples) < 8:
            self.notes.append(f"only {len(samples)} samples: nothing said about growth")
            return []
        first, last = samples[0], samples[-1]
        games = max(1, last["games"] - first["games"])
        a_game = slope([(one["games"], one["memory"]) for one in samples])
        quarter = max(1, len(samples) // 4)

        def pace(part):
            return (part[-1]["seconds"] - part[0]["seconds"]) / max(1, part[-1]["games"] - part[0]["games"])

        early, late = pace(samples[:quarter + 1]), pace(samples[-quarter - 1:])
        self.notes.append(f"memory {first['memory'] / 2**20:.1f} to {last['memory'] / 2**20:.1f} MiB, {a_game:.0f} bytes a game; files "
                          f"{min(one['files'] for one in samples)} to {max(one['files'] for one in samples)}; processes at most "
                          f"{max(one['processes'] for one in samples)}; {1000 * early:.0f} ms a game in the first quarter, "
                          f"{1000 * late:.0f} in the last")
        wrong = []
        if last["memory"] - first["memory"] > STEADY + BYTES_A_GAME * games:
            wrong.append(f"the runner's memory grew by {(last['memory'] - first['memory']) >> 10} KiB over {games} games")
        files = [one["files"] for one in samples]
        if max(files) - min(files) > 16:  # two workers come and go with five each, and the report
            wrong.append(f"its open files go from {min(files)} to {max(files)}")
        # Two games of a host and two teams each, with what isolates them, and the report's renewal.
        if max(one["processes"] for one in samples) > 24:
            wrong.append(f"there were {max(one['processes'] for one in samples)} processes at once")
        if games > 500 and late > SLOWER * early:
            wrong.append(f"a game took {1000 * late:.0f} ms at the end, {1000 * early:.0f} at the beginning")
        return wrong
