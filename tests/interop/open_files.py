"""open_files.py READER FOLDER: opens what write_files.sh wrote with a reader that is not foramen's.

READER is a function below. If a reader is not installed, the script prints "skipped: ..." and succeeds. If two readers
read the same data, the results are compared. scalismo_rules, shapeworks_rules and geomorph_rules do not run these
programs, which Debian does not have. They only check the files against the rules of the programs' readers.
"""

import csv
import html.parser
import importlib
import json
import os
import re
import subprocess
import sys
from pathlib import Path


def need(module):
    try:
        return importlib.import_module(module)
    except ImportError:
        print(f"skipped: {module} is not installed (./dev test installs it)")
        sys.exit(0)


def expect(condition, what):
    if not condition:
        sys.exit(f"FAILED: {what}")


def table(path):
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file, strict=True))
    expect(len(rows) > 1 and all(len(row) == len(rows[0]) for row in rows), f"{path}: rows of different lengths")
    return rows[0], rows[1:]


def points_of_table(folder):
    """The landmarks of all shapes in the CSV file: {shape: [[x, y, z], ...]}."""
    header, rows = table(folder / "landmarks.csv")
    expect(header == ["shape", "landmark", "x", "y", "z"], "landmarks.csv: its header")
    shapes = {}
    for shape, landmark, *xyz in rows:
        points = shapes.setdefault(shape, [])
        expect(int(landmark) == len(points), "landmarks.csv: landmarks in order")
        points.append([float(c) for c in xyz])
    return shapes


def close(a, b, tolerance=1e-4):
    """Whether two lists of points are equal up to single precision."""
    return len(a) == len(b) and all(abs(x - y) <= tolerance for p, q in zip(a, b) for x, y in zip(p, q))


def meshes(folder, suffix):
    found = sorted(p for p in folder.rglob("*" + suffix) if "synth" not in p.parts)
    expect(len(found) >= 4, f"meshes {suffix}: {len(found)}")
    return found


# ---- independent readers


def h5dump(folder):
    if not os.environ.get("H5DUMP", "").startswith("/"):
        print("skipped: h5dump is not installed (./dev test installs it)")
        return
    for path in sorted(folder.rglob("*.h5")):
        dump = subprocess.run([os.environ["H5DUMP"], path], capture_output=True, text=True)
        expect(dump.returncode == 0 and not dump.stderr, f"{path}: {dump.stderr}")
        if path.name == "model.h5":
            for wanted in ("POLYGON_MESH", 'DATASET "pcaBasis"', "H5T_IEEE_F32LE", 'DATASET "cells"', "H5T_STD_I32LE"):
                expect(wanted in dump.stdout, f"{path}: no {wanted}")


def h5py(folder):
    library = need("h5py")
    numpy = need("numpy")
    for path in sorted(folder.rglob("*.h5")):
        with library.File(path, "r") as file:
            names = []
            file.visititems(lambda name, item: names.append(item[()]) if isinstance(item, library.Dataset) else None)
            expect(names, f"{path}: nothing in it")
    with library.File(folder / "model/model.h5", "r") as file:
        basis, variance = file["model/pcaBasis"][()], file["model/pcaVariance"][()]
        expect(basis.dtype == numpy.float32 and file["representer/cells"].dtype == numpy.int32, "model.h5: types")
        expect(numpy.allclose(basis.T @ basis, numpy.eye(len(variance)), atol=1e-4), "model.h5: basis not orthonormal")
        expect(file["model/mean"].shape == (basis.shape[0],), "model.h5: mean")
        header, rows = table(folder / "model/scores.csv")
        scores = numpy.array([[float(cell) for cell in row[1:]] for row in rows])
        expect(numpy.allclose(scores, file["modelinfo/scores"][()].T, atol=1e-4), "scores.csv is not model.h5's scores")
        converted = numpy.array([[float(cell) for cell in row[1:]] for row in table(folder / "scores.csv")[1]])
        expect(numpy.allclose(scores, converted, atol=1e-4), "scores of convert are not those of the build")
    # The same shapes in other files must have the same variances.
    for name in ("from_meshes.h5", "from_shapeworks.h5"):
        with library.File(folder / name, "r") as file:
            expect(numpy.allclose(file["model/pcaVariance"][()], variance, rtol=1e-3), f"{name}: other variances")
    with library.File(folder / "model/atlas.h5", "r") as file:
        expect(sorted(file["shapes"]) == sorted(points_of_table(folder)), "atlas.h5: names of shapes")


def vtk(folder):
    library = need("vtkmodules.all")
    expected = points_of_table(folder)
    for suffix, reader_class in ((".ply", library.vtkPLYReader), (".vtp", library.vtkXMLPolyDataReader)):
        for path in meshes(folder, suffix):
            reader = reader_class()
            reader.SetFileName(str(path))
            reader.Update()
            mesh = reader.GetOutput()
            expect(mesh.GetNumberOfPoints() > 100 and mesh.GetNumberOfPolys() == 2 * mesh.GetNumberOfPoints(),
                   f"{path}: {mesh.GetNumberOfPoints()} points, {mesh.GetNumberOfPolys()} triangles: not a torus")
            if path.parent.name in ("corresponding", "groomed", "vtp"):
                points = [mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints())]
                expect(close(points, expected[path.stem]), f"{path}: points are not those of landmarks.csv")
            if suffix == ".vtp":
                tag = mesh.GetFieldData().GetAbstractArray("SPACE")
                expect(tag and tag.GetValue(0) == "LPS", f"{path}: SPACE is not LPS")


def meshio(folder):
    library = need("meshio")
    expected = points_of_table(folder)
    for path in meshes(folder, ".ply"):
        mesh = library.read(path)
        expect(len(mesh.cells_dict["triangle"]) == 2 * len(mesh.points), f"{path}: not a torus")
        if path.parent.name in ("corresponding", "groomed"):
            expect(close(mesh.points.tolist(), expected[path.stem]), f"{path}: points are not those of landmarks.csv")


def open3d(folder):
    library = need("open3d")
    numpy = need("numpy")
    expected = points_of_table(folder)
    for path in meshes(folder, ".ply"):
        mesh = library.io.read_triangle_mesh(str(path))
        expect(len(mesh.triangles) == 2 * len(mesh.vertices) > 0, f"{path}: not a torus")
        expect(mesh.is_edge_manifold(allow_boundary_edges=False), f"{path}: not a closed manifold")
        if path.parent.name in ("corresponding", "groomed"):
            expect(close(numpy.asarray(mesh.vertices).tolist(), expected[path.stem]), f"{path}: other points")


def no_constant(text):
    raise ValueError(f"{text} is not JSON")


def load_json(path):
    return json.loads(path.read_text(encoding="utf-8"), parse_constant=no_constant)


def python_json(folder):
    expected = points_of_table(folder)
    metrics, run = load_json(folder / "model/metrics.json"), load_json(folder / "model/run.json")
    expect(sorted(metrics["names"]) == sorted(expected), "metrics.json: names")
    expect(sorted(s["name"] for s in run["shapes"]) == sorted(expected), "run.json: names")


def python_csv(folder):
    expected = points_of_table(folder)
    header, rows = table(folder / "model/metrics.csv")
    expect(header == ["item", "kind", "modes", "measure", "value", "unit"], "metrics.csv: its header")
    expect({row[0] for row in rows if row[1] == "shape"} == set(expected), "metrics.csv: shapes")
    for row in rows:
        float(row[4])
    header, rows = table(folder / "model/scores.csv")
    expect(header[:2] == ["shape", "mode1"] and [row[0] for row in rows] == sorted(expected), "scores.csv")


# ---- rules of programs that Debian does not have


class Hdf5Json:
    """Reads the .h5.json like Scalismo's hdf5json. A value that Scalismo could not cast is an error."""

    types = {"H5T_FLOAT": {"H5T_IEEE_F32LE", "H5T_IEEE_F64LE"}, "H5T_INTEGER": {"H5T_STD_I32LE"}}

    def __init__(self, path):
        file = load_json(path)
        self.file, self.groups, self.datasets = file, {}, {}
        expect(set(file) == {"apiVersion", "root", "groups", "datasets"}, f"{path}: top keys {sorted(file)}")
        for thing in list(file["groups"]) + list(file["datasets"]):
            expect(re.fullmatch(r"[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}", thing), f"{path}: {thing} is no UUID")
        self.index("", file["root"])

    def index(self, path, id):
        group = self.file["groups"][id]
        self.groups[path] = group
        expect(group["alias"] == [path or "/"], f"{path}: alias")
        for link in group["links"]:
            expect(link["class"] == "H5L_TYPE_HARD", f"{path}: link {link}")
            if link["collection"] == "groups":
                self.index(path + "/" + link["title"], link["id"])
            else:
                dataset = self.file["datasets"][link["id"]]
                self.check(path + "/" + link["title"], dataset)
                self.datasets[path + "/" + link["title"]] = dataset["value"]

    def check_type(self, path, type):
        if type["class"] == "H5T_STRING":
            expect(type["charSet"] == "H5T_CSET_UTF8" and type["strPad"] == "H5T_STR_NULLPAD", f"{path}: {type}")
        else:
            expect(type["base"] in self.types[type["class"]], f"{path}: {type}")

    def check(self, path, dataset):
        self.check_type(path, dataset["type"])
        dims, value = dataset["shape"].get("dims", []), dataset["value"]
        expect(bool(dims) == (dataset["shape"]["class"] == "H5S_SIMPLE"), f"{path}: shape")
        for size in dims:
            expect(isinstance(value, list) and len(value) == size, f"{path}: not of the shape {dims}")
            value = value[0]

    def text_attribute(self, path, name):
        found = [a for a in self.groups[path]["attributes"] if a["name"] == name]
        expect(len(found) == 1 and isinstance(found[0]["value"], str), f"{path}@{name}: not one plain text")
        expect(found[0]["shape"] == {"class": "H5S_SCALAR"}, f"{path}@{name}: not scalar")
        return found[0]["value"]


def scalismo_rules(folder):
    model = Hdf5Json(folder / "model.h5.json")
    data = model.datasets
    expect(model.text_attribute("/representer", "datasetType") == "POLYGON_MESH", "datasetType")
    model.text_attribute("/representer", "name")
    expect((data["/version/majorVersion"], data["/version/minorVersion"]) == (0, 9), "version")
    points, cells = data["/representer/points"], data["/representer/cells"]
    expect(len(points) == 3 and len(cells) == 3, "points and cells are not by axis and corner")
    count, modes = len(points[0]), len(data["/model/pcaVariance"])
    expect(all(isinstance(c, int) and 0 <= c < count for row in cells for c in row), "cells")
    expect(len(data["/model/mean"]) == 3 * count, "mean")
    expect(len(data["/model/pcaBasis"]) == 3 * count and all(len(r) == modes for r in data["/model/pcaBasis"]), "basis")
    for i in range(modes):
        for j in range(modes):
            dot = sum(row[i] * row[j] for row in data["/model/pcaBasis"])
            expect(abs(dot - (i == j)) < 1e-4, "basis is not orthonormal, as version 0.9 demands")
    expected = points_of_table(folder)
    for name, shape in expected.items():
        landmarks = load_json(folder / "landmarks" / (name + ".json"))
        expect(all(set(l) <= {"id", "coordinates", "description"} for l in landmarks), "landmarks: members")
        expect(len({l["id"] for l in landmarks}) == len(landmarks), "landmarks: an id comes twice")
        expect(close([l["coordinates"] for l in landmarks], shape, 0), f"landmarks of {name}")
    # PLY: properties, names of types and line ends that its reader accepts.
    for path in meshes(folder, ".ply"):
        head = path.read_bytes().split(b"end_header\n")[0]
        expect(b"\r" not in head, f"{path}: CR in its header")
        properties = re.findall(rb"property (.*)", head)
        expect(properties == [b"float x", b"float y", b"float z", b"list uchar int vertex_indices"], f"{path}: {properties}")
        expect(b"comment SPACE=LPS" in head, f"{path}: no SPACE=LPS")


def numbers_as_shapeworks_reads(text):
    """The numbers that `while (in >> x >> y >> z)` reads from a file. The last line is read only if a line end
    follows."""
    lines = text.split("\n")[:-1]
    return [[float(word) for word in line.split()] for line in lines]


def shapeworks_rules(folder):
    study = folder / "study"
    project = load_json(study / "model.swproj")
    keys = ["data", "groom", "optimize", "studio", "project", "analysis", "deepssm", "landmarks"]
    expect(list(project) == keys, f"swproj: {list(project)}")
    for name in keys[2:7]:
        expect(all(isinstance(v, str) for v in project[name].values()), f"swproj: {name} holds something that is no text")
    expect(all(isinstance(v, dict) for v in project["groom"].values()), "swproj: groom")
    expected = points_of_table(folder)
    expect([s["name"] for s in project["data"]] == list(expected), "swproj: names")
    for subject in project["data"]:
        expect(all(isinstance(v, str) for v in subject.values()), "swproj: a value is no text")
        matrices = [[float(n) for n in subject[key].split()] for key in ("alignment_1", "procrustes_1")]
        expect(all(len(m) == 16 and m[12:] == [0, 0, 0, 1] for m in matrices), "swproj: transforms")
        for key in ("shape_1", "groomed_1", "local_particles_1", "world_particles_1"):
            expect((study / subject[key]).is_file() and not subject[key].startswith("/"), f"swproj: {subject[key]}")
        local, world = (numbers_as_shapeworks_reads((study / subject[key]).read_text())
                        for key in ("local_particles_1", "world_particles_1"))
        expect(close(local, expected[subject["name"]], 0), "local particles")
        expect(len(local) == int(project["optimize"]["number_of_particles"]), "number of particles")
        m = matrices[1]
        moved = [[sum(m[4 * r + c] * p[c] for c in range(3)) + m[4 * r + 3] for r in range(3)] for p in local]
        expect(close(moved, world, 1e-6), "world particles are not procrustes * local")


def geomorph_rules(folder):
    """readland.tps(file, specID = "ID") of geomorph, step by step."""
    lines = [line for line in (folder / "landmarks.tps").read_text().split("\n") if line.strip()]
    for dropped in ("COMMENT=", "VARIABLES", "CHAIN", "RADII", "SCALE", "CURVES="):
        expect(not any(dropped in line.upper() for line in lines), f"tps: geomorph drops a line for {dropped}")
    expect(not any("LM=" in line.upper() for line in lines), "tps: taken for two-dimensional")
    counts = [int(line[4:]) for line in lines if line.upper().startswith("LM3=")]
    names = [line[3:] for line in lines if line.startswith("ID=")]
    expect(len(set(counts)) == 1 and len(names) == len(counts), "tps: specimens")
    # strsplit() gives an empty first word, and so NA, to a line that begins with a blank.
    numbers = [float(word) for line in lines if "=" not in line for word in re.split(r"\s+", line)]
    expect(len(numbers) == 3 * sum(counts), "tps: numbers")
    for i, (name, shape) in enumerate(points_of_table(folder).items()):
        start = 3 * counts[0] * i
        points = [numbers[start + 3 * k : start + 3 * k + 3] for k in range(counts[0])]
        expect(names[i] == name and close(points, shape, 0), f"tps: {name}")


# ---- every file has a reader


def every_file(folder):
    """Checks that each file of a build and of convert has a kind that a test above opens."""
    opened = [r".*\.ply", r".*\.vtp", r".*\.h5", r".*\.csv", r"model/(metrics|run)\.json", r"model\.h5\.json",
              r"landmarks/.*\.json", r"landmarks\.tps", r"study/model\.swproj", r"study/particles/.*\.particles"]
    for path in sorted(p for p in folder.rglob("*") if p.is_file()):
        name = path.relative_to(folder).as_posix()
        if name.startswith("synth/"):
            continue
        if name == "model/report.html":  # the tests of the viewer open it in a browser; here its tags
            html.parser.HTMLParser().feed(path.read_text(encoding="utf-8"))
            continue
        expect(any(re.fullmatch(pattern, name) for pattern in opened), f"{name}: no test opens it; add one")


if __name__ == "__main__":
    globals()[sys.argv[1]](Path(sys.argv[2]))
