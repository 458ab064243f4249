"""The stages in memory give the same numbers as the program's files."""

import json
import subprocess
import sys
import textwrap

import numpy as np
import pytest

import foramen
from program import run_program

OPTIONS = {"landmarks": 400}


def numbers(path):
    with open(path) as file:
        return json.load(file)


@pytest.fixture(scope="module")
def shapes(cohort):
    return {path.stem: foramen.read_mesh(path) for path in sorted((cohort / "shapes").glob("*.ply"))}


@pytest.fixture(scope="module")
def truth(cohort):
    return {path.stem: foramen.read_mesh(path) for path in sorted((cohort / "truth").glob("*.ply"))}


@pytest.fixture(scope="module")
def correspondence(shapes):
    calls = []
    made = foramen.correspond(shapes, progress=lambda *call: calls.append(call))
    return made, calls


@pytest.fixture(scope="module")
def model(shapes):
    return foramen.build_model(shapes, **OPTIONS)


def is_as_written(model, folder):
    """Whether a model in memory has the numbers in a model's folder, which are stored in single precision."""
    read = foramen.Model.load(folder)
    assert np.array_equal(model.mean.astype(np.float32), foramen.read_mesh(folder / "mean.ply").points)
    assert np.array_equal(model.triangles, read.triangles) and model.names == read.names and model.space == read.space
    if model.landmark_weights == "equal":  # model.h5 contains modes for equal weights
        assert np.array_equal(model.variance.astype(np.float32), read.variance)
        assert np.array_equal(model.basis.astype(np.float32), read.basis)
    scores = np.loadtxt(folder / "scores.csv", delimiter=",", skiprows=1, usecols=range(1, model.modes + 1))
    assert np.array_equal(model.scores, scores)
    for name, points in zip(model.names, model.corresponding):
        assert np.array_equal(points.astype(np.float32), foramen.read_mesh(folder / "corresponding" / f"{name}.ply").points)


def test_build_model_has_the_numbers_of_the_program(built, model):
    is_as_written(model, built[0])
    record = numbers(built[0] / "run.json")
    assert model.correspondence.reference == record["reference"]
    assert model.correspondence.template_motion == record["template_motion_mm"]
    assert model.correspondence.failed == [] and model.correspondence.names == model.names


@pytest.mark.parametrize("keywords, flags", [
    ({"method": foramen.Method.ICP, "scale": foramen.Scale.REMOVE}, ["--method", "icp", "--scale", "remove"]),
    ({"paper": True, "weights": "area", "reference": "synth003"}, ["--paper", "--weights", "area", "--reference", "synth003"]),
    ({"objective": "description", "bending": foramen.Bending.RIGID, "lambda_": 0.7, "rounds": 1},
     ["--objective", "description", "--bending", "rigid", "--lambda", "0.7", "--rounds", "1"]),
])
def test_keywords_mean_what_the_flags_mean(cohort, shapes, tmp_path, keywords, flags):
    done = run_program("build", cohort / "shapes", "-o", tmp_path / "m", "--landmarks", "400", "--samples", "2", "--quiet",
                       *flags)
    assert done.returncode == 0, done.stderr
    model = foramen.build_model(shapes, landmarks=400, **keywords)
    is_as_written(model, tmp_path / "m")


def test_the_files_of_a_build_record_the_command_of_the_program(cohort, tmp_path):
    done = run_program("build", cohort / "shapes", "-o", tmp_path / "p", "--method", "icp", "--landmarks", "400",
                       "--samples", "2", "--subject-regex", "^(.*)$", "--seed", "3", "--repair", "--hole-limit", "25.5",
                       "--units", "mm", "--quiet")
    assert done.returncode == 0, done.stderr
    foramen.build(cohort / "shapes", tmp_path / "f", method="ICP", landmarks=np.int64(400), samples=2,
                  subject_regex="^(.*)$", seed=3, repair=True, hole_limit=25.5, units="mm", store=tmp_path / "store")
    assert (tmp_path / "f" / "model.h5").read_bytes() == (tmp_path / "p" / "model.h5").read_bytes()
    assert numbers(tmp_path / "f" / "run.json")["command"] == numbers(tmp_path / "p" / "run.json")["command"]
    assert numbers(tmp_path / "f" / "run.json")["options"] == numbers(tmp_path / "p" / "run.json")["options"]
    assert any((tmp_path / "store").iterdir())


def test_stage_after_stage_is_the_whole(shapes, correspondence, model):
    made, calls = correspondence
    assert made.names == model.names and made.method == "torus" and made.reference == model.correspondence.reference
    assert all(0 <= fraction <= 1 for _, fraction, _ in calls) and "register" in " ".join(stage for stage, _, _ in calls)
    for shape in made.shapes:
        assert shape.flipped == 0 and shape.mapped and shape.distortion >= 4 and shape.alignment.shape == (4, 4)
        rotation = shape.alignment[:3, :3]
        assert np.allclose(rotation @ rotation.T, np.eye(3)) and np.linalg.det(rotation) > 0
    landmarks = foramen.place_landmarks(shapes, made, **OPTIONS)
    assert np.array_equal(landmarks.points, model.corresponding) and np.array_equal(landmarks.triangles, model.triangles)
    assert landmarks.turns.shape == (landmarks.points.shape[1], 2) and landmarks.remaining_flips == 0
    again = foramen.build_model(shapes, correspondence=made, **OPTIONS)
    assert np.array_equal(again.mean, model.mean) and np.array_equal(again.variance, model.variance)
    of_points = foramen.Model.from_corresponding(landmarks.points, landmarks.triangles, names=landmarks.names)
    assert np.array_equal(of_points.basis, model.basis) and of_points.names == model.names


def test_a_sequence_of_meshes_is_named(shapes):
    meshes = list(shapes.values())
    assert foramen.correspond(meshes, method="icp").names == ["shape001", "shape002", "shape003", "shape004"]
    assert foramen.correspond(meshes[1:], names="abc", method="icp").names == ["a", "b", "c"]


def test_the_threads_do_not_matter(shapes, model):
    assert np.array_equal(foramen.build_model(shapes, threads=1, **OPTIONS).basis, model.basis)


def test_transforms_lead_into_the_model(model):
    for points, transform, scores in zip(model.corresponding, model.transforms, model.scores):
        moved = points @ transform[:3, :3].T + transform[:3, 3]
        assert np.allclose(moved, model.reconstruct(scores), atol=1e-6)


def test_evaluate_in_memory_has_the_numbers_of_metrics_json(built, model, truth):
    found = foramen.evaluate(model, samples=20, truth=truth)
    metrics = numbers(built[0] / "metrics.json")
    assert found.names == model.names and found.landmarks == metrics["landmarks"]
    assert found.total_variance == metrics["total_variance_mm2"]
    for name in ("generalization", "specificity"):
        for at, row in enumerate(metrics[name]["by_modes"]):
            errors = getattr(found, name)
            assert errors.modes[at] == row["modes"]
            for measure in ("hausdorff", "mean_surface", "landmark_rms"):
                assert getattr(errors, measure).mean[at] == row[measure + "_mm"]["mean"]
                assert getattr(errors, measure).standard_error[at] == row[measure + "_mm"]["standard_error"]
    assert found.generalization.hausdorff.values.shape[1] == 4 and found.specificity.hausdorff.values.shape[1] == 20
    for row, shape in zip(metrics["representation"]["shapes"], zip(found.representation.mean, found.representation.hausdorff)):
        assert (row["mean_mm"], row["hausdorff_mm"]) == shape
    assert found.truth.error == metrics["truth"]["error"]
    assert found.generalization_by_subject is None and len(found.representation.mean) == 4
    assert found.drawn.folded.shape == (20,) and found.compactness.fraction[-1] == pytest.approx(1)


def test_evaluate_compares_marks_in_memory_as_those_of_files(cohort, built, model, shapes, truth, tmp_path):
    # A vertex of the truth corresponds on all shapes, so that its mark has the correspondence's own error.
    marks = {name: {"tip": truth[name].points[7], "path": truth[name].points[[3, 5, 9]],
                    "ring": ("closed", truth[name].points[[20, 25, 30]])} for name in list(shapes)[:3]}
    labels = {name: (mesh.points[:, 0] > np.median(mesh.points[:, 0])).astype(int) + 1 for name, mesh in shapes.items()}
    found = foramen.evaluate(model, samples=2, marks=marks, regions=labels)
    assert found.marks["marked_shapes"] == 3 and found.marks["points"]["pairs"] == 6
    assert [row["part"] for row in found.marks["by_point"]] == ["point", "start", "middle", "end", "centroid"]
    assert 0 < found.marks["curves"]["mean"] < 10 and 0 < found.regions["dice"]["mean"] < 1
    rows = ["shape,landmark,kind,index,x,y,z"]
    for shape, of_shape in marks.items():
        for name, kind in (("tip", "point"), ("path", "open"), ("ring", "closed")):
            points = of_shape[name][1] if kind == "closed" else np.atleast_2d(of_shape[name])
            rows += [f"{shape},{name},{kind},{i},{x!r},{y!r},{z!r}" for i, (x, y, z) in enumerate(points.tolist())]
    (tmp_path / "marks.csv").write_text("\n".join(rows) + "\n")
    for name, of_shape in labels.items():
        (tmp_path / f"{name}.txt").write_text("\n".join(map(str, of_shape)))
    of_files = foramen.evaluate(built[0], shapes=cohort / "shapes", samples=2, marks=tmp_path / "marks.csv",
                                regions=[tmp_path / f"{name}.txt" for name in labels])
    assert of_files["marks"]["points"]["mean"] == pytest.approx(found.marks["points"]["mean"], abs=1e-3)
    assert of_files["regions"]["dice"]["mean"] == pytest.approx(found.regions["dice"]["mean"], abs=1e-3)
    assert foramen.evaluate(model, samples=2).marks is None
    for error, text, call in [
            (foramen.InvalidInput, "there is no shape else", lambda: foramen.evaluate(model, marks={"else": {}})),
            (TypeError, "must be a mapping", lambda: foramen.evaluate(model, regions=[1])),
            (foramen.InvalidInput, "none of point, open, closed",
             lambda: foramen.evaluate(model, marks={name: {"a": ("ring", [[0, 0, 0]])} for name in shapes})),
            (foramen.InvalidInput, "a point .3,. or a curve", lambda: foramen.evaluate(model, marks={"synth001": {"a": [1, 2]}})),
            (foramen.InvalidInput, "but its surface has", lambda: foramen.evaluate(model, regions={"synth001": [1]}))]:
        with pytest.raises(error, match=text):
            call()


def test_evaluate_takes_meshes_of_any_tool(cohort, built, model, shapes, tmp_path):
    files = sorted((built[0] / "corresponding").glob("*.ply"))
    of_folder = foramen.evaluate(built[0], shapes=cohort / "shapes", samples=5, subject_regex="(.)$")
    meshes = {file.stem: foramen.read_mesh(file) for file in files}
    for found in (foramen.evaluate(meshes, shapes=shapes, samples=5, subjects=["1", "2", "3", "4"]),
                  foramen.evaluate(list(meshes.values()), names=list(meshes), shapes=list(shapes.values()), samples=5,
                                   subject_regex="(.)$", scale=foramen.Scale.KEEP)):
        rows = of_folder["generalization"]["by_modes"]
        assert [row["hausdorff_mm"]["mean"] for row in rows] == list(found.generalization.hausdorff.mean)
        assert found.generalization_by_subject is not None and found.subjects == ["1", "2", "3", "4"]
    meshes["synth001"].triangles = meshes["synth001"].triangles[::-1]
    with pytest.raises(foramen.InvalidInput, match="not in correspondence"):
        foramen.evaluate(meshes)


def test_a_model_in_memory_is_used_as_one_of_a_folder(cohort, shapes, tmp_path):
    # A mean of fewer than 1000 landmarks is subdivided, and the result then depends on the precision of files.
    model = foramen.build_model(shapes, landmarks=1500)
    foramen.build(cohort / "shapes", tmp_path / "model", landmarks=1500, samples=2)
    of_folder = foramen.Model.load(tmp_path / "model")
    surface = shapes["synth002"]
    found, expected = model.project(surface), of_folder.project(surface)
    apart = np.linalg.norm(found.points - expected.points, axis=1)  # files have single precision
    assert apart.mean() < 0.05, apart.mean()
    assert np.linalg.norm(model.scores - found.scores, axis=1).argmin() == 1
    keep = (surface.points[surface.triangles][:, :, 0] < np.median(surface.points[:, 0])).all(axis=1)
    part = foramen.Mesh(surface.points, surface.triangles[keep])
    assert np.allclose(model.complete(part).points, of_folder.complete(part).points, atol=1e-1)
    fewer = model.complete(part, options={"match.samples": 500})
    assert not np.array_equal(fewer.points, model.complete(part).points)
    definitions = {"points": {"a": 0, "b": 9}, "distances": {"ab": ["a", "b"]}}
    measures = model.measure(definitions)
    assert measures.names == model.names
    assert np.allclose(measures.distances["ab"], of_folder.measure(definitions).distances["ab"], atol=1e-4)


def test_from_corresponding_is_a_principal_component_analysis():
    rng = np.random.default_rng(5)
    mean = foramen.synth(1, seed=2, vertices=2500)[0][1]
    modes = rng.normal(size=(2, len(mean.points), 3))
    points = np.stack([mean.points + np.tensordot(rng.normal(size=2), modes, 1) for _ in range(6)])
    model = foramen.Model.from_corresponding(points, mean.triangles)
    aligned = np.stack([p @ t[:3, :3].T + t[:3, 3] for p, t in zip(points, model.transforms)]).reshape(6, -1)
    assert np.allclose(aligned.mean(0), model.mean.ravel(), atol=1e-9)
    _, singular, axes = np.linalg.svd(aligned - aligned.mean(0), full_matrices=False)
    variance = singular[: model.modes] ** 2 / 5
    assert np.allclose(model.variance, variance, atol=1e-9 * variance[0])
    along = np.abs(np.einsum("kx,xk->k", axes[: model.modes], model.basis.reshape(-1, model.modes)))
    assert np.allclose(along[:2], 1, atol=1e-9)
    assert np.allclose(model.scores.std(0, ddof=1), 1)
    assert np.array_equal(model.corresponding, points) and model.names[0] == "shape001"
    with pytest.raises(foramen.InvalidInput, match="build it from surfaces"):
        model.project(mean)
    assert foramen.evaluate(model, samples=3).landmarks == len(mean.points)


def test_a_shape_that_cannot_be_used_is_left_out(shapes, torus):
    open_torus = foramen.Mesh(torus.points, torus.triangles[1:])
    made = foramen.correspond({**shapes, "open": open_torus}, method="icp")
    assert made.names == list(shapes)
    (name, reason), = made.failed
    assert name == "open" and "hole" in reason
    with pytest.raises(foramen.InvalidInput, match="at least 3 usable shapes(.|\n)*left out open: "):
        foramen.correspond([*list(shapes.values())[:2], open_torus], names=["a", "b", "open"])


def test_what_cannot_be_is_refused(shapes, correspondence, model):
    made = correspondence[0]
    for error, text, call in [
            (foramen.InvalidInput, "no effect", lambda: foramen.correspond(shapes, method="icp", rounds=2)),
            (foramen.InvalidInput, "rounds is 1000; it must be", lambda: foramen.correspond(shapes, rounds=1000)),
            (foramen.InvalidInput, "one of torus, icp, not nearest", lambda: foramen.correspond(shapes, method="nearest")),
            (foramen.InvalidInput, "somebody", lambda: foramen.correspond(shapes, reference="somebody")),
            (foramen.InvalidInput, "the nearest are .*group.rounds", lambda: foramen.correspond(shapes, options={"round": 1})),
            (foramen.InvalidInput, "several options; name one of group.lambda",
             lambda: foramen.correspond(shapes, options={"lambda": 1})),
            (foramen.InvalidInput, "group.still is -1 mm", lambda: foramen.correspond(shapes, options={"group.still": -1})),
            (foramen.InvalidInput, "same name", lambda: foramen.correspond(list(shapes.values()), names=["a"] * 4)),
            (foramen.InvalidInput, "2 names for 4 shapes", lambda: foramen.correspond(list(shapes.values()), names=["a", "b"])),
            (foramen.InvalidInput, "target_error", lambda: foramen.build_model(shapes, landmarks=400, target_error=1.0)),
            (foramen.InvalidInput, "finished", lambda: foramen.build_model(shapes, correspondence=made, method="icp")),
            (foramen.InvalidInput, "finished",
             lambda: foramen.build_model(shapes, correspondence=made, options={"group.rounds": 1})),
            (foramen.InvalidInput, "without its maps", lambda: foramen.place_landmarks(shapes, model.correspondence)),
            (foramen.InvalidInput, "synth002", lambda: foramen.place_landmarks({"synth001": shapes["synth001"]}, made)),
            (foramen.InvalidInput, "no point 5", lambda: foramen.Model.from_corresponding(np.zeros((3, 4, 3)), [[0, 1, 5]])),
            (foramen.InvalidInput, "at least 2", lambda: foramen.Model.from_corresponding(np.zeros((1, 4, 3)), [[0, 1, 2]])),
            (foramen.InvalidInput, "N, P, 3", lambda: foramen.Model.from_corresponding(np.zeros((4, 3)), [[0, 1, 2]])),
            (foramen.InvalidInput, "in memory", lambda: foramen.evaluate(model, output="folder")),
            (TypeError, "landmarks must be a whole number, not float", lambda: foramen.build_model(shapes, landmarks=400.0)),
            (TypeError, "landmarks must be a whole number, not bool", lambda: foramen.build_model(shapes, landmarks=True)),
            (TypeError, "lambda must be a number, not str", lambda: foramen.correspond(shapes, lambda_="0.5")),
            (TypeError, "method must be a string", lambda: foramen.correspond(shapes, method=1)),
            (TypeError, "must be a Mesh", lambda: foramen.correspond([1, 2, 3])),
            (TypeError, "unexpected keyword", lambda: foramen.correspond(shapes, rnds=1))]:
        with pytest.raises(error, match=text):
            call()


def test_an_exception_in_progress_ends_each_stage(shapes, correspondence):
    class Enough(Exception):
        pass

    def stop(stage, fraction, item):
        raise Enough()

    for work in (lambda: foramen.correspond(shapes, progress=stop), lambda: foramen.build_model(shapes, progress=stop),
                 lambda: foramen.place_landmarks(shapes, correspondence[0], progress=stop)):
        with pytest.raises(Enough):
            work()


def test_ctrl_c_cancels(tmp_path):
    script = textwrap.dedent("""
        import os, signal, threading, time
        import foramen
        shapes = [surface for surface, _ in foramen.synth(6, seed=1, vertices=6000)]
        threading.Timer(1, os.kill, (os.getpid(), signal.SIGINT)).start()
        start = time.monotonic()
        try:
            foramen.build_model(shapes)
        except KeyboardInterrupt:
            print("cancelled", time.monotonic() - start)
    """)
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=300)
    assert done.stdout.startswith("cancelled"), done.stderr
