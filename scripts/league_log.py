"""Reads league logs for the scripts here."""
import gzip
import pathlib
import struct
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
VISION, REFEREE = 4, 3


def die(sentence):
    print(f"{pathlib.Path(sys.argv[0]).name}: {sentence}", file=sys.stderr)
    sys.exit(2)


def records(path):
    """Yields (seconds since the first record, type, payload) of an SSL log, version 1."""
    opened = gzip.open(path, "rb") if path.suffix == ".gz" else open(path, "rb")
    with opened as log:
        header = log.read(16)
        if header[:12] != b"SSL_LOG_FILE" or header[12:] != b"\0\0\0\1":
            die(f"{path}: not an SSL log file of version 1")
        first = None
        while True:
            head = log.read(16)
            if len(head) < 16:
                return
            time_ns, kind, size = struct.unpack(">qii", head)
            payload = log.read(size)
            if len(payload) < size:
                return
            first = time_ns if first is None else first
            yield (time_ns - first) / 1e9, kind, payload


def load_messages(folder):
    places = [pathlib.Path(folder)] if folder else sorted(ROOT.glob("build/*/python"))
    for place in places:
        if (place / "sim/proto/vision_pb2.py").exists():
            sys.path.insert(0, str(place))
            from sim.proto import referee_pb2, vision_pb2
            return vision_pb2, referee_pb2
    die("no generated messages found; run scripts/build release first or name their folder with --proto")
