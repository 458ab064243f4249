"""Differences between the files of two output folders: distances of points, numbers by name, HDF5 by dataset."""
import csv
import json
from dataclasses import dataclass, field

import h5py
import numpy as np

# These files contain the times of a run.
TIMED = {"run.json", "report.html"}
# The number of differences that are printed for each HDF5 file.
MOST_NOTES = 8


FACE = np.dtype([("count", "u1"), ("corners", "<i4", 3)])


def group_of(name):
    return name.split("/")[0]


@dataclass
class Surface:
    points: np.ndarray
    scalars: dict
    faces: bytes

    def corners(self):
        """The vertices of every triangle."""
        return np.frombuffer(self.faces, FACE)["corners"]


def read_ply(path):
    """Reads a surface in the form of foramen's files and of the real data: little endian, vertices first, all
    properties float."""
    content = path.read_bytes()
    header, _, body = content.partition(b"end_header\n")
    lines = [line.split() for line in header.decode().splitlines()]
    if ["format", "binary_little_endian", "1.0"] not in lines:
        raise ValueError(f"{path}: only little endian binary PLY is read here")
    vertices = next(int(line[2]) for line in lines if line[:2] == ["element", "vertex"])
    names = [line[2] for line in lines if line[:2] == ["property", "float"]]
    table = np.frombuffer(body, "<f4", vertices * len(names)).reshape(vertices, len(names)).astype(float)
    columns = dict(zip(names, table.T))
    points = np.column_stack([columns.pop(axis) for axis in "xyz"])
    return Surface(points, columns, body[vertices * len(names) * 4:])


def flattened(value, path=""):
    """Every number and text of a JSON value by its path. The path names an element of an array by its name or number of
    modes if it has one."""
    if isinstance(value, dict):
        return {k: v for key, item in value.items() for k, v in flattened(item, f"{path}/{key}").items()}
    if isinstance(value, list):
        names = [next((item[key] for key in ("name", "shape", "modes") if key in item), i)
                 if isinstance(item, dict) else i for i, item in enumerate(value)]
        if len(set(map(str, names))) < len(names):
            names = range(len(value))
        return {k: v for name, item in zip(names, value) for k, v in flattened(item, f"{path}/{name}").items()}
    return {path[1:]: value}


def csv_numbers(path):
    """The numbers of a table. With a column `value`, these are its values by the other cells of their rows; otherwise
    all numbers by row and column."""
    with open(path, newline="") as file:
        header, *rows = csv.reader(file)
    if "value" in header:
        at = header.index("value")
        return {"/".join(row[:at] + row[at + 1:]): number_or_text(row[at]) for row in rows}
    return {f"{row[0]}/{name}": number_or_text(cell) for row in rows for name, cell in zip(header[1:], row[1:])}


def number_or_text(text):
    try:
        return float(text)
    except ValueError:
        return text


def h5_contents(path):
    """Every dataset and attribute by its path."""
    contents = {}
    with h5py.File(path) as file:
        def visit(name, item):
            contents.update({f"{name}@{key}": np.asarray(value) for key, value in item.attrs.items()})
            if isinstance(item, h5py.Dataset):
                contents[name] = np.asarray(item[()])
        visit("", file)
        file.visititems(visit)
    return contents


def array_difference(old, new, versions):
    """The difference of a dataset as text; None if only the version of foramen in it differs."""
    if old is None or new is None:
        return f"is only in {'new' if old is None else 'old'}"
    if old.shape != new.shape or old.dtype.kind != new.dtype.kind:
        return f"is {new.dtype} {new.shape}, was {old.dtype} {old.shape}"
    if old.dtype.kind not in "iuf":
        same = str(old.tolist()).replace(*versions) == str(new.tolist())
        return "" if same else f"is {new.tolist()}, was {old.tolist()}"
    if old.dtype == new.dtype and old.tobytes() == new.tobytes():
        return ""
    largest = np.abs(old.astype(float) - new).max(initial=0)
    return f"differs by {largest:.3g} at most, of {np.abs(old).max(initial=0):.3g}"


@dataclass
class Change:
    file: str
    name: str
    old: object
    new: object
    relative: float  # infinite if it exists on one side only, or is a text


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def changes(file, old, new):
    """The differences of two dictionaries, with the largest relative difference first."""
    found = []
    for name in dict.fromkeys([*old, *new]):
        a, b = old.get(name, "absent"), new.get(name, "absent")
        if a == b or a != a and b != b:
            continue
        both = is_number(a) and is_number(b)
        found.append(Change(file, name, a, b, abs(a - b) / max(abs(a), abs(b)) if both else np.inf))
    return sorted(found, key=lambda change: -change.relative)


def closest_on_triangles(points, surface, candidates=12):
    """For every point, the closest triangle among those with the nearest centroids, and the barycentric coordinates of
    the closest point in it."""
    triangles = surface.corners()
    centroids = surface.points[triangles].mean(axis=1)
    chosen, coordinates = [], []
    for block in np.array_split(points, len(points) // 500 + 1):
        squares = (centroids ** 2).sum(axis=1) - 2 * block @ centroids.T
        near = np.argpartition(squares, candidates, axis=1)[:, :candidates]
        a, b, c = np.moveaxis(surface.points[triangles[near]], 2, 0)
        p = block[:, None]
        # The closest point inside the triangle, by areas, and that on each edge.
        normal = np.cross(b - a, c - a)
        area = (normal ** 2).sum(axis=-1)
        v = (np.cross(p - a, c - a) * normal).sum(axis=-1) / area
        w = (np.cross(b - a, p - a) * normal).sum(axis=-1) / area
        trials = [np.stack([1 - v - w, v, w], axis=-1)]
        for k, (start, end) in enumerate(((a, b), (b, c), (c, a))):
            t = ((p - start) * (end - start)).sum(axis=-1) / ((end - start) ** 2).sum(axis=-1)
            t = np.clip(t, 0, 1)
            trials.append(np.roll(np.stack([1 - t, t, 0 * t], axis=-1), k, axis=-1))
        trials = np.stack(trials, axis=2)
        reached = np.einsum("nctk,nckx->nctx", trials, np.stack([a, b, c], axis=2))
        distance = np.linalg.norm(reached - p[:, :, None], axis=-1)
        distance[trials.min(axis=-1) < -1e-9] = np.inf
        best = distance.reshape(len(block), -1).argmin(axis=1)
        rows = np.arange(len(block))
        chosen.append(near[rows, best // 4])
        coordinates.append(trials.reshape(len(block), -1, 3)[rows, best])
    return triangles[np.concatenate(chosen)], np.concatenate(coordinates)


def carried(old, new):
    """The difference of two correspondences with different landmarks, as text. The new points of the first shape are
    carried to the others by the old triangles, and their distances from the new points there are measured. Triangles
    approximate curved surfaces, so some hundredths of a millimetre are not significant."""
    names = sorted({path.name for path in old.glob("*.ply")} & {path.name for path in new.glob("*.ply")})
    if len(names) < 2:
        return "no two shapes to carry points between"
    corners, weights = closest_on_triangles(read_ply(new / names[0]).points, read_ply(old / names[0]))
    distances = np.concatenate([np.linalg.norm(
        (read_ply(old / name).points[corners] * weights[:, :, None]).sum(axis=1) - read_ply(new / name).points, axis=1)
        for name in names[1:]])
    figures = distances.mean(), np.quantile(distances, 0.95), distances.max()
    return (f"new points of {names[0]}, carried to the other shapes by the old triangles, come "
            "{:.3g} mm (mean), {:.3g} mm (95 %), {:.3g} mm (largest) from the new points there".format(*figures))


@dataclass
class Comparison:
    """The differences between the outputs of one job. A group is a file at the top level of a folder, or a folder there
    with its files."""
    counts: dict = field(default_factory=dict)        # group: number of files
    differing: list = field(default_factory=list)     # files that differ
    version_only: list = field(default_factory=list)  # HDF5 files that differ in the version of foramen alone
    shifts: list = field(default_factory=list)        # (largest shift of a point in mm, file)
    lost: dict = field(default_factory=dict)          # why points cannot be compared: files
    notes: list = field(default_factory=list)
    numbers: dict = field(default_factory=dict)       # file: (how many numbers it has, changes)

    def listed(self, names):
        """A short list of file names. Files of one folder are replaced by their number."""
        numbers = {}
        for name in names:
            numbers[group_of(name)] = numbers.get(group_of(name), 0) + 1
        return ", ".join(f"{group}/ ({number} of {self.counts[group]})" if group not in names else group
                         for group, number in numbers.items())

    def compare_ply(self, name, old, new):
        a, b = read_ply(old), read_ply(new)
        if len(a.points) != len(b.points):
            self.lost.setdefault(f"{len(a.points)} vertices became {len(b.points)}", []).append(name)
            return
        if a.faces != b.faces:
            self.lost.setdefault("other triangles", []).append(name)
            return
        self.shifts.append((np.linalg.norm(a.points - b.points, axis=1).max(initial=0), name))
        for scalar in [scalar for scalar in a.scalars if scalar in b.scalars]:
            largest = np.abs(a.scalars[scalar] - b.scalars[scalar]).max(initial=0)
            if largest > 0:
                self.notes.append(f"{name}: {scalar} differs by {largest:.3g} at most")

    def compare_h5(self, name, old, new, versions):
        """Returns False if only the version in texts differs."""
        a, b = h5_contents(old), h5_contents(new)
        found = [f"{name}: {key} {text}" for key in dict.fromkeys([*a, *b])
                 if (text := array_difference(a.get(key), b.get(key), versions))]
        if not found and versions[0] == versions[1]:
            found = [f"{name}: the contents are the same, their layout in the file is not"]
        self.notes += found[:MOST_NOTES] + [f"{name}: {len(found) - MOST_NOTES} more"] * (len(found) > MOST_NOTES)
        return bool(found)

    def compare_file(self, name, old, new, versions):
        if old.read_bytes() == new.read_bytes():
            return
        if old.suffix == ".h5" and not self.compare_h5(name, old, new, versions):
            self.version_only.append(name)
            return
        self.differing.append(name)
        if old.suffix == ".ply":
            self.compare_ply(name, old, new)
        elif old.suffix in (".json", ".csv"):
            numbers = csv_numbers if old.suffix == ".csv" else lambda path: flattened(json.loads(path.read_text()))
            self.numbers[name] = len(numbers(old)), changes(name, numbers(old), numbers(new))


def compare(old, new, versions):
    """Compares the files of two folders, except those that contain times."""
    found = Comparison()
    files = [{str(path.relative_to(side)) for path in side.rglob("*") if path.is_file()} for side in (old, new)]
    for name in sorted(files[0] | files[1]):
        if name in TIMED:
            continue
        group = group_of(name)
        found.counts[group] = found.counts.get(group, 0) + 1
        if name in files[0] & files[1]:
            found.compare_file(name, old / name, new / name, versions)
        else:
            found.differing.append(name)
            found.lost.setdefault(f"written by {'old' if name in files[0] else 'new'} alone", []).append(name)
    if any(group_of(name) == "corresponding" for names in found.lost.values() for name in names):
        found.notes.insert(0, carried(old / "corresponding", new / "corresponding"))
    return found


def left_out(folder):
    """Shapes that a build left out, with the reasons."""
    if not (folder / "run.json").exists():
        return {}
    shapes = json.loads((folder / "run.json").read_text())["shapes"]
    return {shape["name"]: shape["reason"] for shape in shapes if shape["status"] == "left out"}
