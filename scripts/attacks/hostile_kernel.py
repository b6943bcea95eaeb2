"""What a team can do by way of the kernel: settings, control groups, keys; methods as in hostile_faults.py.

Nothing is changed where it succeeds: files are opened and not written, what is mounted goes with the team.
"""
import ctypes
import os
import platform
from pathlib import Path

REACHED = 98  # the code with which a team ends that could do it: no game ends so otherwise
NEW_USER, NEW_MOUNTS, NEW_GROUPS = 0x10000000, 0x20000, 0x02000000  # unshare(2)
SESSION = -3  # keyctl(2): KEY_SPEC_SESSION_KEYRING
ADD_KEY, REQUEST_KEY = (248, 249) if platform.machine() == "x86_64" else (217, 218)  # the second: arm64, riscv64


class Kernel:
    def reached(self, what):
        print("reached:", what, flush=True)
        os._exit(REACHED)

    def once_sets_sysctl(self, tick):
        """Root needs no capability for most of them; in core_pattern is a command that root runs."""
        for folder, _folders, files in os.walk("/proc/sys"):
            for name in files:
                try:
                    os.close(os.open(os.path.join(folder, name), os.O_WRONLY | os.O_NONBLOCK))
                except OSError:
                    continue
                self.reached(os.path.join(folder, name))

    def once_mounts_groups(self, tick):
        """Whoever may write a control group may end or freeze all in it: the host, too."""
        libc = ctypes.CDLL(None, use_errno=True)
        place = Path(os.environ.get("TMPDIR", "/tmp")) / "groups"
        try:
            place.mkdir(exist_ok=True)
        except OSError:
            return
        if libc.unshare(NEW_USER | NEW_MOUNTS | NEW_GROUPS) != 0:
            return
        if libc.mount(b"none", str(place).encode(), b"tmpfs", 0, b"size=4k") == 0:
            self.reached("a file system of its own")
        if libc.mount(b"none", str(place).encode(), b"cgroup2", 0, None) == 0:
            self.reached("control groups")

    def once_leaves_key(self, tick):
        """In the keyring of the session, where the next game's team would find it."""
        libc = ctypes.CDLL(None, use_errno=True)
        name = b"matchday-" + self.token.encode()
        if libc.syscall(REQUEST_KEY, b"user", name, None, 0) > 0:
            self.reached("a key of an earlier game")
        libc.syscall(ADD_KEY, b"user", name, b"x", ctypes.c_size_t(1), SESSION)
