"""Using a model: sampling, scores, new surfaces, partial surfaces, measures."""

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

    mean (P, 3) mm; triangles (T, 3); variance (K,) mm^2, decreasing, divisor n - 1; basis (P, 3, K), orthonormal in the
    inner product of the weights (P,); names of the n training shapes and their scores (n, K) in standard deviations;
    space.

    A model made in memory also has transforms (n, 4, 4), from each shape's coordinates to the model's; scale and
    landmark_weights, the options with which it was made; and, if build_model() made it, its correspondence, without the
    maps. For a model that was read from files, these are None.
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
        """Reads the model in a folder that build() wrote, or a model.h5 in the statismo layout.

        project(), complete(), and measure() of the training shapes need the folder.
        """
        path = os.fspath(path)
        return cls(_foramen.LoadedModel(path), path)

    @classmethod
    def from_corresponding(cls, points, triangles, *, names=None, scale="keep", weights="equal", space="LPS"):
        """Makes a model of corresponding shapes of any tool: points (n, P, 3) in mm, in any pose, and triangles (T, 3).

        The shapes are aligned by generalized Procrustes analysis, and a PCA gives the modes. The model has no torus
        maps, so project() cannot be used.
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
        """The landmarks (n, P, 3) of the training shapes, in the shapes' own coordinates, mm, for a model made in
        memory."""
        if self._corresponding is None:
            raise InvalidInput("a model that was read has its corresponding shapes in the folder corresponding/ beside it")
        return self._corresponding

    @property
    def modes(self):
        """K, the number of modes."""
        return len(self.variance)

    def mesh(self, points):
        """A Mesh of these landmarks (P, 3) and the model's triangles."""
        return Mesh(np.asarray(points), self.triangles, self.space)

    def reconstruct(self, scores):
        """The shape (P, 3), mm, with these scores (up to K) in standard deviations, or N shapes (N, P, 3) for N rows of
        scores.

        The shapes are in model coordinates, as `foramen reconstruct` writes them. Scores of further modes are 0.
        """
        scores = np.asarray(scores, dtype=float)
        shapes = self._loaded.reconstruct(np.atleast_2d(scores))
        return shapes if scores.ndim > 1 else shapes[0]

    def scores_of(self, points):
        """The scores (K,), in standard deviations, of the model's shape closest to these landmarks (P, 3) in model
        coordinates."""
        return self._loaded.scores_of(points)

    def sample(self, count, seed=1):
        """Random shapes (count, P, 3), mm, equal to those that `foramen sample` writes for the same seed."""
        return self._loaded.sample(count, seed)

    def along_mode(self, mode, sd):
        """The mean plus `sd` standard deviations along a mode (P, 3), mm. Modes are counted from 0."""
        return self._loaded.along_mode(mode, sd)

    def project(self, mesh, *, leave_out=(), threads=0, progress=None):
        """Projects a new closed surface of genus 1 in any pose on the model. The result is a Projection.

        The surface is registered to the mean in the same way as in build(), with the same checks. leave_out: the name
        or names of training shapes; the distance to the model without these shapes is computed as well. The first call
        prepares the mean on `threads` threads. The projection itself uses one thread, so several surfaces can be
        projected at the same time from several threads.
        """
        leave_out = [leave_out] if isinstance(leave_out, str) else list(leave_out)
        if self._projector is None:
            self._projector = _foramen.SurfaceProjector(self._of_folder(), threads, progress)
        points, scores, fit, residual, fit_residual, figures = self._projector.project(mesh.points, mesh.triangles, leave_out,
                                                                                       progress)
        return Projection(points, scores, fit, residual, fit_residual, json.loads(figures))

    def complete(self, mesh, *, noise_mm=0.5, beyond_modes=0.3, options=None, threads=0, progress=None):
        """Completes a partial or damaged surface, open or closed, in any pose, wound outward. The result is a
        Completion.

        noise_mm: standard deviation of the surface from the shape [mm]; beyond_modes: variance of shapes beyond the
        modes, as a share of the smooth process, 0 for the modes alone; options: a dict of all other options, see
        list_options("complete"). Warns if another pose fits nearly as well.
        """
        points, sd, seen, figures, note, posterior = self._of_folder().complete(
            mesh.points, mesh.triangles, mesh.space, noise_mm, beyond_modes, options or {}, threads, progress)
        if note:
            warnings.warn(note + ": look at the result", stacklevel=2)
        return Completion(Mesh(points, self.triangles, mesh.space), sd, seen, json.loads(figures), posterior)

    def measure(self, definitions, shapes=None, *, units=None, progress=None):
        """Measures points, distances and areas, which are defined once on the mean, on many shapes. The result is a
        Measures.

        definitions: a dict or a JSON file of points (a landmark's index or a position [x, y, z] on the mean, mm),
        distances (a pair of points) and regions ({"centre": point, "radius_mm": r} or {"landmarks": [...]}), with any
        names. shapes: landmarks (P, 3) or (N, P, 3) in mm, or mesh files with the model's landmarks and folders of
        them; None: the training shapes. units: the unit of the files, mm, cm, m or um; "mm", if given, also takes
        sizes that no vertebra has.
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
    """The JSON equivalent of numpy's numbers and arrays."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    raise TypeError(f"definitions cannot hold a {type(value).__name__}")


@dataclass
class Projection:
    """The result of Model.project() for a surface of V points, in the surface's coordinates, mm.

    points (P, 3): the landmarks on the surface; scores (K,) in standard deviations; fit (P, 3): the closest shape of
    the model; residual (V,): the distance of each point of the surface to the fit; fit_residual (P,): the distance of
    each landmark of the fit to the surface; figures: the numbers of project.json. These are mean_mm, p95_mm and
    hausdorff_mm of representation (surface to the mesh of its landmarks) and of fit, and left_out and
    fit_without_left_out if shapes are left out.
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

    mesh: the mean of the distribution, with P landmarks; sd (P,): the standard deviation of each landmark; seen (P,)
    bool: whether the landmark was matched with the part; figures: the numbers of complete.json; posterior: the
    distribution as a Model, for example to sample from it.
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
    """The result of Model.measure() for N shapes, by the names of the definitions.

    names: those of the files, empty for arrays; points (N, 3) in each shape's coordinates, mm; distances (N,) mm; areas
    (N,) mm^2.
    """

    names: list
    points: dict
    distances: dict
    areas: dict
