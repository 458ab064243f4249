"""Using a model: each function gives the numbers that the program writes for the same input."""

import csv
import json
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import foramen
from program import ply_properties, run_program


DEFINITIONS = {"points": {"a": 0, "b": np.int64(9), "c": np.zeros(3)}, "distances": {"ab": ["a", "b"]},
               "regions": {"near": {"centre": "a", "radius_mm": 12.5}, "all": {"centre": "c", "radius_mm": 500}}}


@pytest.fixture(scope="module")
def model(built):
    return foramen.Model.load(built[0])


@pytest.fixture(scope="module")
def surface(cohort, tmp_path_factory):
    """The file and the Mesh of a training shape in another pose and with another name."""
    mesh = foramen.read_mesh(cohort / "shapes" / "synth002.ply")
    mesh.points = mesh.points @ np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]]).T + [40, -30, 200]
    path = tmp_path_factory.mktemp("surface") / "moved.ply"
    foramen.write_mesh(path, mesh)
    return path, foramen.read_mesh(path)


@pytest.fixture(scope="module")
def part(surface, tmp_path_factory):
    """The file and the Mesh of one half of this shape."""
    mesh = surface[1]
    keep = (mesh.points[mesh.triangles][:, :, 0] < np.median(mesh.points[:, 0])).all(axis=1)
    path = tmp_path_factory.mktemp("part") / "part.ply"
    foramen.write_mesh(path, foramen.Mesh(mesh.points, mesh.triangles[keep], "RAS"))
    return path, foramen.read_mesh(path)


@pytest.fixture(scope="module")
def projection(model, surface):
    calls = []
    found = model.project(surface[1], leave_out="synth002", progress=lambda *call: calls.append(call))
    return found, calls


def ran_meanwhile(work):
    """The number of times that another thread ran during `work`."""
    times, done = [], threading.Event()

    def tick():
        while not done.wait(0.002):
            times.append(time.monotonic())

    ticker = threading.Thread(target=tick)
    ticker.start()
    start = time.monotonic()
    work()
    end = time.monotonic()
    done.set()
    ticker.join()
    # The beginning and the end are not counted, because the interpreter itself changes threads there.
    margin = (end - start) / 4
    return sum(start + margin < t < end - margin for t in times)


def test_project_is_that_of_the_program(built, surface, projection, tmp_path):
    found, calls = projection
    assert run_program("project", built[0], surface[0], "--leave-out", "synth002", "-o", tmp_path, "--quiet").returncode == 0
    for folder, points in (("corresponding", found.points), ("fit", found.fit), ("residual", surface[1].points)):
        assert np.array_equal(foramen.read_mesh(tmp_path / folder / "moved.ply").points, points.astype(np.float32)), folder
    for folder, distances in (("fit", found.fit_residual), ("residual", found.residual)):
        written = ply_properties(tmp_path / folder / "moved.ply")["distance_mm"]
        assert np.array_equal(written, distances.astype(np.float32)), folder
    record = json.loads((tmp_path / "project.json").read_text())["shapes"][0]
    assert list(found.scores) == record["scores_sd"]
    assert found.figures == {key: record[key] for key in found.figures}
    assert found.figures["fit_without_left_out"]["mean_mm"] > found.figures["fit"]["mean_mm"]
    assert ("project", 1.0, "") in calls


def test_project_finds_a_training_shape_again(model, projection):
    assert np.linalg.norm(model.scores - projection[0].scores, axis=1).argmin() == model.names.index("synth002")


def test_complete_is_that_of_the_program(built, model, part, tmp_path):
    calls = []
    completed = model.complete(part[1], noise_mm=0.8, progress=lambda *call: calls.append(call))
    assert run_program("complete", built[0], part[0], "--noise", "0.8", "-o", tmp_path, "--quiet").returncode == 0
    written = foramen.read_mesh(tmp_path / "completed.ply")
    assert np.array_equal(written.points, completed.points.astype(np.float32))
    assert np.array_equal(written.triangles, completed.mesh.triangles) and written.space == completed.mesh.space == "RAS"
    properties = ply_properties(tmp_path / "completed.ply")
    assert np.array_equal(properties["standard_deviation_mm"], completed.sd.astype(np.float32))
    assert np.array_equal(properties["seen"], completed.seen.astype(np.float32))
    record = json.loads((tmp_path / "complete.json").read_text())
    assert record.pop("surface") == "part.ply" and record == completed.figures
    assert [call[0] for call in calls] == ["complete", "complete"]

    posterior, of_file = completed.posterior, foramen.Model.load(tmp_path / "posterior.h5")
    assert posterior.modes == of_file.modes and np.allclose(posterior.variance, of_file.variance, rtol=1e-5)
    assert np.allclose(posterior.mean, completed.points)
    assert np.allclose(posterior.sample(2, seed=3), of_file.sample(2, seed=3), atol=1e-3)


def test_complete_warns_of_another_pose(model, torus):
    near = np.linalg.norm(torus.points - torus.points[0], axis=1) < 12
    patch = foramen.Mesh(torus.points, torus.triangles[near[torus.triangles].all(axis=1)])
    with pytest.warns(UserWarning, match="another pose fits nearly as well"):
        model.complete(patch)


def test_other_threads_run_meanwhile(model, surface, part):
    shapes = model.sample(8000)
    for work in (lambda: model.project(surface[1]), lambda: model.complete(part[1]),
                 lambda: model.measure(DEFINITIONS, shapes)):
        assert ran_meanwhile(work) > 3


def test_surfaces_can_be_projected_at_a_time(built, surface, projection):
    model = foramen.Model.load(built[0])
    with ThreadPoolExecutor(2) as pool:
        for found in pool.map(model.project, [surface[1], surface[1]]):
            assert np.array_equal(found.points, projection[0].points)
            assert "left_out" not in found.figures


def test_an_exception_in_progress_ends_project_and_complete(built, surface, part):
    class Enough(Exception):
        pass

    def stop(stage, fraction, item):
        raise Enough()

    model = foramen.Model.load(built[0])
    for work in (lambda: model.project(surface[1], progress=stop), lambda: model.complete(part[1], progress=stop),
                 lambda: model.measure(DEFINITIONS, progress=stop)):
        with pytest.raises(Enough):
            work()
    assert len(model.project(surface[1]).points) == len(model.mean), "it can be used after all"


def test_measures_are_those_of_the_program(built, model, tmp_path):
    definitions = tmp_path / "m.json"
    definitions.write_text(json.dumps(DEFINITIONS, default=lambda value: value.tolist()))
    assert run_program("measure", built[0], definitions, "-o", tmp_path / "m.csv", "--quiet").returncode == 0
    with open(tmp_path / "m.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    calls = []
    for measures in (model.measure(DEFINITIONS, progress=lambda *call: calls.append(call)), model.measure(definitions)):
        assert measures.names == [row["shape"] for row in rows] == model.names
        for name, values in measures.points.items():
            for axis, column in zip("xyz", values.T):
                assert list(column) == [float(row[f"{name}_{axis}_mm"]) for row in rows]
        for name, values in measures.distances.items():
            assert list(values) == [float(row[f"{name}_mm"]) for row in rows]
        for name, values in measures.areas.items():
            assert list(values) == [float(row[f"{name}_mm2"]) for row in rows]
        assert [list(d) for d in (measures.points, measures.distances, measures.areas)] == [["a", "b", "c"], ["ab"],
                                                                                            ["near", "all"]]
    assert len(calls) == 4

    files = sorted((built[0] / "corresponding").glob("*.ply"))
    landmarks = np.stack([foramen.read_mesh(file).points for file in files])
    of_arrays, of_files = model.measure(DEFINITIONS, landmarks), model.measure(DEFINITIONS, files[1:])
    for kind in ("points", "distances", "areas"):
        for name, values in getattr(of_arrays, kind).items():
            assert np.array_equal(values, getattr(measures, kind)[name])
            assert np.array_equal(values[1:], getattr(of_files, kind)[name])
    assert of_arrays.distances["ab"][0] == pytest.approx(np.linalg.norm(landmarks[0, 0] - landmarks[0, 9]), abs=1e-9)


def test_reconstruct_is_that_of_the_program(built, model, tmp_path):
    assert run_program("reconstruct", built[0], built[0] / "scores.csv", "-o", tmp_path, "--quiet").returncode == 0
    with open(built[0] / "scores.csv", newline="") as file:
        scores = [[float(score) for score in row[1:]] for row in list(csv.reader(file))[1:]]
    shapes = model.reconstruct(scores)
    assert shapes.shape == (4, len(model.mean), 3)
    for name, shape, row in zip(model.names, shapes, scores):
        assert np.array_equal(foramen.read_mesh(tmp_path / f"{name}.ply").points, shape.astype(np.float32))
        assert np.array_equal(model.reconstruct(row), shape)


@pytest.mark.parametrize("output, options", [("a.h5", {}), ("a.h5.json", {}), ("a.swproj", {}), ("a.tps", {}), ("a.csv", {}),
                                             ("b.csv", {"to": "scores"}), ("meshes", {"to": "vtp"})])
def test_convert_gives_the_bytes_of_the_program(built, tmp_path, output, options):
    ours, theirs = tmp_path / "ours", tmp_path / "theirs"
    for folder in (ours, theirs):
        folder.mkdir()
    calls = []
    summary = foramen.convert(built[0], ours / output, progress=lambda *call: calls.append(call), **options)
    flags = [word for key, value in options.items() for word in ("--" + key, value)]
    said = run_program("convert", built[0], "-o", theirs / output, "--json", *flags)
    assert {**json.loads(said.stdout), "output": summary["output"]} == summary
    written = {path.relative_to(theirs): path.read_bytes() for path in theirs.rglob("*") if path.is_file()}
    assert written == {path.relative_to(ours): path.read_bytes() for path in ours.rglob("*") if path.is_file()}
    assert len(written) == summary["files"] and summary["shapes"] == 4
    assert calls[0] == ("read", 0.0, "")


def test_convert_takes_shapes_of_any_tool(built, model, tmp_path):
    foramen.convert(built[0], tmp_path / "a.tps")
    foramen.convert(tmp_path / "a.tps", tmp_path / "again", triangles=built[0] / "mean.ply")
    again = foramen.read_mesh(tmp_path / "again" / "synth003.ply")
    assert np.array_equal(again.triangles, model.triangles)
    assert run_program("convert", built[0] / "corresponding", "--scale", "remove", "-o", tmp_path / "p.h5").returncode == 0
    foramen.convert(built[0] / "corresponding", tmp_path / "f.h5", scale="remove")
    assert (tmp_path / "f.h5").read_bytes() == (tmp_path / "p.h5").read_bytes()


def test_render_gives_the_files_of_the_program(built, tmp_path, monkeypatch):
    monkeypatch.delenv("DISPLAY", raising=False)
    captions = foramen.render(built[0], tmp_path / "ours", only_curves=True, baseline=built[0])
    said = run_program("render", built[0], "--only-curves", "--baseline", built[0], "--json", "-o", tmp_path / "theirs")
    assert json.loads(said.stdout)["files"] == captions and "specificity.svg" in captions
    for name in captions:
        assert (tmp_path / "ours" / name).read_bytes() == (tmp_path / "theirs" / name).read_bytes(), name
    with pytest.raises(foramen.Error, match="display"):
        foramen.render(built[0], tmp_path / "pictures")
    assert not (tmp_path / "pictures").exists()


def test_what_cannot_be_used_is_refused(built, model, surface, part, torus, tmp_path):
    with pytest.raises(foramen.TopologyError, match="hole"):
        model.project(part[1])
    with pytest.raises(foramen.InvalidInput, match="nobody to leave out; there are synth001"):
        model.project(surface[1], leave_out=["synth001", "nobody"])
    with pytest.raises(foramen.InvalidInput, match="20 to 250 mm"):
        model.project(foramen.Mesh(torus.points / 100, torus.triangles))
    with pytest.raises(foramen.InvalidInput, match="no vertebra's"):
        model.complete(foramen.Mesh(torus.points * 100, torus.triangles))
    with pytest.raises(foramen.InvalidInput, match="noise is 0 mm; it must be > 0"):
        model.complete(part[1], noise_mm=0)
    with pytest.raises(foramen.InvalidInput, match="beyond_modes is -1; it must be at least 0"):
        model.complete(part[1], beyond_modes=-1)
    with pytest.raises(foramen.InvalidInput, match="finite"):
        model.reconstruct([0, np.nan])
    with pytest.raises(foramen.InvalidInput, match=r'definitions: point "a": landmark 400 is not there'):
        model.measure({"points": {"a": 400}})
    with pytest.raises(foramen.InvalidInput, match='"a" is not a pair'):
        model.measure({"distances": {"a": 1}})
    with pytest.raises(TypeError, match="set"):
        model.measure({"points": {"a": {1}}})
    with pytest.raises(foramen.InvalidInput, match="has 3 landmarks, the model 400"):
        model.measure({}, np.zeros((2, 3, 3)))
    with pytest.raises(foramen.InvalidInput, match="mm, cm, m or um"):
        model.measure({}, units="inch")
    with pytest.raises(foramen.InvalidInput, match="moved.ply.*triangles"):
        model.measure({}, surface[0])
    with pytest.raises(foramen.InvalidInput, match="to must be one of"):
        foramen.convert(built[0], tmp_path / "a.csv", to="docx")
    with pytest.raises(foramen.InvalidInput, match="lies in the folder"):
        foramen.convert(built[0], built[0] / "a.tps")
    with pytest.raises(foramen.Error):
        foramen.render(tmp_path, tmp_path / "pictures", only_curves=True)


def test_a_model_without_its_folder_says_what_it_lacks(built, model, part, tmp_path):
    of_file = foramen.Model.load(built[0] / "model.h5")
    with pytest.raises(foramen.IoError, match="atlas.h5"):
        of_file.project(part[1])
    with pytest.raises(foramen.InvalidInput, match="folder that build"):
        model.complete(part[1]).posterior.measure({})
