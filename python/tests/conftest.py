"""A small synthetic cohort and its model, made once."""

import numpy as np
import pytest

import foramen


@pytest.fixture(scope="session")
def cohort(tmp_path_factory):
    """Folder with shapes/ and truth/ of four shapes."""
    folder = tmp_path_factory.mktemp("cohort")
    (folder / "shapes").mkdir()
    (folder / "truth").mkdir()
    for i, (surface, truth) in enumerate(foramen.synth(4, seed=7, vertices=2500)):
        foramen.write_mesh(folder / "shapes" / f"synth{i + 1:03d}.ply", surface)
        foramen.write_mesh(folder / "truth" / f"synth{i + 1:03d}.ply", truth)
    return folder


@pytest.fixture(scope="session")
def built(cohort, tmp_path_factory):
    """The folder of the model, the summary, and the arguments with which progress was called."""
    folder = tmp_path_factory.mktemp("built") / "model"
    calls = []
    summary = foramen.build(cohort / "shapes", folder, landmarks=400, samples=20, truth=cohort / "truth",
                            progress=lambda *call: calls.append(call))
    return folder, summary, calls


@pytest.fixture
def torus():
    """A closed torus of 30 x 15 points about z, radii 24 and 7 mm."""
    around, tube = 30, 15
    i, j = np.meshgrid(np.arange(around), np.arange(tube), indexing="ij")
    u, v = 2 * np.pi * i.ravel() / around, 2 * np.pi * j.ravel() / tube
    points = np.stack([(24 + 7 * np.cos(v)) * np.cos(u), (24 + 7 * np.cos(v)) * np.sin(u), 7 * np.sin(v)], axis=1)
    a = (i * tube + j).ravel()
    b = ((i + 1) % around * tube + j).ravel()
    c = ((i + 1) % around * tube + (j + 1) % tube).ravel()
    d = (i * tube + (j + 1) % tube).ravel()
    return foramen.Mesh(points, np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)]).astype(np.int32))
