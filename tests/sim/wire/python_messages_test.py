"""The Python modules of our messages import, and speak the same bytes as the descriptions say."""
import sys

sys.path.insert(0, sys.argv[1])
from sim.proto import legacy2014_pb2, match_pb2, referee_pb2, simulation_custom_pb2, simulation_pb2, tracker_pb2, vision_pb2  # noqa: E402, F401

reply = match_pb2.TeamMessage()
reply.reply.tick = 3
assert reply.SerializeToString() == b"\x12\x02\x08\x03", reply.SerializeToString()
assert match_pb2.TeamMessage.FromString(b"\x12\x02\x08\x03").WhichOneof("message") == "reply"
