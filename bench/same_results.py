#!/usr/bin/python3
"""Parts of same_results.sh that are not shell code: cuts a part out of a surface, and reports the differences between
the outputs of two programs and between their time and memory."""
import argparse
import csv
import json
import sys
from pathlib import Path

import numpy as np

from compare_results import FACE, compare, group_of, left_out, read_ply

# Files and folders of a model whose bytes must be the same. Of other commands, all files must be the same.
JUDGED_OF_MODEL = {"model.h5", "mean.ply", "corresponding", "scores.csv", "metrics.csv"}


def cut(source, target):
    """Writes the front of a vertebra without its posterior elements, as an open surface. Everything behind the middle
    of its extent (larger y) is removed."""
    surface = read_ply(source)
    corners = surface.corners()
    y = surface.points[:, 1]
    kept = corners[(y[corners] < (y.min() + y.max()) / 2).all(axis=1)]
    used, renumbered = np.unique(kept, return_inverse=True)
    faces = np.empty(len(kept), FACE)
    faces["count"], faces["corners"] = 3, renumbered.reshape(-1, 3)
    header = (f"ply\nformat binary_little_endian 1.0\ncomment SPACE=LPS\nelement vertex {len(used)}\nproperty float x\n"
              f"property float y\nproperty float z\nelement face {len(kept)}\n"
              "property list uchar int vertex_indices\nend_header\n")
    target.write_bytes(header.encode() + surface.points[used].astype("<f4").tobytes() + faces.tobytes())


def least(figures):
    """The smallest CPU time and peak memory of several runs, and an exit code other than 0 if any run had one."""
    runs = [json.loads(line) for line in figures.read_text().splitlines()]
    return {"exit": max((run["exit"] for run in runs), key=abs), "cpu_s": min(run["cpu_s"] for run in runs),
            "peak_mb": min(run["peak_mb"] for run in runs)}


class Report:
    """Prints the differences, and collects the reasons for which the two sides are not accepted as the same."""

    def __init__(self, options):
        self.options = options
        self.results = []  # results that differ more than allowed
        self.costs = []    # costs that grew more than allowed
        self.details = []
        self.compared = 0

    def job(self, folder):
        """Prints a job's row of the table."""
        if (folder / "skipped").exists():
            self.row(folder.name, "skipped: " + (folder / "skipped").read_text().strip(), *[""] * 6)
            return
        self.compared += 1
        old, new = least(folder / "old.figures"), least(folder / "new.figures")
        for side, run in (("old", old), ("new", new)):
            if run["exit"] != 0:
                said = (folder / f"{side}.log").read_text().strip().splitlines()[-1:] or ["no message"]
                self.results.append(f"{folder.name}: {side} ended with exit code {run['exit']}: {said[0]}")
        found = compare(folder / "old", folder / "new", self.options.versions)
        self.judge_files(folder, found)
        cpu, memory = new["cpu_s"] / old["cpu_s"], new["peak_mb"] / old["peak_mb"]
        for what, ratio, bound in (("CPU", cpu, self.options.cpu), ("memory", memory, self.options.memory)):
            if bound and ratio > bound:
                self.costs.append(f"{folder.name}: {what} times {ratio:.3f}, more than {bound:g}")
        shift = "not comparable" if self.lost(found) else f"{self.largest_shift(found):.3g}"
        self.row(folder.name, self.outcome(found), shift, f"{old['cpu_s']:.1f}",
                 f"{new['cpu_s']:.1f}", f"{cpu:.3f}", f"{old['peak_mb']:.0f}", f"{memory:.3f}")

    @staticmethod
    def row(*cells):
        print("| " + " | ".join(cells) + " |", flush=True)

    @staticmethod
    def judged(found, names):
        return [name for name in names if group_of(name) in JUDGED_OF_MODEL or "model.h5" not in found.counts]

    def lost(self, found):
        """The reasons for which points of the checked files cannot be compared, as text."""
        judged = {why: self.judged(found, names) for why, names in found.lost.items()}
        return [f"{why}: {found.listed(names)}" for why, names in judged.items() if names]

    def largest_shift(self, found):
        return max((mm for mm, name in found.shifts if self.judged(found, [name])), default=0.0)

    def outcome(self, found):
        if not found.counts:
            return "nothing written"
        judged = self.judged(found, found.differing)
        others = [name for name in found.differing if name not in judged]
        text = "differs: " + found.listed(judged) if judged else "same bytes"
        if found.version_only:
            text += "; but for the version the same: " + ", ".join(found.version_only)
        return text + ("; not judged, differs: " + found.listed(others) if others else "")

    def judge_files(self, folder, found):
        reasons = self.lost(found)
        judged = self.judged(found, found.differing)
        shift = self.largest_shift(found)
        out = [left_out(folder / side) for side in ("old", "new")]
        if not found.counts:
            reasons.append("no files to compare")
        if out[0].keys() != out[1].keys():
            reasons.append(f"left out by old: {out[0] or 'none'}; by new: {out[1] or 'none'}")
        if self.options.shift == 0 and judged:
            reasons.append(f"other bytes: {found.listed(judged)}")
        if shift > self.options.shift:
            reasons.append(f"a point moved by {shift:.3g} mm")
        self.results += [f"{folder.name}: {reason}" for reason in reasons]
        if found.differing:
            self.details.append((folder, found))

    def detail(self, folder, found):
        """Prints how a job's files differ, and writes all changed numbers to changed.csv."""
        print(f"\n{folder.name}\n")
        largest = {}
        for mm, name in found.shifts:
            largest.setdefault(group_of(name), []).append((mm, name))
        for group, shifts in largest.items():
            mm, name = max(shifts)
            print(f"- largest shift of a point in {group}: {mm:.3g} mm" + (f" ({name})" if name != group else ""))
        for text in [f"{why}: {found.listed(names)}" for why, names in found.lost.items()] + found.notes:
            print(f"- {text}")
        for name, (count, changed) in found.numbers.items():
            print(f"- {name}: {len(changed)} of {count} numbers changed")
        changed = [change for _, listed in found.numbers.values() for change in listed]
        with open(folder / "changed.csv", "w", newline="") as file:
            csv.writer(file).writerows([["file", "name", "old", "new", "relative"]] +
                                       [[c.file, c.name, c.old, c.new, c.relative] for c in changed])
        worst = [change for change in changed if change.file.endswith(".json")][:self.options.worst]
        if worst:
            print("\n| the most changed | old | new | relative difference |\n| --- | --- | --- | --- |")
        for c in worst:
            self.row(f"{c.file} {c.name}", str(c.old), str(c.new), f"{c.relative:.2g}" if c.relative < np.inf else "")

    def verdict(self):
        """Prints the details and then the reasons for which the two sides are not accepted. Returns the exit code."""
        for detail in self.details:
            self.detail(*detail)
        print()
        if self.compared == 0:
            self.results.append("no job was run")
        for what, reasons in (("results", self.results), ("CPU and memory", self.costs)):
            print(f"{what}: " + ("not within the bounds" if reasons else "within the bounds"))
            for reason in reasons:
                print(f"- {reason}")
        return 1 if self.results or self.costs else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    command = commands.add_parser("cut")
    command.add_argument("source", type=Path)
    command.add_argument("target", type=Path)
    command = commands.add_parser("report")
    command.add_argument("folder", type=Path)
    command.add_argument("jobs", nargs="+")
    command.add_argument("--versions", nargs=2, required=True)
    command.add_argument("--worst", type=int, default=12)
    for bound in ("shift", "cpu", "memory"):
        command.add_argument(f"--{bound}", type=float, default=0)
    options = parser.parse_args()
    if options.command == "cut":
        cut(options.source, options.target)
    else:
        report = Report(options)
        report.row("job", "files", "largest shift, mm", "CPU old, s", "new", "ratio", "peak old, MB", "ratio")
        report.row(*["---"] * 8)
        for job in options.jobs:
            report.job(options.folder / job)
        sys.exit(report.verdict())


if __name__ == "__main__":
    main()
