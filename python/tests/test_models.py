import json
import os
import subprocess

import numpy as np
import pytest

import foramen


def test_build_tells_how_far_it_is_and_what_it_made(built):
    folder, summary, calls = built
    stages = [stage for stage, _, _ in calls]
    assert "register" in " ".join(stages) and "write" in stages
    assert all(0 <= fraction <= 1 for _, fraction, _ in calls)
    assert (folder / "report.html").exists()
    assert summary["command"].startswith("foramen build shapes")
    assert json.loads((folder / "metrics.json").read_text())["truth"]["error"]["mean"] < 2


def test_build_gives_the_bytes_of_the_program(cohort, built, tmp_path):
    folder, _, _ = built
    subprocess.run([os.environ["FORAMEN_PROGRAM"], "build", cohort / "shapes", "-o", tmp_path / "m", "--landmarks", "400",
                    "--samples", "20", "--truth", cohort / "truth", "--quiet"], check=True)
    for name in ("model.h5", "mean.ply", "metrics.json", "scores.csv"):
        assert (folder / name).read_bytes() == (tmp_path / "m" / name).read_bytes(), name
    commands = [json.loads((f / "run.json").read_text())["command"] for f in (folder, tmp_path / "m")]
    assert sorted(commands[0].split()) == sorted(commands[1].split())


def test_a_model_is_its_own_arithmetic(built):
    model = foramen.Model.load(built[0])
    points, modes = len(model.mean), model.modes
    assert model.basis.shape == (points, 3, modes) and model.scores.shape == (4, modes) and len(model.names) == 4
    flat = model.basis.reshape(-1, modes)
    assert np.allclose(flat.T @ flat, np.eye(modes), atol=1e-5)
    scores = np.array([1.5, -0.5][:modes])
    expected = model.mean + (model.basis[:, :, : len(scores)] * (scores * np.sqrt(model.variance[: len(scores)]))).sum(2)
    shape = model.reconstruct(scores)
    assert np.allclose(shape, expected)
    assert np.allclose(model.scores_of(shape)[: len(scores)], scores, atol=1e-4)
    assert np.allclose(model.along_mode(0, 2), model.reconstruct([2.0]))
    assert foramen.inspect(model.mesh(model.mean))["genus"] == 1


def test_samples_are_those_of_the_program(built, tmp_path):
    model = foramen.Model.load(built[0])
    shapes = model.sample(3, seed=9)
    assert shapes.shape == (3, len(model.mean), 3)
    subprocess.run([os.environ["FORAMEN_PROGRAM"], "sample", built[0], "-n", "3", "--seed", "9", "-o", tmp_path,
                    "--quiet"], check=True)
    for i in range(3):
        written = foramen.read_mesh(tmp_path / f"sample{i + 1:04d}.ply").points
        assert np.array_equal(written, shapes[i].astype(np.float32))


def test_evaluate_and_compare(cohort, built, tmp_path):
    metrics = foramen.evaluate(built[0], shapes=cohort / "shapes", samples=20)
    assert metrics["generalization"]["by_modes"][0]["modes"] in (0, 1)
    foramen.build(cohort / "shapes", tmp_path / "icp", method="icp", landmarks=400, samples=20)
    compared = foramen.compare([built[0], tmp_path / "icp"])
    assert {"model", "icp"} <= set(compared)
    assert compared["differences"][0]["paired"]
    assert foramen.report(built[0], tmp_path / "r.html", baseline=tmp_path / "icp").endswith("r.html")
    assert (tmp_path / "r.html").stat().st_size > 10000


def test_what_cannot_be_is_refused(built, cohort, tmp_path):
    model = foramen.Model.load(built[0])
    with pytest.raises(foramen.InvalidInput, match="modes"):
        model.reconstruct(np.zeros(model.modes + 1))
    with pytest.raises(foramen.InvalidInput, match="counted from 0"):
        model.along_mode(model.modes, 1)
    with pytest.raises(foramen.InvalidInput, match="landmarks"):
        model.scores_of(np.zeros((3, 3)))
    with pytest.raises(foramen.InvalidInput, match="landmarks"):
        foramen.build(cohort / "shapes", tmp_path / "m", landmarks=3)
    with pytest.raises(foramen.InvalidInput, match="no effect"):
        foramen.build(cohort / "shapes", tmp_path / "m", method="icp", rounds=1)
    with pytest.raises(foramen.Error, match="no/such"):
        foramen.build("/no/such/folder", tmp_path / "m")
    with pytest.raises(foramen.IoError):
        foramen.Model.load(tmp_path)
    assert not (tmp_path / "m").exists()


def test_an_exception_in_progress_ends_the_work(cohort, tmp_path):
    class Enough(Exception):
        pass

    def stop(stage, fraction, item):
        if stage.startswith("register"):
            raise Enough()

    with pytest.raises(Enough):
        foramen.build(cohort / "shapes", tmp_path / "m", landmarks=400, samples=20, progress=stop)
    assert not (tmp_path / "m" / "model.h5").exists()


def test_the_stubs_name_what_there_is():
    import ast
    import dataclasses
    import inspect
    import pathlib

    stubs = ast.parse((pathlib.Path(foramen.__file__).parent / "__init__.pyi").read_text())
    classes = {node.name: node for node in stubs.body if isinstance(node, ast.ClassDef)}
    functions = {node.name: (node, getattr(foramen, node.name)) for node in stubs.body if isinstance(node, ast.FunctionDef)}
    assert set(functions) | set(classes) == set(foramen.__all__)
    methods = {node.name: node for node in classes["Model"].body if isinstance(node, ast.FunctionDef)}
    assert set(methods) == {name for name in vars(foramen.Model) if not name.startswith("_")}
    functions |= {name: (node, vars(foramen.Model)[name]) for name, node in methods.items()}
    for name, (node, function) in functions.items():
        assert function.__doc__, name
        if isinstance(function, property):
            continue
        arguments = [a.arg for a in node.args.args + node.args.kwonlyargs]
        assert arguments == list(inspect.signature(getattr(function, "__func__", function)).parameters), name
    for name, node in classes.items():
        fields = {item.target.id for item in node.body if isinstance(item, ast.AnnAssign)}
        members = {item.targets[0].id: item.value.value for item in node.body if isinstance(item, ast.Assign)}
        if members:
            assert members == {member.name: member.value for member in getattr(foramen, name)}, name
        elif dataclasses.is_dataclass(getattr(foramen, name)):
            assert fields == {item.name for item in dataclasses.fields(getattr(foramen, name)) if item.name[0] != "_"}, name
