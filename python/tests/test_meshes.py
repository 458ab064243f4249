import numpy as np
import pytest

import foramen


def test_a_mesh_comes_back_as_it_was_written(tmp_path, torus):
    torus.space = "RAS"
    for name in ("a.ply", "a.vtp"):
        foramen.write_mesh(tmp_path / name, torus)
        read = foramen.read_mesh(tmp_path / name)
        assert np.array_equal(read.points, torus.points.astype(np.float32))
        assert np.array_equal(read.triangles, torus.triangles)
        assert read.space == "RAS"


def test_inspect_tells_what_is_wrong(torus):
    report = foramen.inspect(torus)
    assert report["usable"] and report["genus"] == 1
    assert report["volume"] == pytest.approx(2 * np.pi**2 * 24 * 7**2, rel=0.07)
    torus.triangles = torus.triangles[1:]
    report = foramen.inspect(torus)
    assert not report["usable"] and report["boundary_edges"] == 3 and "hole" in report["finding"] + report["remedy"]


def test_repair_fills_a_hole_and_knows_the_way_back(torus):
    whole = len(torus.triangles)
    torus.triangles = torus.triangles[1:]
    repaired = foramen.repair(torus)
    assert foramen.inspect(repaired.mesh)["usable"]
    assert len(repaired.mesh.triangles) >= whole
    kept = repaired.origin >= 0
    assert kept.any()
    assert np.allclose(repaired.mesh.points[kept], torus.points[repaired.origin[kept]], atol=1e-9)
    assert repaired.report["changes"][0]["change"] == "holes filled"


def test_distance_of_concentric_tori(torus):
    larger = foramen.Mesh(torus.points * 1.0, torus.triangles)
    larger.points = torus.points + [0, 0, 0.5]
    found = foramen.surface_distance(torus, larger)
    assert 0 < found["mean"] <= found["p95"] <= found["hausdorff"]
    assert found["hausdorff"] == pytest.approx(0.5, abs=0.05)
    assert foramen.surface_distance(torus, torus)["hausdorff"] < 1e-9


def test_synth_is_the_same_for_the_same_seed():
    one, other = foramen.synth(2, seed=5, vertices=2500), foramen.synth(2, seed=5, vertices=2500, threads=1)
    for (surface, truth), (surface2, truth2) in zip(one, other):
        assert np.array_equal(surface.points, surface2.points) and np.array_equal(truth.points, truth2.points)
    assert np.array_equal(one[0][1].triangles, one[1][1].triangles)


def test_synth_makes_rough_shapes_too():
    smooth, rough = (foramen.synth(1, seed=5, vertices=2500, deformation=word)[0][1] for word in ("smooth", "rough"))
    assert np.array_equal(smooth.triangles, rough.triangles) and not np.array_equal(smooth.points, rough.points)
    with pytest.raises(foramen.InvalidInput, match="deformation must be one of smooth, rough"):
        foramen.synth(1, deformation="coarse")


def test_notes_on_a_file_are_warnings_of_the_caller(tmp_path, torus):
    foramen.write_mesh(tmp_path / "a.ply", torus)
    with open(tmp_path / "a.ply", "ab") as file:
        file.write(b"\n more")
    with pytest.warns(UserWarning, match="a.ply") as caught:
        foramen.read_mesh(tmp_path / "a.ply")
    assert caught[0].filename == __file__


def test_errors_are_those_of_the_library(tmp_path, torus):
    with pytest.raises(foramen.IoError, match="no.ply"):
        foramen.read_mesh(tmp_path / "no.ply")
    with pytest.raises(foramen.InvalidInput, match=r"\(P, 3\)"):
        foramen.inspect(foramen.Mesh(np.zeros((4, 2)), torus.triangles))
    with pytest.raises(foramen.InvalidInput, match=r"probably in cm, give this unit \(units='cm' of files; a Mesh is in mm\)"):
        foramen.correspond([foramen.Mesh(torus.points / 10, torus.triangles)], names=["small"])
    with pytest.raises(foramen.IoError, match=r"there is no such model; build it \(foramen.build\(\)\)"):
        foramen.Model.load(tmp_path / "none")
    with pytest.raises(foramen.InvalidInput, match="LPS or RAS"):
        foramen.write_mesh(tmp_path / "a.ply", foramen.Mesh(torus.points, torus.triangles, "XYZ"))
    with pytest.raises(foramen.InvalidInput):
        foramen.repair(foramen.Mesh(torus.points, torus.triangles[: len(torus.triangles) // 2]))
    assert issubclass(foramen.TopologyError, foramen.InvalidInput) and issubclass(foramen.InvalidInput, foramen.Error)
