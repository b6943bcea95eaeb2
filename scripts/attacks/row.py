"""One row of the table: tries of one kind, each of which can be repeated alone."""
import random
import shutil
import sys
import time
import traceback

from .arena import printable


class NotPossible(Exception):
    """This machine does not allow it; the row says so."""


def broke():
    """The attack is wrong, or the programs left something that it did not expect: a failure, too."""
    last = traceback.format_exc().strip().splitlines()
    places = [line.strip() for line in last if line.strip().startswith("File ")]
    return f"the attack itself broke: {last[-1]} ({'; '.join(places[-2:])})"


class Row:
    """A kind of attack. `tries` and `seconds` are those of a campaign of an hour."""
    name = ""
    what = ""  # is done
    checks = ""  # what must hold after each try
    tries = 1
    least = 1  # of the shortest campaign
    seconds = 60
    bulk = False  # one call of attempt does `planned` of them

    def __init__(self, arena, seed):
        self.arena, self.seed = arena, seed
        self.planned = self.tries
        self.until = 0.0
        self.notes = []  # measurements for the table

    def prepare(self):
        """What all tries need; nothing here counts as a try."""

    def attempt(self, number, dice):
        """One try; the sentences of what went wrong, or with `bulk` a pair of how many and those."""
        raise NotImplementedError

    def chosen(self, cases, number):
        """The case of a try: all of a list in an order of the seed's."""
        order = list(cases)
        random.Random(f"{self.seed}/{self.name}/cases").shuffle(order)
        return order[number % len(order)]

    def dice(self, number):
        return random.Random(f"{self.seed}/{self.name}/{number}")

    def over(self):
        return time.monotonic() > self.until

    def guarded(self, number):
        try:
            return self.attempt(number, self.dice(number))
        except NotPossible:
            raise
        except Exception:
            return [broke()]

    @classmethod
    def part(cls, share):
        """How many tries a campaign of that share of an hour has."""
        return max(cls.least, min(cls.tries, round(cls.tries * share)))

    def play(self, share, seconds, only=None):
        """@param share    of an hour: so many of the tries
        @param seconds  after which no further try begins, once there were `least` of them
        @param only     the number of the one try that is repeated
        @return a line of the table, as a dictionary"""
        begin = time.monotonic()
        self.planned = self.part(share)
        self.until = begin + max(seconds, 10)
        result = {"row": self.name, "what": self.what, "checks": self.checks, "planned": self.planned, "tries": 0, "failed": 0, "failures": []}
        self.arena.place("now")

        def fail(number, sentences):
            result["failed"] += 1
            print(f"{self.name} try {number}: {printable(sentences[0])[:300]}", file=sys.stderr, flush=True)
            for sentence in sentences:
                result["failures"].append({"try": number, "sentence": sentence,
                                           "again": f"scripts/attack --only {self.name} --seed {self.seed} --try {number}"})

        try:
            self.prepare()
            if self.bulk:
                result["tries"], wrong = self.attempt(0, self.dice(0))
                if result["tries"] < self.planned:
                    self.notes.append(f"time for {result['tries']} of {self.planned}")
                if wrong:
                    fail(0, wrong)
            else:
                for number in range(self.planned) if only is None else [only]:
                    if self.over() and number >= self.least:
                        self.notes.append(f"time for {result['tries']} of {self.planned}")
                        break
                    wrong = self.guarded(number)
                    result["tries"] += 1
                    if wrong:
                        fail(number, wrong)
        except NotPossible as reason:
            result["not_possible"] = str(reason)
        except Exception:
            fail(result["tries"], [broke()])
        finally:
            self.clean()
        result["seconds"] = round(time.monotonic() - begin, 1)
        result["notes"] = self.notes
        return result

    def clean(self):
        """Ends and removes what the row has left."""
        left = self.arena.processes()
        self.arena.end(left)
        self.arena.reap()
        self.arena.known.clear()
        for path in self.arena.folder.iterdir():
            if path not in (self.arena.scratch, self.arena.home, self.arena.programs):
                shutil.rmtree(path, ignore_errors=True) if path.is_dir() and not path.is_symlink() else path.unlink()
        self.arena.temporary()
