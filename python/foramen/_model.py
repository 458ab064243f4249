"""A finished model and its use: sampling, scores, new surfaces, parts of surfaces, measures."""

import json
import os
import warnings
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from . import _foramen
from ._foramen import InvalidInput
from ._mesh import Mesh
from ._options import given
from ._runs import paths_of
from ._stages import Correspondence


class Model:
    """A statistical shape model x = mean + sum_m scores_m sqrt(variance_m) basis_m.

    mean (P, 3) mm; triangles (T, 3); variance (K,) mm^2, decreasing, divisor n - 1; basis (P, 3, K), orthonormal in the inner
    product of the weights (P,); names of the n training shapes and their scores (n, K) in standard deviations; space.

    A model made in memory also has transforms (n, 4, 4): each shape's coordinates -> the model's; scale and
    landmark_weights, the options that it was made with; and, if build_model() made it, its correspondence, without the
    maps. Of a model that was read these are None.
    """

    def __init__(self, loaded, folder=None):
        self._loaded = loaded
        self._folder = folder
        self._usable = self._projector = self._surfaces = None
        self._corresponding = self.transforms = self.correspondence = self.scale = self.landmark_weights = None
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
        """The model of a folder that build() wrote, or of a model.h5 in the statismo layout.

        project(), complete() and measure() of the training shapes need the folder.
        """
        path = os.fspath(path)
        return cls(_foramen.LoadedModel(path), path)

    @classmethod
    def from_corresponding(cls, points, triangles, *, names=None, scale="keep", weights="equal", space="LPS"):
        """The model of corresponding shapes of any tool: points (n, P, 3) in mm, in any pose; their triangles (T, 3).

        Generalized Procrustes alignment and principal components. It has no maps, so that project() cannot be used.
        """
        points = np.asarray(points)
        names = [f"shape{i + 1:03d}" for i in range(len(points))] if names is None else list(names)
        return cls._of_parts(_foramen.model_of_points(points, triangles, names, space, given(scale=scale, weights=weights)))

    @classmethod
    def _of_parts(cls, parts, surfaces=None):
        model = cls(parts["loaded"])
        model._usable, model._surfaces = parts["usable"], surfaces
        model._corresponding, model.transforms = parts["corresponding"], parts["transforms"]
        model.scale, model.landmark_weights = parts["scale"], parts["landmark_weights"]
        if "registration" in parts:
            model.correspondence = Correspondence(**parts["registration"])
        return model

    @property
    def corresponding(self):
        """The landmarks (n, P, 3) of the training shapes, each in its own coordinates, mm, of a model made in memory."""
        if self._corresponding is None:
            raise InvalidInput("a model that was read has its corresponding shapes in the folder corresponding/ beside it")
        return self._corresponding

    @property
    def modes(self):
        """K, the number of modes."""
        return len(self.variance)

    def mesh(self, points):
        """Landmarks (P, 3) as a Mesh of the model's triangles."""
        return Mesh(np.asarray(points), self.triangles, self.space)

    def reconstruct(self, scores):
        """The shape (P, 3), mm, of up to K scores in standard deviations; of N rows of them, the shapes (N, P, 3).

        In model coordinates, as `foramen reconstruct` writes them; modes without a score are 0.
        """
        scores = np.asarray(scores, dtype=float)
        shapes = self._loaded.reconstruct(np.atleast_2d(scores))
        return shapes if scores.ndim > 1 else shapes[0]

    def scores_of(self, points):
        """Scores (K,), in standard deviations, of landmarks (P, 3) in the model's frame: those of the closest shape."""
        return self._loaded.scores_of(points)

    def sample(self, count, seed=1):
        """Random shapes (count, P, 3), mm: those that `foramen sample` writes for the same seed."""
        return self._loaded.sample(count, seed)

    def along_mode(self, mode, sd):
        """The mean +- sd standard deviations (P, 3), mm, along a mode counted from 0."""
        return self._loaded.along_mode(mode, sd)

    def project(self, mesh, *, leave_out=(), threads=0, progress=None):
        """What the model says of a new surface, closed, of genus 1, in any pose, as a Projection.

        The surface is registered to the mean as build() does it, with the same checks. leave_out: a name or names of training
        shapes to leave out of the model for a second distance. The first call prepares the mean, on `threads` threads; a
        surface takes one, so that several can be projected at a time from threads of your own.
        """
        leave_out = [leave_out] if isinstance(leave_out, str) else list(leave_out)
        if self._projector is None:
            self._projector = _foramen.SurfaceProjector(self._of_folder(), threads, progress)
        points, scores, fit, residual, fit_residual, figures = self._projector.project(mesh.points, mesh.triangles, leave_out,
                                                                                       progress)
        return Projection(points, scores, fit, residual, fit_residual, json.loads(figures))

    def complete(self, mesh, *, noise_mm=0.5, beyond_modes=0.3, options=None, threads=0, progress=None):
        """The whole of a partial or damaged surface, open or closed, in any pose, wound outward, as a Completion.

        noise_mm: standard deviation of the surface about the shape [mm]; beyond_modes: variance of smooth displacements that no
        mode has, as a share of the prior's, 0 for the modes alone; options: a dict for all others, see
        list_options("complete"). Warns if another pose fits nearly as well.
        """
        points, sd, seen, figures, note, posterior = self._of_folder().complete(
            mesh.points, mesh.triangles, mesh.space, noise_mm, beyond_modes, options or {}, threads, progress)
        if note:
            warnings.warn(note + ": look at the result", stacklevel=2)
        return Completion(Mesh(points, self.triangles, mesh.space), sd, seen, json.loads(figures), posterior)

    def measure(self, definitions, shapes=None, *, units="mm", progress=None):
        """Points, distances and areas defined once on the mean, taken on many shapes, as Measures.

        definitions: a dict, or a JSON file, of points (a landmark's index or a position [x, y, z] on the mean, mm), distances
        (a pair of points) and regions ({"centre": point, "radius_mm": r} or {"landmarks": [...]}), by names of your choice.
        shapes: landmarks (P, 3) or (N, P, 3) in mm; or mesh files with the model's landmarks, and folders of them; None: the
        training shapes. units: of files.
        """
        if isinstance(definitions, dict):
            file, text = "", json.dumps(definitions, default=_plain)
        else:
            file, text = os.fspath(definitions), ""
        if isinstance(shapes, np.ndarray):
            shapes = shapes[np.newaxis] if shapes.ndim == 2 else shapes
            return Measures([], *_foramen.measure_landmarks(self._loaded, file, text, shapes, progress))
        if shapes is None and self._corresponding is not None:
            measured = _foramen.measure_landmarks(self._loaded, file, text, self._corresponding, progress)
            return Measures(self.names, *measured)
        inputs = [os.path.join(self._needed_folder(), "corresponding")] if shapes is None else paths_of(shapes)
        return Measures(*_foramen.measure_meshes(self._loaded, file, text, inputs, units, progress))

    def _needed_folder(self):
        if self._folder is None:
            raise InvalidInput("this model is of no folder that build() wrote; load one that is")
        return self._folder

    def _of_folder(self):
        if self._usable is None:
            self._usable = _foramen.UsableModel(self._loaded, self._needed_folder())
        return self._usable


def _plain(value):
    """What JSON has for numpy's numbers and arrays."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    raise TypeError(f"definitions cannot hold a {type(value).__name__}")


@dataclass
class Projection:
    """What Model.project() says of a surface of V points, in its coordinates, mm.

    points (P, 3): its landmarks; scores (K,) in standard deviations; fit (P, 3): the closest shape that the model has;
    residual (V,): distance of each of its points to the fit; fit_residual (P,): of each landmark of the fit to the surface;
    figures: the numbers of project.json: representation (surface to its landmarks' mesh) and fit, mean_mm, p95_mm, hausdorff_mm;
    if shapes are left out, left_out and fit_without_left_out.
    """

    points: np.ndarray
    scores: np.ndarray
    fit: np.ndarray
    residual: np.ndarray
    fit_residual: np.ndarray
    figures: dict


@dataclass
class Completion:
    """The distribution of whole shapes given a part, in the part's coordinates, mm.

    mesh: its mean, P landmarks; sd (P,): standard deviation of each landmark; seen (P,) bool: whether it was matched with the
    part; figures: the numbers of complete.json; posterior: the distribution as a Model, to sample for example.
    """

    mesh: Mesh
    sd: np.ndarray
    seen: np.ndarray
    figures: dict
    _posterior: object = field(repr=False)

    @property
    def points(self):
        """The mean's landmarks (P, 3), mm."""
        return self.mesh.points

    @cached_property
    def posterior(self):
        """The distribution as a Model, in the part's coordinates."""
        return Model(self._posterior)


@dataclass
class Measures:
    """What Model.measure() takes on N shapes, by the names of the definitions.

    names: of the files, none for arrays; points (N, 3) in each shape's coordinates, mm; distances (N,) mm; areas (N,) mm^2.
    """

    names: list
    points: dict
    distances: dict
    areas: dict
