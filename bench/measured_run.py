#!/usr/bin/python3
"""measured_run.py FIGURES LOG PROGRAM ARGUMENT...: runs a program. Its exit code, CPU seconds and peak memory become a
line of FIGURES, and its messages go to LOG. Processes that the program started and waited for count, too.

The kernel counts the memory of the process that starts another in the peak of the other. This process therefore stays
small: it imports no numpy."""
import json
import os
import sys

figures, log, *command = sys.argv[1:]
output = os.open(log, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o666)
process = os.posix_spawn(command[0], command, os.environ, file_actions=[(os.POSIX_SPAWN_DUP2, output, 1),
                                                                        (os.POSIX_SPAWN_DUP2, output, 2)])
_, status, usage = os.wait4(process, 0)
with open(figures, "a") as file:
    file.write(json.dumps({"exit": os.waitstatus_to_exitcode(status), "cpu_s": usage.ru_utime + usage.ru_stime,
                           "peak_mb": usage.ru_maxrss / 1024}) + "\n")
