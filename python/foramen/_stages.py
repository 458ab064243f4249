"""The stages of a build as functions, from surfaces in memory to a model."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from . import _foramen
from ._foramen import InvalidInput
from ._mesh import Mesh
from ._options import given


def named(shapes, names=None):
    """The names and the meshes of a mapping from names to Mesh objects, or of a sequence of them."""
    if isinstance(shapes, Mapping):
        if names is not None:
            raise InvalidInput("names are given twice: the shapes are a mapping, which has names of its own")
        names, shapes = list(shapes), list(shapes.values())
    else:
        shapes = list(shapes)
        names = [f"shape{i + 1:03d}" for i in range(len(shapes))] if names is None else list(names)
    if len(names) != len(shapes):
        raise InvalidInput(f"{len(names)} names for {len(shapes)} shapes")
    for name in names:
        if not isinstance(name, str) or not name:
            raise TypeError(f"a shape's name must be a string, not {name!r}")
    if len(set(names)) < len(names):
        raise InvalidInput("two shapes have the same name: " + next(name for name in names if names.count(name) > 1))
    for name, mesh in zip(names, shapes):
        if not isinstance(mesh, Mesh):
            raise TypeError(f"{name} must be a Mesh, not {type(mesh).__name__}")
    return names, shapes


def given_shapes(shapes, names, threads):
    """The shapes in the form that the extension takes."""
    names, meshes = named(shapes, names)
    return _foramen.Shapes(names, [mesh.points for mesh in meshes], [mesh.triangles for mesh in meshes],
                           [mesh.space for mesh in meshes], threads, None)


@dataclass(frozen=True)
class ShapeRegistration:
    """How a shape was brought into correspondence.

    alignment (4, 4): from the shape's coordinates to the reference's; alignment_residual [mm]; mapped: whether the
    shape has a map (with method "icp", only the reference has one); flipped: flipped triangles of the map, always 0;
    iterations; energies; distortion: mean of Degener's energy, at least 4; agreement (2,): agreement of the map's
    directions with the reference's, near 1; seconds.
    """

    name: str
    alignment: np.ndarray
    alignment_residual: float
    mapped: bool
    flipped: int
    iterations: int
    initial_energy: float
    final_energy: float
    distortion: float
    agreement: np.ndarray
    seconds: float


@dataclass
class Correspondence:
    """The correspondence of all shapes of a cohort, made by correspond().

    method; reference: the name of a shape; shapes: one ShapeRegistration per shape, in the given order; failed and
    refused_references: (name, reason) of each shape that is left out, or that cannot be the reference; template_motion:
    RMS motion of the mean in each round [mm]; unexplained_shares and description_lengths: one per round.
    """

    method: str
    reference: str
    shapes: list
    failed: list
    refused_references: list
    template_motion: list
    unexplained_shares: list
    description_lengths: list
    _made: object = field(default=None, repr=False, compare=False)

    def __post_init__(self):
        self.shapes = [ShapeRegistration(**shape) for shape in self.shapes]

    @property
    def names(self):
        """The names of the shapes in the correspondence."""
        return [shape.name for shape in self.shapes]


@dataclass(frozen=True)
class Landmarks:
    """Landmarks on all N shapes of a correspondence, made by place_landmarks().

    names; points (N, P, 3) on each surface, in its own coordinates, mm; triangles (T, 3) of all shapes; turns (P, 2):
    torus positions; inserted: number of landmarks added to correct triangles; remaining_flips and
    remaining_self_intersections: defects that could not be corrected.
    """

    names: list
    points: np.ndarray
    triangles: np.ndarray
    turns: np.ndarray
    inserted: int
    remaining_flips: int
    remaining_self_intersections: int


def correspond(shapes, *, names=None, method=None, objective=None, rounds=None, distortion=None, bending=None, reference=None,
               lambda_=None, paper=False, initial_map=None, optimiser=None, options=None, threads=0, progress=None):
    """Brings surfaces into correspondence. The result is a Correspondence.

    shapes: a sequence of Mesh objects, closed, of genus 1, in mm, or a mapping from names to them; names: of a
    sequence, by default shape001 and so on. A shape that cannot be used is left out, with the reason in `failed`.

    Keywords are those of build(); options: a dict of all other options, see list_options("correspond").
    """
    chosen = given(method=method, objective=objective, rounds=rounds, distortion=distortion, bending=bending,
                   reference=reference, lambda_=lambda_, paper=paper, initial_map=initial_map, optimiser=optimiser)
    made, record = _foramen.correspond(given_shapes(shapes, names, threads), chosen, options or {}, threads, progress)
    return Correspondence(**record, _made=made)


def _made_of(correspondence):
    if not isinstance(correspondence, Correspondence):
        raise TypeError(f"correspondence must be a Correspondence, not {type(correspondence).__name__}")
    if correspondence._made is None:
        raise InvalidInput("this correspondence is a model's, without its maps; make one with correspond()")
    return correspondence._made


def place_landmarks(shapes, correspondence, *, names=None, landmarks=None, target_error=None, seed=None, scale=None,
                    options=None, threads=0, progress=None):
    """Chooses landmarks on the mean of all shapes and places them on every shape. The result is a Landmarks.

    shapes: the shapes of the correspondence, under the same names. options: see list_options("place_landmarks").
    """
    chosen = given(landmarks=landmarks, target_error=target_error, seed=seed, scale=scale)
    return Landmarks(**_foramen.place_landmarks(given_shapes(shapes, names, threads), _made_of(correspondence), chosen,
                                                options or {}, threads, progress))


def build_model(shapes, *, names=None, correspondence=None, method=None, objective=None, rounds=None, distortion=None,
                bending=None, reference=None, lambda_=None, landmarks=None, target_error=None, seed=None, scale=None,
                weights=None, paper=False, initial_map=None, optimiser=None, options=None, threads=0, progress=None):
    """Builds a Model from surfaces in memory.

    Its numbers are those that build() writes for the same surfaces in the order of their names.

    shapes: a sequence of Mesh objects, closed, of genus 1, in mm, or a mapping from names to them; names: of a
    sequence, by default shape001 and so on. correspondence: the Correspondence of these shapes, if it has already been
    computed. Shapes that are left out are listed in `model.correspondence.failed`.

    Keywords are those of build(), with the same defaults; options: a dict of all other options, see
    list_options("build_model").
    """
    from ._model import Model

    chosen = given(method=method, objective=objective, rounds=rounds, distortion=distortion, bending=bending,
                   reference=reference, lambda_=lambda_, landmarks=landmarks, target_error=target_error, seed=seed,
                   scale=scale, weights=weights, paper=paper, initial_map=initial_map, optimiser=optimiser)
    surfaces = given_shapes(shapes, names, threads)
    made = None if correspondence is None else _made_of(correspondence)
    parts = _foramen.build_model(surfaces, made, chosen, options or {}, threads, progress)
    return Model._of_parts(parts, surfaces)
