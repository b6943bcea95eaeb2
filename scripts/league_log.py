"""Reads league logs for the scripts here."""
import gzip
import pathlib
import struct
import sys
import zlib

ROOT = pathlib.Path(__file__).resolve().parent.parent
VISION, REFEREE = 4, 3


def die(sentence):
    print(f"{pathlib.Path(sys.argv[0]).name}: {sentence}", file=sys.stderr)
    sys.exit(2)


def records(path):
    """Yields (seconds since the first record, type, payload) of an SSL log, version 1.

    Of a log that is cut or damaged it yields what can be read, and says so on stderr.
    """
    if path.is_dir():
        die(f"{path}: is a directory; name a league log, as game.log or game.log.gz")
    try:
        opened = gzip.open(path, "rb") if path.suffix == ".gz" else open(path, "rb")
    except OSError as error:
        die(f"{path}: {error.strerror}")
    with opened as log:
        header, _ = read_bytes(log, 16)
        if header[:12] != b"SSL_LOG_FILE" or header[12:] != b"\0\0\0\1":
            die(f"{path}: not an SSL log file of version 1")
        first = t = None
        while True:
            head, damaged = read_bytes(log, 16)
            if not head and not damaged:
                return
            time_ns, kind, size = struct.unpack(">qii", head) if len(head) == 16 else (0, 0, -1)
            payload, _ = read_bytes(log, size) if size >= 0 else (b"", True)
            if len(payload) < size or size < 0:
                end = "before the first record" if t is None else f"after {t:.3f} s"
                print(f"{path}: cut or damaged {end}; used what was read until there", file=sys.stderr)
                return
            first = time_ns if first is None else first
            t = (time_ns - first) / 1e9
            yield t, kind, payload


def read_bytes(log, size):
    """Up to `size` bytes, and whether the packed data ended badly."""
    try:
        return log.read(size), False
    except (EOFError, zlib.error, gzip.BadGzipFile):
        return b"", True


def load_messages(folder):
    places = [pathlib.Path(folder)] if folder else sorted(ROOT.glob("build/*/python"))
    for place in places:
        if (place / "sim/proto/vision_pb2.py").exists():
            sys.path.insert(0, str(place))
            from sim.proto import referee_pb2, vision_pb2
            return vision_pb2, referee_pb2
    die("no generated messages found; run scripts/build release first or name their folder with --proto")
