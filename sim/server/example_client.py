#!/usr/bin/python3
"""Talks to a running ssl-sim as a team would: looks, teleports, drives, kicks, and prints what comes back.

    build/release/bin/ssl-sim --duration 10 &
    /usr/bin/python3 sim/server/example_client.py build/release/python
"""
import math
import socket
import struct
import sys
import time

sys.path.insert(0, sys.argv[1] if len(sys.argv) > 1 else "build/release/python")
from sim.proto import simulation_pb2 as simulation, vision_pb2 as vision  # noqa: E402

HOST = "127.0.0.1"
CONTROL, BLUE = (HOST, 10300), (HOST, 10301)


def vision_socket():
    s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    s.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    s.bind(("224.5.23.2", 10020))
    s.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, struct.pack("4s4s", socket.inet_aton("224.5.23.2"), socket.inet_aton(HOST)))
    s.settimeout(1)
    return s


def ask(to, message, answer):
    client.sendto(message.SerializeToString(), to)
    answer.ParseFromString(client.recv(65536))
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
        eyes.settimeout(1)
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        packet = vision.SSL_WrapperPacket.FromString(eyes.recv(65536))
        packets += 1
        for b in packet.detection.balls:
            ball = (round(b.x / 1000, 2), round(b.y / 1000, 2))
        for r in packet.detection.robots_blue:
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


client = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
client.settimeout(1)
eyes = vision_socket()

print("waiting for geometry, sent every 3 s")
while True:
    packet = vision.SSL_WrapperPacket.FromString(eyes.recv(65536))
    if packet.HasField("geometry"):
        break
field = packet.geometry.field
print(f"field {field.field_length} x {field.field_width} mm, {len(field.field_lines)} lines, {len(packet.geometry.calib)} cameras")
print("in one second: ball, blue 3, packets:", look(1))

print("teleport the ball to (1, 1), blue 3 to (0, 1) facing it")
command = simulation.SimulatorCommand()
command.control.teleport_ball.x, command.control.teleport_ball.y = 1, 1
robot = command.control.teleport_robot.add(x=0, y=1, orientation=0)
robot.id.id, robot.id.team = 3, simulation.BLUE
ask(CONTROL, command, simulation.SimulatorResponse())
print("  seen:", look(0.2))

print("drive forward at 1 m/s with the dribbler on, until the ball is there")


def forward(command):
    command.move_command.local_velocity.forward = 1
    command.move_command.local_velocity.left = command.move_command.local_velocity.angular = 0
    command.dribbler_speed = 5000


print("  answers with ball contact:", drive(1.2, forward))
print("  seen:", look(0.1))


def kick(command):
    command.move_command.global_velocity.x = command.move_command.global_velocity.y = 0
    command.move_command.global_velocity.angular = 0
    command.kick_speed = 4


print("kick at 4 m/s")
drive(0.1, kick)
first, _, _ = look(0.2)
second, _, _ = look(0.2)
print(f"  ball went from {first} to {second} in 0.2 s")

print("turn in place by the wheels: rims at 0.36 m/s are 0.36 / 0.09 = 4 rad/s")


def turn(command):
    wheels = command.move_command.wheel_velocity
    wheels.front_right = wheels.back_right = wheels.back_left = wheels.front_left = 0.36


_, before, _ = look(0.1)
drive(0.5, turn)
_, after, _ = look(0.1)
print(f"  heading from {before[2]} to {after[2]}; about 0.5 s of 4 rad/s")

print("what cannot be done is said, the rest is done")
command = simulation.SimulatorCommand()
command.control.teleport_ball.x = 99
command.control.simulation_speed = -1
robot = command.control.teleport_robot.add(present=True)
robot.id.id, robot.id.team = 9, simulation.YELLOW
command.config.vision_port = 10020
ask(CONTROL, command, simulation.SimulatorResponse())
client.sendto(b"\xff\xff\xff", CONTROL)
print("  to three bytes of nonsense:", simulation.SimulatorResponse.FromString(client.recv(65536)).errors[0].message)
