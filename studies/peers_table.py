"""The table of peers.sh: one row for each NAME=METRICS_FILE=FOLDER."""

import argparse
import json
import pathlib
import sys


def number(value, digits):
    return "-" if value is None else f"{value:.{digits}f}"


def with_error(figure, digits):
    """A mean with its standard error, which two subjects do not have."""
    error = figure.get("standard_error")
    return number(figure["mean"], digits) + (f" ± {error:.{digits}f}" if error is not None else "")


def seconds_of(folder):
    """The computing time of a model's shape registration and landmarks, or what another tool's folder says."""
    record = folder / "run.json"
    if record.exists():
        stages = json.loads(record.read_text())["seconds_by_stage"]
        return sum(stages[name] for name in ("reference", "register", "resample"))
    note = folder / "seconds.txt"
    return float(note.read_text()) if note.exists() else None


def cells(metrics, folder, groups):
    marks, regions, lies = metrics.get("marks"), metrics.get("regions"), metrics["representation"]
    row = []
    for kind in ("points", "curves"):
        figure = marks.get(kind) if marks else None
        row += [with_error(figure, 2), number(figure["p95"], 2)] if figure else ["-", "-"]
    by_curve = {c["mark"]: c["mean"] for c in (marks or {}).get("by_curve", [])}
    for group in groups:
        means = [mean for name, mean in by_curve.items() if name.startswith(group)]
        row.append(number(sum(means) / len(means) if means else None, 2))
    row.append(with_error(regions["dice"], 4) if regions else "-")
    row += [number(lies[measure]["mean"], 3) for measure in ("mean_mm", "hausdorff_mm")]
    row += [number(lies[measure]["mean"], 2) for measure in ("plain_flips", "confirmed_flips")]
    shapes = lies["shapes"]
    beyond = [max(0, s["self_intersections"] - s["input_self_intersections"]) for s in shapes]
    return row + [number(sum(beyond) / len(beyond), 2), number(seconds_of(folder), 0)]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--groups", default="")
    parser.add_argument("rows", nargs="+")
    args = parser.parse_args()
    groups = args.groups.split()

    print("mm and Dice coefficients, ± standard error over subjects where there are three; flipped triangles and pairs of")
    print("crossing triangles beyond the input's, each a shape; seconds of the correspondence and its landmarks\n")
    heads = ["correspondence", "points mean", "p95", "curves mean", "p95", *groups, "regions", "to the shape: mean",
             "Hausdorff", "flips", "confirmed", "crossing", "s"]
    print("| " + " | ".join(heads) + " |")
    print("|" + " --- |" * len(heads))
    landmarks = {}
    for row in args.rows:
        name, file, folder = row.split("=", 2)
        metrics = json.loads(pathlib.Path(file).read_text())
        landmarks[name] = metrics["landmarks"]
        print("| " + " | ".join([name, *cells(metrics, pathlib.Path(folder), groups)]) + " |")
    if len(set(landmarks.values())) > 1:
        counts = ", ".join(f"{name} {count}" for name, count in landmarks.items())
        sys.exit(f"\nThe numbers of landmarks differ, so the rows do not compare: {counts}")


if __name__ == "__main__":
    main()
