"""Statistical shape models of vertebrae, automatically.

    import foramen
    summary = foramen.build(["shapes/"], "model", landmarks=2000)
    model = foramen.Model.load("model")
    shapes = model.sample(100, seed=1)            # (100, P, 3), mm

Surfaces are Mesh objects of numpy arrays: points (P, 3) in mm, triangles (T, 3), counter-clockwise seen from outside.
Long work runs without the interpreter's lock on `threads` threads (0: all) and calls `progress(stage, fraction, item)`,
fraction in 0..1 of the stage; an exception raised there, or Ctrl-C, ends the work and is raised. Errors are those of the
C++ library: Error, and from it IoError, InvalidInput, TopologyError (an InvalidInput), ConvergenceError and Cancelled.
"""

import json as _json
import os as _os
from dataclasses import dataclass as _dataclass

import numpy as _np

from . import _foramen
from ._foramen import Cancelled, ConvergenceError, Error, InvalidInput, IoError, TopologyError

__version__ = _foramen.version
__all__ = ["Cancelled", "ConvergenceError", "Error", "InvalidInput", "IoError", "Mesh", "Model", "Repaired",
           "TopologyError", "build", "compare", "evaluate", "extract", "inspect", "read_mesh", "repair", "report",
           "surface_distance", "synth", "write_mesh"]

for _error in (Cancelled, ConvergenceError, Error, InvalidInput, IoError, TopologyError):
    _error.__module__ = __name__


@_dataclass
class Mesh:
    """A triangle surface: points (P, 3) float64 in mm, triangles (T, 3) int32, space "LPS" or "RAS"."""

    points: _np.ndarray
    triangles: _np.ndarray
    space: str = "LPS"


@_dataclass
class Repaired:
    """What repair() gives: the mesh; for each of its points the raw point it was, -1 if new (P,); the report."""

    mesh: Mesh
    origin: _np.ndarray
    report: dict


class Model:
    """A statistical shape model x = mean + sum_m scores_m sqrt(variance_m) basis_m.

    mean (P, 3) mm; triangles (T, 3); variance (K,) mm^2, decreasing, divisor n - 1; basis (P, 3, K), orthonormal in the inner
    product of the weights (P,); names of the n training shapes and their scores (n, K) in standard deviations; space.
    """

    def __init__(self, loaded):
        self._loaded = loaded
        self.mean = loaded.mean
        self.triangles = loaded.triangles
        self.variance = loaded.variance
        self.basis = loaded.basis
        self.weights = loaded.weights
        self.names = loaded.names
        self.scores = loaded.scores
        self.space = loaded.space

    @classmethod
    def load(cls, path):
        """The model of a folder that build() wrote, or of a model.h5 in the statismo layout."""
        return cls(_foramen.LoadedModel(_os.fspath(path)))

    @property
    def modes(self):
        """K, the number of modes."""
        return len(self.variance)

    def mesh(self, points):
        """Landmarks (P, 3) as a Mesh of the model's triangles."""
        return Mesh(_np.asarray(points), self.triangles, self.space)

    def reconstruct(self, scores):
        """The shape (P, 3), mm, of up to K scores in standard deviations."""
        return self._loaded.reconstruct(_np.asarray(scores, dtype=float))

    def scores_of(self, points):
        """Scores (K,), in standard deviations, of landmarks (P, 3) in the model's frame: those of the closest shape."""
        return self._loaded.scores_of(points)

    def sample(self, count, seed=1):
        """Random shapes (count, P, 3), mm: those that `foramen sample` writes for the same seed."""
        return self._loaded.sample(count, seed)

    def along_mode(self, mode, sd):
        """The mean +- sd standard deviations (P, 3), mm, along a mode counted from 0."""
        return self._loaded.along_mode(mode, sd)


def _paths(inputs):
    if isinstance(inputs, (str, _os.PathLike)):
        inputs = [inputs]
    return [_os.fspath(path) for path in inputs]


def _path(path):
    return "" if path is None else _os.fspath(path)


def _arguments(options):
    """Keywords as the program's options: landmarks=400 is --landmarks 400, refit=True is --refit."""
    arguments = []
    for key, value in options.items():
        if value is None or value is False:
            continue
        arguments.append("--" + key.replace("_", "-"))
        if value is not True:
            arguments.append(_os.fspath(value) if isinstance(value, _os.PathLike) else str(value))
    return arguments


def read_mesh(path):
    """A Mesh from PLY, STL, OBJ, OFF, VTK or VTP; untagged files count as LPS."""
    points, triangles, space = _foramen.read_mesh(_os.fspath(path))
    return Mesh(points, triangles, space or "LPS")


def write_mesh(path, mesh):
    """Writes .ply (binary) or .vtp, with a SPACE tag, whole or not at all."""
    _foramen.write_mesh(_os.fspath(path), mesh.points, mesh.triangles, mesh.space)


def inspect(mesh):
    """The audit of a surface as a dict: usable, genus, closed, manifold ...; if not usable, finding and remedy."""
    return _json.loads(_foramen.inspect(mesh.points, mesh.triangles))


def repair(mesh, *, handle_limit=12.0, hole_limit=20.0, threads=0, progress=None):
    """One closed, manifold, outward surface of genus 1, as a Repaired.

    handle_limit: an extra handle is noise if both its loops are at most this long [mm]; hole_limit: a hole is filled if its
    border is at most this long [mm]. Raises InvalidInput with the reason if the surface cannot be repaired.
    """
    points, triangles, origin, report_text = _foramen.repair(mesh.points, mesh.triangles, handle_limit, hole_limit,
                                                             threads, progress)
    return Repaired(Mesh(points, triangles, mesh.space), origin, _json.loads(report_text))


def synth(shapes=14, *, seed=1, modes=4, amplitude=2.1, correlation=40.0, vertices=10000, threads=0, progress=None):
    """Vertebra-like shapes with known correspondence: a list of (surface, truth), two Mesh objects each.

    Truths have identical triangles. amplitude: RMS displacement of a coordinate [mm]; correlation: its length [mm].
    """
    made = _foramen.synth(shapes, seed, modes, amplitude, correlation, vertices, threads, progress)
    return [(Mesh(p, t), Mesh(tp, tt)) for p, t, tp, tt in made]


def surface_distance(a, b, *, samples=20000, seed=1):
    """Distance of two surfaces, both ways, in mm: a dict of mean, p95 and hausdorff."""
    return _foramen.surface_distance(a.points, a.triangles, b.points, b.triangles, samples, seed)


def extract(inputs, output, *, labels=None, numbering=None, label_names=None, keep_cut=False, repair=False,
            handle_limit=None, hole_limit=None, threads=0, progress=None):
    """Meshes of the labels of label maps, written to a folder; what extract.json holds as a dict.

    labels: e.g. "20-24,3"; numbering: "verse" or "totalsegmentator"; label_names: a CSV file instead.
    """
    options = dict(labels=labels, numbering=numbering, label_names=label_names, keep_cut=keep_cut, repair=repair,
                   handle_limit=handle_limit, hole_limit=hole_limit)
    return _json.loads(_foramen.extract(_paths(inputs), _os.fspath(output), _arguments(options), threads, progress))


def build(inputs, output, *, method=None, objective=None, rounds=None, distortion=None, bending=None, reference=None,
          lambda_=None, landmarks=None, target_error=None, samples=None, seed=None, scale=None, weights=None,
          subject_regex=None, paper=False, initial_map=None, optimiser=None, units=None, numbering=None, labels=None,
          label_names=None, keep_cut=False, repair=False, handle_limit=None, hole_limit=None, truth=None, refit=False,
          resume=False, threads=0, progress=None):
    """A model from surfaces or label maps, with its evaluation and report, written to a folder; the summary as a dict.

    inputs: a path or a list of files and folders. Keywords are the options of `foramen build`, with the same defaults and the
    same results, byte for byte; see `foramen build --help`.
    """
    options = {"method": method, "objective": objective, "rounds": rounds, "distortion": distortion, "bending": bending,
               "reference": reference, "lambda": lambda_, "landmarks": landmarks, "target_error": target_error,
               "samples": samples, "seed": seed, "scale": scale, "weights": weights, "subject_regex": subject_regex,
               "paper": paper, "initial_map": initial_map, "optimiser": optimiser, "units": units,
               "numbering": numbering, "labels": labels, "label_names": label_names, "keep_cut": keep_cut,
               "repair": repair, "handle_limit": handle_limit, "hole_limit": hole_limit, "truth": truth,
               "refit": refit, "resume": resume}
    return _json.loads(_foramen.build(_paths(inputs), _os.fspath(output), _arguments(options), threads, progress))


def evaluate(corresponding, *, shapes=None, truth=None, true_landmarks=None, output=None, samples=1000, seed=1,
             subject_regex="", scale="keep", weights="equal", threads=0, progress=None):
    """Compactness, generalization and specificity of a folder of corresponding meshes from any tool, as a dict.

    shapes: folder of the original surfaces, by the same names; without it distances are to the corresponding meshes.
    """
    if scale not in ("keep", "remove"):
        raise InvalidInput(f"scale must be keep or remove, not {scale}")
    if weights not in ("equal", "area"):
        raise InvalidInput(f"weights must be equal or area, not {weights}")
    return _json.loads(_foramen.evaluate(_os.fspath(corresponding), _path(shapes), _path(truth), _path(true_landmarks),
                                         _path(output), samples, seed, subject_regex, scale == "remove",
                                         weights == "area", threads, progress))


def compare(models):
    """Generalization and specificity of two or more models' folders side by side, with paired tests, as a dict."""
    return _json.loads(_foramen.compare(_paths(models)))


def report(model, output=None, *, baseline=None, plain=False):
    """Writes a model's report.html again, or elsewhere; returns its path."""
    return _foramen.report(_os.fspath(model), _path(output), _path(baseline), plain)
