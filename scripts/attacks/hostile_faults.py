"""What a team can do wrong on its own channel: silence, ends, lies, sizes, output.

The name of each method says when it comes: start_ (before it connects), connected_, hello_, tick_ (from tick AT on),
once_ (at tick AT), end_; then the mode. What it returns is sent instead of the usual message.
"""
import ctypes
import os
import signal
import socket
import time

from attacks.wire import delimited, floating, frame, number, text, varint

MIB = 1 << 20
ESCAPE = "\x1b]0;owned\x07\x1b[2J\x9b31m\r\n\u202e"
LARGEST_FRAME, LONGEST_NAME = 4096, 100  # [byte] sim/wire/team_limits.h
STANDS = 100  # the tick from which on a hostile team stands
F32 = float("nan"), float("inf"), 1e38


def drive(tick, speed=0.0, robots=range(6), more=b""):
    """RobotControl: a metre to the side at first, so that the team has moved; then they stand."""
    move = delimited(2, delimited(2, floating(1, speed) + floating(2, 0.6 if tick < STANDS else 0.0) + floating(3, 0.0)))
    return delimited(2, b"".join(delimited(1, number(1, robot) + move) for robot in robots) + more)


class Faults:
    # --- silent and slow, at every stage

    def hang(self, *_):
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
        while True:
            signal.pause()

    start_never_connects = connected_silent_at_hello = hello_silent_after_hello = once_silent = end_lingers = hang

    def start_slow_connect(self):
        time.sleep(2)

    def hello_slow_hello(self):
        time.sleep(2)

    def tick_slow_second(self, tick):
        time.sleep(1.1)  # under the 5 s of a reply, and yet the game would never end

    def tick_slow_ticks(self, tick):
        time.sleep(0.049)

    def tick_busy_ticks(self, tick):
        until = time.process_time() + 0.049
        while time.process_time() < until:
            pass

    def once_pauses(self, tick):
        time.sleep(1)

    def once_cut(self, tick):
        self.send(self.reply(tick)[:-3])
        self.hang()

    def once_drips(self, tick):
        for byte in self.reply(tick):
            self.send(bytes([byte]))
            time.sleep(0.5)

    def hello_half_hello(self):
        self.send(self.hello()[:-3])
        self.hang()

    def once_half_length(self, tick):
        self.send(b"\x80")
        self.hang()

    def once_vfork(self, tick):
        """The parent of a vfork waits in the kernel as for a disk, until the child runs another program: never."""
        if ctypes.PyDLL(None).vfork() == 0:
            self.hang()

    def once_stops_itself(self, tick):
        os.kill(os.getpid(), signal.SIGSTOP)

    def once_never_reads(self, tick):
        for later in range(tick, tick + 10_000):
            self.send(self.reply(later))
        self.hang()

    def hello_never_moves(self):
        self.still = True

    # --- ends, at every stage

    def crash(self, *_):
        os.kill(os.getpid(), signal.SIGSEGV)

    def leave(self, *_):
        os._exit(0)

    start_crash_at_start = connected_crash_connected = hello_crash_at_hello = once_crash = end_crash_at_end = crash
    start_exit_at_start = connected_exit_connected = hello_exit_at_hello = once_exit = leave

    def once_abort(self, tick):
        os.abort()

    def once_closes(self, tick):
        self.socket.close()
        self.hang()

    def once_shuts_writing(self, tick):
        self.socket.shutdown(socket.SHUT_WR)
        self.hang()

    def once_becomes_another(self, tick):
        os.execv("/bin/sleep", ["sleep", "1000"])

    # --- lies and nonsense

    def once_nonsense(self, tick):
        return frame(os.urandom(200))

    def once_noise(self, tick):
        return os.urandom(5000)

    def once_old_tick(self, tick):
        return self.reply(tick - 1)

    def once_next_tick(self, tick):
        return self.reply(tick + 1)

    def once_least_tick(self, tick):
        return self.reply(-(2**63))

    def once_greatest_tick(self, tick):
        return self.reply(2**63 - 1)

    def once_two_replies(self, tick):
        return self.reply(tick) * 2

    def once_no_reply(self, tick):
        return frame(b"")

    def once_hello_again(self, tick):
        return self.hello()

    def connected_reply_first(self):
        self.send(self.reply(0))

    def hello_old_version(self):
        return self.hello(version=0)

    def hello_new_version(self):
        return self.hello(version=2**31)

    def hello_bad_keeper(self):
        return self.hello(keeper=99)

    def hello_great_keeper(self):
        return self.hello(keeper=2**32 - 1)

    def tick_not_numbers(self, tick):
        if tick < STANDS:
            return None  # it has moved first
        return self.reply(tick, drive(tick, F32[tick % 3]))

    def tick_no_such_robots(self, tick):
        return self.reply(tick, drive(tick, robots=(0, 7, 15, 16, 255, 2**32 - 1)))

    def tick_requests(self, tick):
        wish = (number(1, 1), number(2, 1), number(3, 2**32 - 1), number(4, 2**32 - 1), number(3, tick % 6))[tick % 5]
        return self.reply(tick, more=delimited(4, wish))

    # --- sizes

    def hello_great_name(self):
        return self.hello(name="n" * 1_000_000)

    def hello_escape_name(self):
        return self.hello(name=ESCAPE, more=text(3, ESCAPE))

    def hello_backtick_name(self):
        return self.hello(name="`touch owned`$(touch owned)';touch owned;'", more=text(3, "\"`touch owned`"))

    def hello_bidi_name(self):
        return self.hello(name="\u202eevil\u2066", more=text(3, "\u202e1.0"))

    def hello_longest_name(self):
        return self.hello(name="n" * LONGEST_NAME, more=text(3, "v" * LONGEST_NAME))

    def hello_long_name(self):
        return self.hello(name="n" * (LONGEST_NAME + 1))

    def hello_name_of_100_kb(self):
        return self.hello(name="n" * 100_000)

    def hello_no_utf8_name(self):
        return self.hello(name=b"\xff\xfe\xc0\x80")

    def tick_great_notes(self, tick):
        return self.reply(tick, more=text(3, "n" * 1_000_000))

    def tick_unknown_fields(self, tick):
        return self.reply(tick, more=delimited(77, bytes(1_000_000)))

    def tick_empty_commands(self, tick):
        return self.reply(tick, drive(tick, more=delimited(1, b"") * 400_000))

    def tick_same_robot(self, tick):
        return self.reply(tick, drive(tick, robots=[0] * 30_000))

    def of_size(self, size, message):
        """The message with an unknown field after it, so that its payload has that many bytes."""
        payload = message[1 if message[0] < 0x80 else 2:]
        return frame(payload + delimited(77, bytes(size - len(payload) - 4)))  # two bytes of key, two of length

    def tick_largest_frame(self, tick):
        return self.of_size(LARGEST_FRAME, self.reply(tick))

    def tick_just_too_large(self, tick):
        return self.of_size(LARGEST_FRAME + 1, self.reply(tick))

    def hello_too_large_hello(self):
        return self.of_size(LARGEST_FRAME + 1, self.hello())

    def once_too_large(self, tick):
        return varint(2 * MIB) + bytes(2 * MIB)

    def once_greatest_length(self, tick):
        return b"\xff" * 9 + b"\x01" + bytes(1000)

    def once_endless_length(self, tick):
        return b"\x80" * 5000

    def once_groups(self, tick):
        return frame(varint(77 << 3 | 3) * 100_000)  # groups in groups

    def once_flood(self, tick):
        while True:
            self.send(self.reply(tick))

    def once_flood_of_nothing(self, tick):
        while True:
            self.send(bytes(4096))

    # --- output

    def tick_prints(self, tick):
        os.write(1, b"." * 100_000)

    def tick_gigabytes(self, tick):
        for _ in range(16):
            os.write(1, b"." * MIB)

    def once_prints_escapes(self, tick):
        os.write(2, ESCAPE.encode() * 100)
        self.crash()

    def once_long_line(self, tick):
        os.write(2, b"x" * 5 * MIB)
        self.crash()

    def start_closes_output(self):
        os.close(1)
        os.close(2)
