"""The measures of a model."""

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Optional

import numpy as np

from . import _foramen
from ._foramen import InvalidInput
from ._mesh import Mesh
from ._model import Model
from ._options import given
from ._stages import given_shapes, named


@dataclass(frozen=True)
class Estimates:
    """A measure at M numbers of modes: mean (M,), standard_error (M,), and the single values (M, items) if they are
    known."""

    mean: np.ndarray
    standard_error: np.ndarray
    values: Optional[np.ndarray] = None


@dataclass(frozen=True)
class ModelErrors:
    """Distances between shapes of a model and surfaces, mm, at M numbers of modes (M,)."""

    modes: np.ndarray
    hausdorff: Estimates
    mean_surface: Estimates
    landmark_rms: Estimates


@dataclass(frozen=True)
class Compactness:
    """The variance of the first modes (M,): per landmark [mm^2], and as a fraction of the total variance."""

    modes: np.ndarray
    variance_per_landmark: np.ndarray
    fraction: np.ndarray


@dataclass(frozen=True)
class Ensemble:
    """The paper's form of both measures: Hausdorff distances of an ensemble of draws and the training set, mm."""

    modes: np.ndarray
    generalization: Estimates
    specificity: Estimates


@dataclass(frozen=True)
class DrawnShapes:
    """Counts for each of D shapes drawn within 2 standard deviations (D,): self-intersections, triangles that are
    folded over, and triangles that oppose the mean's."""

    self_intersections: np.ndarray
    folded: np.ndarray
    opposing_mean: np.ndarray


@dataclass(frozen=True)
class Representation:
    """For each shape (N,): the distances between its corresponding mesh and its surface, mm, and the defects of the
    mesh."""

    mean: np.ndarray
    p95: np.ndarray
    hausdorff: np.ndarray
    plain_flips: np.ndarray
    confirmed_flips: np.ndarray
    degenerate: np.ndarray
    opposing_mean: np.ndarray
    self_intersections: np.ndarray
    input_self_intersections: np.ndarray


@dataclass(frozen=True)
class TruthError:
    """Distance to the true correspondence, mm: mean, p95 and max, the same for perfect landmarks (floor), and means by
    shape."""

    error: dict
    floor: dict
    mean_from_shape: np.ndarray


@dataclass(frozen=True)
class Evaluation:
    """All measures of N shapes in correspondence, as docs/evaluation.md defines them.

    total_variance is per landmark [mm^2]. generalization leaves out one shape at a time and has one value per shape;
    generalization_by_subject leaves out all shapes of a subject. specificity has one value per drawn shape. marks and
    regions are dicts, those of metrics.json.
    """

    names: list
    subjects: list
    landmarks: int
    total_variance: float
    compactness: Compactness
    generalization: ModelErrors
    generalization_by_subject: Optional[ModelErrors]
    specificity: ModelErrors
    ensemble: Ensemble
    drawn: DrawnShapes
    representation: Representation
    truth: Optional[TruthError]
    marks: Optional[dict]
    regions: Optional[dict]


def _errors(record):
    return record and ModelErrors(record["modes"], *(Estimates(**record[name])
                                                     for name in ("hausdorff", "mean_surface", "landmark_rms")))


def _evaluation(record):
    ensemble = record["ensemble"]
    return Evaluation(**{**record, "compactness": Compactness(**record["compactness"]),
                         "generalization": _errors(record["generalization"]),
                         "generalization_by_subject": _errors(record["generalization_by_subject"]),
                         "specificity": _errors(record["specificity"]),
                         "ensemble": Ensemble(ensemble["modes"], Estimates(**ensemble["generalization"]),
                                              Estimates(**ensemble["specificity"])),
                         "drawn": DrawnShapes(**record["drawn"]),
                         "representation": Representation(**record["representation"]),
                         "truth": record["truth"] and TruthError(**record["truth"]),
                         "marks": record["marks"] and json.loads(record["marks"]),
                         "regions": record["regions"] and json.loads(record["regions"])})


def _in_correspondence(meshes):
    """The points (N, P, 3) and the triangles of meshes with the same triangles."""
    if not meshes:
        raise InvalidInput("there are no shapes")
    for mesh in meshes:
        if np.shape(mesh.points) != np.shape(meshes[0].points) or not np.array_equal(mesh.triangles, meshes[0].triangles):
            raise InvalidInput("the meshes are not in correspondence: their points or triangles differ")
    return np.stack([mesh.points for mesh in meshes]), meshes[0].triangles


def _true_correspondence(truth, names):
    if truth is None:
        return None
    if isinstance(truth, Mapping):
        missing = [name for name in names if name not in truth]
        if missing:
            raise InvalidInput(f"truth: there is no shape {missing[0]}")
        truth = [truth[name] for name in names]
    return _in_correspondence(list(truth))


def _of_shapes(given, names, what):
    """The values of a mapping from names of shapes in the order of the names; None for a shape without one."""
    if not isinstance(given, Mapping):
        raise TypeError(f"{what} must be a mapping from names of shapes, not {type(given).__name__}")
    unknown = [name for name in given if name not in names]
    if unknown:
        raise InvalidInput(f"{what}: there is no shape {unknown[0]}")
    return [given.get(name) for name in names]


def _mark(name, given):
    """A mark as name, kind and points (P, 3)."""
    kind, points = given if isinstance(given, tuple) else (None, given)
    points = np.asarray(points, dtype=float)
    if kind is None:
        kind = "point" if points.ndim == 1 else "open"
    points = np.atleast_2d(points)
    if points.shape[1:] != (3,):
        raise InvalidInput(f"the mark '{name}' must be a point (3,) or a curve (P, 3)")
    return name, kind, points


def _paths(given):
    if given is None:
        return []
    return [os.fspath(path) for path in ([given] if isinstance(given, (str, os.PathLike)) else given)]


def evaluate(corresponding, *, names=None, shapes=None, truth=None, marks=None, regions=None, true_landmarks=None, output=None,
             units=None, samples=None, seed=None, subjects=None, subject_regex="", scale=None, weights=None, options=None,
             threads=0, progress=None):
    """Computes compactness, generalization, specificity and other measures of corresponding shapes of any tool.

    In memory: corresponding is a Model, or Mesh objects with the same triangles (a sequence with names, or a mapping
    from names to them). The result is an Evaluation. shapes: the original surfaces, under the same names. Without them,
    distances are measured to the surfaces from which the model was built, or to the corresponding meshes if these are
    unknown. truth: the true correspondence, as Mesh objects with the same triangles, in the same order or under the
    same names. marks: {shape: {name: points}}, where points (3,) are a point and (P, 3) an open curve; a tuple
    ("closed", points) is a closed one. regions: {shape: labels (V,)}, a whole number for each vertex of the shape's
    surface; 0 is no region. subjects: one per shape.

    From files: corresponding is a folder of meshes. The result is a dict with the contents of metrics.json. shapes and
    truth: folders of meshes with the same names; marks and regions: files or folders, one or a sequence;
    true_landmarks and output: folders to write to. units: the unit of all these meshes and marks, mm, cm, m or um;
    "mm", if given, also takes sizes that no vertebra has.

    samples, seed, subject_regex, scale and weights: as for build(); the defaults for a Model are its own scale and
    weights. options: a dict of all other options, see list_options("evaluate").
    """
    settings = {"draws": samples, "seed": seed, "scale": scale, "landmark_weights": weights}
    settings = {**given(**settings), **(options or {})}
    if isinstance(corresponding, (str, os.PathLike)):
        if names is not None or subjects is not None:
            raise InvalidInput("names and subjects are of shapes in memory; a folder's are named by their files")
        paths = ["" if path is None else os.fspath(path) for path in (shapes, truth, true_landmarks, output)]
        return json.loads(_foramen.evaluate_folder(os.fspath(corresponding), *paths, _paths(marks), _paths(regions), units,
                                                   subject_regex, settings, threads, progress))
    if true_landmarks is not None or output is not None or units is not None:
        raise InvalidInput("true_landmarks, output and units are for folders; the shapes given are in memory and in mm")
    if subjects is not None and subject_regex:
        raise InvalidInput("subjects and subject_regex exclude each other; leave one of them out")
    surfaces = None
    if isinstance(corresponding, Model):
        model = corresponding
        names, points, triangles, surfaces = model.names, model.corresponding, model.triangles, model._surfaces
        settings = {"scale": model.scale, "landmark_weights": model.landmark_weights, **settings}
    else:
        names, meshes = named(corresponding, names)
        points, triangles = _in_correspondence(meshes)
    if shapes is not None:
        surfaces = given_shapes(shapes, None if isinstance(shapes, Mapping) else names, threads)
    given_marks = [] if marks is None else [[_mark(*mark) for mark in (of_shape or {}).items()]
                                            for of_shape in _of_shapes(marks, names, "marks")]
    labels = [] if regions is None else [[] if of_shape is None else np.asarray(of_shape).tolist()
                                         for of_shape in _of_shapes(regions, names, "regions")]
    return _evaluation(_foramen.evaluate_in_memory(names, points, triangles, surfaces, list(subjects or []), subject_regex,
                                                   _true_correspondence(truth, names), given_marks, labels, settings, threads,
                                                   progress))
