"""The wall clock jumps by hours and daylight saving time begins while games are played."""
import sqlite3
import time
from contextlib import closing

from . import night as nights
from .row import NotPossible, Row


class Clocks(Row):
    name = "clocks"
    what = "wall clock that jumps by hours, back and forth, every 0.1 s; changes of daylight saving time"
    checks = "same games and table as undisturbed, and the clock did jump"
    tries = 24
    least = 2
    seconds = 180

    def prepare(self):
        self.library = self.arena.programs / "libshifted_clock.so"
        if not self.library.exists():
            raise NotPossible(f"{self.library} is not there; scripts/build release shifted_clock")
        self.text = nights.design(seed=self.seed % 1000 + 8, pairs=6, limits={"sampled": 0.2, "audited": 0.2})
        night = nights.Night(self.arena, "undisturbed", self.text, preflight=True)
        ended = night.run()
        if ended.code != 0:
            raise RuntimeError(f"an undisturbed run ended with {ended.code}: {ended.last()}")
        self.expected, self.table = night.games(), night.table().out

    def attempt(self, number, dice):
        now = time.gmtime(time.time() + 1)
        second = now.tm_hour * 3600 + now.tm_min * 60 + now.tm_sec
        day = min(now.tm_yday, 365)
        zones = (f"AAA0BBB,{day - 1}/{second // 3600}:{second // 60 % 60}:{second % 60},364/24",
                 f"AAA0BBB,0/0,{day - 1}/{second // 3600 + 1}:{second // 60 % 60}:{second % 60}",
                 "AAA11:59:59", "nonsense", ":/dev/null", "AAA-14BBB,M3.5.0,M10.5.0/3")
        env = {"LD_PRELOAD": str(self.library), "SHIFTED_CLOCK_SEED": str(dice.randrange(1 << 30)),
               "SHIFTED_CLOCK_HOURS": str(dice.choice((1, 12, 24 * 400))), "TZ": zones[number % len(zones)]}
        night = nights.Night(self.arena, f"clock-{number}", self.text, preflight=number % 2 == 0, env=env)
        ended = night.run()
        if ended.code != 0:
            return [f"it ends with {ended.code}: {ended.last()}"]
        wrong = nights.same_games(night.games(), self.expected)
        if night.table().out != self.table:
            wrong.append("the table differs from that of an undisturbed run")
        with closing(sqlite3.connect(night.folder / "ledger.sqlite")) as database:
            dates = {row[0][:13] for row in database.execute("SELECT started FROM attempts")}
        if len(dates) < 2:  # an oracle for the attack itself: jumps of an hour and more must be seen
            wrong.append("the clock did not jump: the preloaded library has no effect")
        return wrong + self.arena.left_over() + self.arena.temporary()
