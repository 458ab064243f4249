"""Runs the program with which the package is compared, and reads its files."""

import os
import subprocess

import numpy as np


def run_program(*arguments):
    """Runs the program and returns the finished process. The test checks its exit code and output."""
    return subprocess.run([os.environ["FORAMEN_PROGRAM"], *map(os.fspath, arguments)], capture_output=True, text=True)


def ply_properties(path):
    """The float properties of a PLY file's vertices, by name."""
    header, _, body = path.read_bytes().partition(b"end_header\n")
    lines = header.decode().splitlines()
    count = next(int(line.split()[2]) for line in lines if line.startswith("element vertex"))
    names = [line.split()[2] for line in lines if line.startswith("property float")]
    return dict(zip(names, np.frombuffer(body, "<f4", count * len(names)).reshape(count, -1).T))
