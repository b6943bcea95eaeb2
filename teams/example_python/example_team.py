#!/usr/bin/python3
"""A whole team in one file: the robot nearest to the ball goes behind it and kicks it at the goal.

It speaks to the host over the Unix socket named by MATCHDAY_SOCKET; each message is a varint length and then that
many bytes of protobuf (sim/proto/match.proto). Only the standard library and Debian's python3-protobuf are used.
"""
import argparse
import math
import os
import pathlib
import socket
import sys


def find_messages():
    """Puts the generated modules on the path: MATCHDAY_PROTO_PATH, or build/release/python of a folder above."""
    here = pathlib.Path(__file__).resolve()
    places = [os.environ.get("MATCHDAY_PROTO_PATH")]
    places += [folder / "build/release/python" for folder in here.parents]  # of the checkout it lies in
    for place in places:
        if place and (pathlib.Path(place) / "sim/proto/match_pb2.py").exists():
            sys.path.insert(0, str(place))
            return
    sys.exit("team-example-python: no sim/proto/match_pb2.py found; set MATCHDAY_PROTO_PATH to build/release/python of a "
             "built Matchday checkout")


class Channel:
    """Frames over a stream socket."""

    def __init__(self, path):
        self.socket = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        self.socket.connect(path)
        self.stream = self.socket.makefile("rb")

    def read(self):
        """The next payload, or None when the host closed the channel."""
        size = shift = 0
        while True:
            byte = self.stream.read(1)
            if not byte:
                return None
            size |= (byte[0] & 0x7F) << shift
            shift += 7
            if byte[0] < 0x80:
                return self.stream.read(size)

    def write(self, message):
        payload = message.SerializeToString()
        size, header = len(payload), bytearray()
        while size >= 0x80:
            header.append(size & 0x7F | 0x80)
            size >>= 7
        header.append(size)
        self.socket.sendall(bytes(header) + payload)


def wrap(angle):
    return math.atan2(math.sin(angle), math.cos(angle))


class Team:
    """Positions in metres; flipped so that our own goal is always the one at -x."""

    def __init__(self, hello):
        self.blue = hello.color == simulation_pb2.BLUE
        self.half_length = hello.geometry.field.field_length / 2000
        self.half_width = hello.geometry.field.field_width / 2000
        self.limit = {s.id.id: (s.limits.vel_absolute_max or 3.0) for s in hello.robot_specs}
        self.ball = (0.0, 0.0)
        self.robots = {}  # number -> (x, y, heading), ours
        self.command = None
        self.ours = self.moved = False
        self.restart_ball = (0.0, 0.0)

    def look(self, tick):
        """Takes in what the cameras and the referee say."""
        referee = tick.referee
        flip = -1.0 if self.blue == referee.blue_team_on_positive_half else 1.0
        for packet in tick.packets:
            detection = packet.detection
            for ball in detection.balls:
                self.ball = (flip * ball.x / 1000, flip * ball.y / 1000)
            for robot in detection.robots_blue if self.blue else detection.robots_yellow:
                heading = robot.orientation if flip > 0 else wrap(robot.orientation + math.pi)
                self.robots[robot.robot_id] = (flip * robot.x / 1000, flip * robot.y / 1000, heading)
        if self.command != (referee.command, referee.command_counter):
            self.command = (referee.command, referee.command_counter)
            name = referee_pb2.Referee.Command.Name(referee.command)
            if name.endswith(("YELLOW", "BLUE")):
                self.ours = name.endswith("BLUE") == self.blue
            self.moved = False
            self.restart_ball = self.ball
        if math.dist(self.ball, self.restart_ball) > 0.05:
            self.moved = True  # the kick is taken: the ball is in play

    def may_play(self):
        name = referee_pb2.Referee.Command.Name(self.command[0])
        if name == "FORCE_START":
            return True
        return name.startswith(("NORMAL_START", "DIRECT", "INDIRECT")) and (self.ours or self.moved)

    def play(self, control):
        """Fills in the commands of this tick."""
        name = referee_pb2.Referee.Command.Name(self.command[0])
        if name == "HALT" or not self.robots:
            return
        playing = self.may_play()
        chaser = min(self.robots, key=lambda n: math.dist(self.robots[n][:2], self.ball))
        for place, (number, pose) in enumerate(sorted(self.robots.items())):
            if number == chaser and playing:
                self.chase(control, number, pose)
            else:
                share = (place + 1) / (len(self.robots) + 1)
                target = (-self.half_length / 2, (2 * share - 1) * self.half_width)
                if not playing:
                    target = self.away_from_ball(target)
                self.drive(control, number, pose, target, self.direction(pose, self.ball), slow=self.stopped(name))

    @staticmethod
    def stopped(name):
        """After a goal the command stays GOAL until the next kickoff is prepared; it means the same as STOP."""
        return name == "STOP" or name.startswith("GOAL")

    def away_from_ball(self, point):
        distance = max(math.dist(point, self.ball), 1e-3)
        if distance > 0.75:
            return point
        return tuple(b + (p - b) * 0.75 / distance for p, b in zip(point, self.ball))

    @staticmethod
    def direction(pose, point):
        return math.atan2(point[1] - pose[1], point[0] - pose[0])

    def chase(self, control, number, pose):
        """Behind the ball, looking at their goal; then through it."""
        aim = math.atan2(-self.ball[1], self.half_length - self.ball[0])
        ahead = (self.ball[0] - pose[0]) * math.cos(aim) + (self.ball[1] - pose[1]) * math.sin(aim)
        beside = -(self.ball[0] - pose[0]) * math.sin(aim) + (self.ball[1] - pose[1]) * math.cos(aim)
        lined_up = ahead > 0.05 and abs(beside) < 0.04 and abs(wrap(aim - pose[2])) < 0.15
        gap = 0.0 if lined_up else 0.2
        side = 0.0 if ahead > 0 or abs(beside) > 0.2 else math.copysign(0.25, -beside)  # round the ball
        target = (self.ball[0] - gap * math.cos(aim) - side * math.sin(aim),
                  self.ball[1] - gap * math.sin(aim) + side * math.cos(aim))
        command = self.drive(control, number, pose, target, aim, slow=False)
        if lined_up:
            command.kick_speed = 6.0
            command.dribbler_speed = 1000

    def drive(self, control, number, pose, target, heading, slow):
        """Towards a point, slower when near; the speed is told in the robot's frame."""
        limit = min(1.4 if slow else 2.0, self.limit.get(number, 2.0))
        dx, dy = target[0] - pose[0], target[1] - pose[1]
        distance = math.hypot(dx, dy)
        speed = min(limit, 2.5 * distance)
        angle = math.atan2(dy, dx) - pose[2]
        command = control.robot_commands.add(id=number)
        velocity = command.move_command.local_velocity
        velocity.forward = speed * math.cos(angle)
        velocity.left = speed * math.sin(angle)
        velocity.angular = max(-6.0, min(6.0, 5.0 * wrap(heading - pose[2])))
        return command


def main():
    parser = argparse.ArgumentParser(prog="team-example-python", description="The example team in Python.")
    _, unknown = parser.parse_known_args()
    if unknown:
        print(f"team-example-python: unknown argument {unknown[0]} (see --help)", file=sys.stderr)
        return 2
    path = os.environ.get("MATCHDAY_SOCKET")
    if not path:
        print("team-example-python: MATCHDAY_SOCKET is not set; a host starts this program, "
              "for example: matchday play --blue team-example-python", file=sys.stderr)
        return 2
    channel = Channel(path)
    team = None
    while True:
        payload = channel.read()
        if payload is None:
            print("team-example-python: the host closed the channel without a goodbye", file=sys.stderr)
            return 1
        message = match_pb2.HostMessage.FromString(payload)
        answer = match_pb2.TeamMessage()
        kind = message.WhichOneof("message")
        if kind == "hello":
            team = Team(message.hello)
            answer.hello.protocol_version = 1
            answer.hello.name = "example"
            answer.hello.keeper = min(message.hello.robots)
        elif kind == "tick":
            team.look(message.tick)
            answer.reply.tick = message.tick.tick
            answer.reply.control.SetInParent()
            team.play(answer.reply.control)
        else:  # goodbye
            return 0
        channel.write(answer)


if __name__ == "__main__":
    if not {"-h", "--help"} & set(sys.argv[1:]):
        find_messages()
        from sim.proto import match_pb2, referee_pb2, simulation_pb2  # noqa: E402
    sys.exit(main())
