"""Protocol buffers by hand: the few fields the attacks write, and nothing that would refuse a wrong one."""
import struct


def varint(value):
    value &= (1 << 64) - 1
    out = bytearray()
    while value >= 0x80:
        out.append(value & 0x7F | 0x80)
        value >>= 7
    out.append(value)
    return bytes(out)


def number(field, value):
    return varint(field << 3) + varint(value)


def floating(field, value):
    return varint(field << 3 | 5) + struct.pack("<f", value)


def delimited(field, data):
    return varint(field << 3 | 2) + varint(len(data)) + data


def text(field, words):
    return delimited(field, words.encode("utf-8", "surrogateescape"))


def frame(payload):
    """A message of the team's channel: its length, then its bytes."""
    return varint(len(payload)) + payload


def tick_of(payload):
    """The number of the tick in a HostMessage; nothing when it is another message."""
    if not payload or payload[0] != 2 << 3 | 2:
        return None
    at = 1
    while payload[at] & 0x80:  # the length of the tick
        at += 1
    at += 2  # and the key of its first field
    value = shift = 0
    while True:
        value |= (payload[at] & 0x7F) << shift
        shift += 7
        if payload[at] < 0x80:
            return value
        at += 1


def text_of(payload, *path):
    """The bytes of a field in a field, by their numbers, of a sound message; b"" when it is not there."""
    for wanted in path:
        at, found = 0, b""
        while at < len(payload):
            key, at = varint_of(payload, at)
            if key & 7 == 2:
                size, at = varint_of(payload, at)
                found = payload[at:at + size] if key >> 3 == wanted else found
                at += size
            elif key & 7 == 0:
                _, at = varint_of(payload, at)
            else:
                at += 8 if key & 7 == 1 else 4
        payload = found
    return payload


def varint_of(payload, at):
    value = shift = 0
    while True:
        value |= (payload[at] & 0x7F) << shift
        shift += 7
        at += 1
        if payload[at - 1] < 0x80:
            return value, at


def kind_of(payload):
    """hello, tick, goodbye"""
    return {1: "hello", 2: "tick", 3: "goodbye"}.get(payload[0] >> 3, "other") if payload else "other"
