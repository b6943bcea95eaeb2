#!/usr/bin/python3
"""Talks to a running ssl-sim as a team would: looks, teleports, drives, kicks, and prints what comes back.

    build/release/bin/ssl-sim --duration 12 &
    sim/server/example_client.py

It expects the usual ports on 127.0.0.1. It needs a build: build/<preset>/python holds the generated messages.
"""
import argparse
import pathlib
import socket
import struct
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
HOST = "127.0.0.1"
CONTROL, BLUE = (HOST, 10300), (HOST, 10301)
VISION = ("224.5.23.2", 10020)


def die(sentence):
    print(f"example_client.py: {sentence}", file=sys.stderr)
    sys.exit(2)


def load_messages(folder):
    places = [folder] if folder else sorted(ROOT.glob("build/*/python"))
    for place in places:
        if (place / "sim/proto/simulation_pb2.py").exists():
            sys.path.insert(0, str(place))
            from sim.proto import simulation_pb2, vision_pb2
            return simulation_pb2, vision_pb2
    die(f"no generated messages in {folder or ROOT / 'build/*/python'}; run scripts/build release ssl-sim first, or name their folder")


def vision_socket():
    s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    s.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    s.bind(VISION)
    s.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, struct.pack("4s4s", socket.inet_aton(VISION[0]), socket.inet_aton(HOST)))
    s.settimeout(4)
    return s


def packet():
    """The next packet from the cameras."""
    try:
        return vision.SSL_WrapperPacket.FromString(eyes.recv(65536))
    except TimeoutError:
        die(f"nothing came from {VISION[0]}:{VISION[1]} for 4 s: has ssl-sim ended, or is it paused?")


def answer_to(to, data, answer):
    client.sendto(data, to)
    try:
        answer.ParseFromString(client.recv(65536))
    except TimeoutError:
        die(f"no answer from {to[0]}:{to[1]}: no ssl-sim is running there; start build/release/bin/ssl-sim first")
    return answer


def ask(to, message, answer):
    answer_to(to, message.SerializeToString(), answer)
    for error in answer.errors:
        print(f"  error {error.code}: {error.message}")
    return answer


def look(seconds):
    """The last seen places [m] of the ball and of blue robot 3, and how many packets came."""
    ball = robot = None
    packets = 0
    eyes.setblocking(False)
    try:
        while eyes.recv(65536):  # what came while we did not look
            pass
    except BlockingIOError:
        eyes.settimeout(4)
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        frame = packet().detection
        packets += 1
        for b in frame.balls:
            ball = (round(b.x / 1000, 2), round(b.y / 1000, 2))
        for r in frame.robots_blue:
            if r.robot_id == 3:
                robot = (round(r.x / 1000, 2), round(r.y / 1000, 2), round(r.orientation, 2))
    return ball, robot, packets


def drive(seconds, fill):
    """Sends blue robot 3 a command every 1/60 s; returns the number of answers that reported ball contact."""
    contacts = 0
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        control = simulation.RobotControl()
        command = control.robot_commands.add(id=3)
        fill(command)
        answer = ask(BLUE, control, simulation.RobotControlResponse())
        contacts += any(f.id == 3 and f.dribbler_ball_contact for f in answer.feedback)
        time.sleep(1 / 60)
    return contacts


def forward(command):
    command.move_command.local_velocity.forward = 1
    command.move_command.local_velocity.left = command.move_command.local_velocity.angular = 0
    command.dribbler_speed = 5000


def kick(command):
    command.move_command.global_velocity.x = command.move_command.global_velocity.y = 0
    command.move_command.global_velocity.angular = 0
    command.kick_speed = 4


def turn(command):
    wheels = command.move_command.wheel_velocity
    wheels.front_right = wheels.back_right = wheels.back_left = wheels.front_left = 0.36


def main():
    ask(CONTROL, simulation.SimulatorCommand(), simulation.SimulatorResponse())  # is anybody there?
    print("waiting for geometry, sent every 3 s")
    while not (seen := packet()).HasField("geometry"):
        pass
    field = seen.geometry.field
    print(f"field {field.field_length} x {field.field_width} mm, {len(field.field_lines)} lines, {len(seen.geometry.calib)} cameras")
    print("in one second: ball, blue 3, packets:", look(1))

    print("teleport the ball to (1, 1), blue 3 to (0, 1) facing it")
    command = simulation.SimulatorCommand()
    command.control.teleport_ball.x, command.control.teleport_ball.y = 1, 1
    robot = command.control.teleport_robot.add(x=0, y=1, orientation=0, present=True)
    robot.id.id, robot.id.team = 3, simulation.BLUE
    ask(CONTROL, command, simulation.SimulatorResponse())
    print("  seen:", look(0.2))

    print("drive forward at 1 m/s with the dribbler on, until the ball is there")
    print("  answers with ball contact:", drive(1.2, forward))
    print("  seen:", look(0.1))

    print("kick at 4 m/s")
    drive(0.1, kick)
    first, _, _ = look(0.2)
    second, _, _ = look(0.2)
    print(f"  ball went from {first} to {second} in 0.2 s")

    print("turn in place by the wheels: rims at 0.36 m/s are 0.36 / 0.09 = 4 rad/s")
    _, before, _ = look(0.1)
    drive(0.5, turn)
    _, after, _ = look(0.1)
    if before and after:
        print(f"  heading from {before[2]} to {after[2]}; about 0.5 s of 4 rad/s")

    print("what cannot be done is said, the rest is done")
    command = simulation.SimulatorCommand()
    command.control.teleport_ball.x = 99
    command.control.simulation_speed = -1
    robot = command.control.teleport_robot.add(present=True)
    robot.id.id, robot.id.team = 9, simulation.YELLOW
    command.config.vision_port = VISION[1]
    ask(CONTROL, command, simulation.SimulatorResponse())
    nonsense = answer_to(CONTROL, b"\xff\xff\xff", simulation.SimulatorResponse())
    print("  to three bytes of nonsense:", nonsense.errors[0].message)


parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("messages", type=pathlib.Path, nargs="?", help="folder that holds sim/proto/simulation_pb2.py; default: of the first build found")
simulation, vision = load_messages(parser.parse_args().messages)
client = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
client.settimeout(1)
eyes = vision_socket()
main()
