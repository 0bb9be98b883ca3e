"""Small file systems in memory. Needs root, or the right to unshare."""

import os
import subprocess


def cannot_mount():
    """Why not; empty where it can."""
    if os.geteuid() != 0:
        return "a file system is mounted by root alone; try unshare -rm"
    place = "/tmp"
    tried = subprocess.run(["unshare", "-m", "mount", "-t", "tmpfs", "none", place],
                           capture_output=True, text=True, check=False)
    return tried.stderr.strip() if tried.returncode else ""


class SmallDisk:
    """A tmpfs with so many kB free behind the files that it is given."""

    def __init__(self, space, free_kB, files=()):
        self.path = os.path.join(space.scratch, "disk")
        self.free_kB = free_kB
        self.files = files  # pairs of name and bytes

    def __enter__(self):
        os.makedirs(self.path, exist_ok=True)
        page_kB = os.sysconf("SC_PAGE_SIZE") // 1024
        taken_kB = sum(-(-len(content) // (1024 * page_kB)) * page_kB for _, content in self.files)
        size_kB = taken_kB + self.free_kB + page_kB  # a size of 0 would be no bound
        subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size_kB}k", "none", self.path],
                       check=True)
        try:
            for name, content in self.files:
                with open(os.path.join(self.path, name), "wb") as file:
                    file.write(content)
            with open(os.path.join(self.path, "filler"), "wb") as file:
                file.write(b"x" * (1024 * page_kB))
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        subprocess.run(["umount", self.path], check=True)
