"""How the files of two output folders differ: points by how far they moved, numbers by name, HDF5 by dataset."""
import csv
import json
from dataclasses import dataclass, field

import h5py
import numpy as np

# The seconds that a run took stand in these.
TIMED = {"run.json", "report.html"}
# Differences to tell of each HDF5 file.
MOST_NOTES = 8


def group_of(name):
    return name.split("/")[0]


@dataclass
class Surface:
    points: np.ndarray
    scalars: dict
    faces: bytes


def read_ply(path):
    """A surface as foramen and the real data have it: little endian, the vertices first, all properties float."""
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
    """Every number and text of a JSON value by its path; an element of an array goes by its name or its number of modes
    if it has one."""
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
    """Of a table with the column `value` those by the other cells of their rows; of another all by row and column."""
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
    """How a dataset differs, in words; none if only the version of foramen in its text does."""
    if old is None or new is None:
        return f"is only in {'new' if old is None else 'old'}"
    if old.shape != new.shape or old.dtype.kind != new.dtype.kind:
        return f"is {new.dtype} {new.shape}, was {old.dtype} {old.shape}"
    if old.dtype.kind not in "iuf":
        same = str(old.tolist()).replace(*versions) == str(new.tolist())
        return "" if same else f"is {new.tolist()}, was {old.tolist()}"
    if old.dtype == new.dtype and old.tobytes() == new.tobytes():
        return ""
    return f"differs by {np.abs(old.astype(float) - new).max(initial=0):.3g} at most, of {np.abs(old).max(initial=0):.3g}"


@dataclass
class Change:
    file: str
    name: str
    old: object
    new: object
    relative: float  # infinite: there on one side only, or a text


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def changes(file, old, new):
    """What differs of two dictionaries, the largest relative difference first."""
    found = []
    for name in dict.fromkeys([*old, *new]):
        a, b = old.get(name, "absent"), new.get(name, "absent")
        if a == b or a != a and b != b:
            continue
        both = is_number(a) and is_number(b)
        found.append(Change(file, name, a, b, abs(a - b) / max(abs(a), abs(b)) if both else np.inf))
    return sorted(found, key=lambda change: -change.relative)


@dataclass
class Comparison:
    """How the outputs of one job differ. A group is a file at the top of the folder, or a folder there with its files."""
    counts: dict = field(default_factory=dict)        # group: number of files
    differing: dict = field(default_factory=dict)     # group: files that differ
    version_only: list = field(default_factory=list)  # HDF5 files that differ in the version of foramen alone
    shifts: list = field(default_factory=list)        # (largest shift of a point in mm, file)
    lost: list = field(default_factory=list)          # (file, why its points cannot be compared)
    notes: list = field(default_factory=list)
    numbers: dict = field(default_factory=dict)       # file: (how many numbers it has, changes)

    def compare_ply(self, name, old, new):
        a, b = read_ply(old), read_ply(new)
        if len(a.points) != len(b.points):
            self.lost.append((name, f"{len(a.points)} vertices became {len(b.points)}"))
            return
        self.shifts.append((np.linalg.norm(a.points - b.points, axis=1).max(initial=0), name))
        if a.faces != b.faces:
            self.lost.append((name, "other triangles"))
        for scalar in [scalar for scalar in a.scalars if scalar in b.scalars]:
            largest = np.abs(a.scalars[scalar] - b.scalars[scalar]).max(initial=0)
            if largest > 0:
                self.notes.append(f"{name}: {scalar} differs by {largest:.3g} at most")

    def compare_h5(self, name, old, new, versions):
        """False: nothing differs but the version in texts."""
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
        self.differing.setdefault(group_of(name), []).append(name)
        if old.suffix == ".ply":
            self.compare_ply(name, old, new)
        elif old.suffix in (".json", ".csv"):
            numbers = csv_numbers if old.suffix == ".csv" else lambda path: flattened(json.loads(path.read_text()))
            self.numbers[name] = len(numbers(old)), changes(name, numbers(old), numbers(new))


def compare(old, new, versions):
    """Compares the files of two folders, but for those that hold seconds."""
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
            found.differing.setdefault(group, []).append(name)
            found.lost.append((name, f"only {'old' if name in files[0] else 'new'} wrote it"))
    return found


def left_out(folder):
    """Shapes that a build left out, with the reasons."""
    if not (folder / "run.json").exists():
        return {}
    shapes = json.loads((folder / "run.json").read_text())["shapes"]
    return {shape["name"]: shape["reason"] for shape in shapes if shape["status"] == "left out"}
