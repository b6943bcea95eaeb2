"""Damage to bytes and to numbers, at random."""
import json
import os
import socket
import struct
from contextlib import closing

NUMBERS = (-1, 0, 255, 256, 2**31 - 1, 2**31, -(2**31), 2**32, 2**53 + 1, 2**63 - 1, -(2**63), 2**64, 1e308, -1e308, 1e-320, 0.5)
TEXTS = ("", "x" * 200_000, "\x1b]0;owned\x07", "`touch owned`", "\u202e", "-1", "NaN", "9" * 400, "{}", "\u0000")


def flip(data, dice):
    """A few bits."""
    data = bytearray(data)
    for _ in range(dice.choice((1, 1, 1, 3, 20))):
        data[dice.randrange(len(data))] ^= 1 << dice.randrange(8)
    return bytes(data)


def cut(data, dice):
    return data[:dice.randrange(len(data))]


def zero(data, dice):
    """Pages that were never written."""
    data = bytearray(data)
    size = dice.choice((16, 512, 4096))
    begin = dice.randrange(max(1, len(data) // size)) * size
    end = min(len(data), begin + size * dice.choice((1, 1, 4)))
    data[begin:end] = bytes(end - begin)
    return bytes(data)


def overwrite(data, dice):
    data = bytearray(data)
    piece = dice.choice((b"\xff" * 8, b"\x7f" * 4, struct.pack("<q", dice.choice(NUMBERS[:11])),
                         struct.pack("<d", float("nan")), struct.pack("<d", float("inf")), struct.pack("<f", 1e38),
                         struct.pack(">i", -1), struct.pack(">i", 2**31 - 1), b"\xff\xff\xff\xff\xff\xff\xff\xff\xff\x01", bytes(8),
                         dice.randbytes(dice.randint(1, 64))))
    at = dice.randrange(len(data))
    data[at:at + len(piece)] = piece
    return bytes(data)


def repeat(data, dice):
    """A stretch twice, or moved."""
    begin = dice.randrange(len(data))
    end = min(len(data), begin + dice.choice((1, 16, 1000, 100_000)))
    at = dice.randrange(len(data))
    return data[:at] + data[begin:end] + data[at:]


def remove(data, dice):
    begin = dice.randrange(len(data))
    return data[:begin] + data[begin + dice.choice((1, 4, 100, 10_000)):]


def noise(data, dice):
    return dice.randbytes(dice.choice((0, 1, 100, 5000))) + (data if dice.random() < 0.5 else b"")


BYTES = (flip, flip, flip, cut, zero, overwrite, overwrite, repeat, remove, noise)


def bytes_of(data, dice):
    """@return the damaged bytes and the name of the damage"""
    action = dice.choice(BYTES)
    return (action(data, dice), action.__name__) if data else (noise(data, dice), "noise")


ODD = ("pipe", "device", "folder", "socket", "loop")


def odd_file(path, kind):
    """What is no file stands where one should; nobody writes into the pipe."""
    path.unlink(missing_ok=True)
    if kind == "pipe":
        os.mkfifo(path)
    elif kind == "device":
        path.symlink_to("/dev/zero")
    elif kind == "folder":
        path.mkdir()
    elif kind == "loop":
        path.symlink_to(path.name)
    else:
        with closing(socket.socket(socket.AF_UNIX)) as one:
            one.bind(str(path))


def leaves(value, path=()):
    """Paths to all values of a JSON document that hold no others."""
    if isinstance(value, dict):
        for key, one in value.items():
            yield from leaves(one, (*path, key))
    elif isinstance(value, list) and value:
        for index, one in enumerate(value):
            yield from leaves(one, (*path, index))
    else:
        yield path


def json_value(text, dice):
    """One value of a JSON document replaced, of another type or out of its range.
    @return the text and what was changed"""
    document = json.loads(text)
    path = dice.choice(list(leaves(document)))
    if not path:
        return "null", "all of it"
    cut_at = dice.randint(1, len(path)) if dice.random() < 0.2 else len(path)
    place = document
    for step in path[:cut_at - 1]:
        place = place[step]
    if dice.random() < 0.1:
        del place[path[cut_at - 1]]
    else:
        before = place[path[cut_at - 1]]
        new = dice.choice((*NUMBERS, *TEXTS, None, True, [], {}, [[[]]], [1] * 5000))
        place[path[cut_at - 1]] = new if new != before else "other"
    return json.dumps(document), "/".join(str(step) for step in path[:cut_at])


def toml_text(text, dice):
    """A design with one value replaced, or with damaged bytes."""
    lines = text.splitlines()
    numbered = [number for number, one in enumerate(lines) if " = " in one]
    if dice.random() < 0.4:
        return bytes_of(text.encode(), dice)[0]
    at = dice.choice(numbered)
    value = dice.choice(("-1", "0", "1e308", "nan", "-inf", "99999999999999999999", "9223372036854775807", '""', '"' + "x" * 300_000 + '"',
                         "[]", "[" * 40_000 + "]" * 40_000, "{}", "true", "1979-05-27", '"\\u001b[2J"', '["", ""]', '"`touch owned`"',
                         "{a={" * 20_000, "'''x'''", "0x7fffffffffffffff", '"a\\u0000b"'))
    lines[at] = lines[at].split(" = ")[0] + " = " + value
    return "\n".join(lines).encode()
