from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from os import PathLike
from typing import Any, Literal, Optional, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

Path = Union[str, "PathLike[str]"]
Paths = Union[Path, Iterable[Path]]
Progress = Optional[Callable[[str, float, str], object]]
Space = Literal["LPS", "RAS"]
Floats = NDArray[np.float64]
Ints = NDArray[np.int32]
Options = Optional[Mapping[str, Any]]
AnyMark = Union[ArrayLike, tuple[Literal["point", "open", "closed"], ArrayLike]]

__version__: str

class Error(Exception): ...
class Cancelled(Error): ...
class ConvergenceError(Error): ...
class IoError(Error): ...
class InvalidInput(Error): ...
class TopologyError(InvalidInput): ...

class Method(str, Enum):
    TORUS = "torus"
    ICP = "icp"

class Objective(str, Enum):
    SURFACE = "surface"
    NEIGHBOURS = "neighbours"
    DESCRIPTION = "description"

class Distortion(str, Enum):
    TEMPLATE = "template"
    PLANE = "plane"

class Bending(str, Enum):
    COHORT = "cohort"
    SMOOTH = "smooth"
    RIGID = "rigid"

class Scale(str, Enum):
    KEEP = "keep"
    REMOVE = "remove"

class Weights(str, Enum):
    EQUAL = "equal"
    AREA = "area"

class InitialMap(str, Enum):
    TORUS = "torus"
    RECTANGLE = "rectangle"

class Optimiser(str, Enum):
    NEWTON = "newton"
    POLAK_RIBIERE = "polak-ribiere"

AnyMethod = Union[Method, Literal["torus", "icp"]]
AnyObjective = Union[Objective, Literal["surface", "neighbours", "description"]]
AnyDistortion = Union[Distortion, Literal["template", "plane"]]
AnyBending = Union[Bending, Literal["cohort", "smooth", "rigid"]]
AnyScale = Union[Scale, Literal["keep", "remove"]]
AnyWeights = Union[Weights, Literal["equal", "area"]]
AnyInitialMap = Union[InitialMap, Literal["torus", "rectangle"]]
AnyOptimiser = Union[Optimiser, Literal["newton", "polak-ribiere"]]

@dataclass(frozen=True)
class Option:
    path: str
    kind: str
    unit: str
    default: Any
    range: str
    words: tuple[str, ...]
    meaning: str

@dataclass
class Mesh:
    points: NDArray[np.float64]
    triangles: NDArray[np.int32]
    space: str = "LPS"

Shapes = Union[Sequence[Mesh], Mapping[str, Mesh]]

@dataclass
class Repaired:
    mesh: Mesh
    origin: NDArray[np.int32]
    report: dict[str, Any]

@dataclass
class Projection:
    points: NDArray[np.float64]
    scores: NDArray[np.float64]
    fit: NDArray[np.float64]
    residual: NDArray[np.float64]
    fit_residual: NDArray[np.float64]
    figures: dict[str, Any]

class Completion:
    mesh: Mesh
    sd: NDArray[np.float64]
    seen: NDArray[np.bool_]
    figures: dict[str, Any]
    @property
    def points(self) -> NDArray[np.float64]: ...
    @property
    def posterior(self) -> Model: ...

@dataclass
class Measures:
    names: list[str]
    points: dict[str, NDArray[np.float64]]
    distances: dict[str, NDArray[np.float64]]
    areas: dict[str, NDArray[np.float64]]

@dataclass(frozen=True)
class ShapeRegistration:
    name: str
    alignment: Floats
    alignment_residual: float
    mapped: bool
    flipped: int
    iterations: int
    initial_energy: float
    final_energy: float
    distortion: float
    agreement: Floats
    seconds: float

class Correspondence:
    method: str
    reference: str
    shapes: list[ShapeRegistration]
    failed: list[tuple[str, str]]
    refused_references: list[tuple[str, str]]
    template_motion: list[float]
    unexplained_shares: list[float]
    description_lengths: list[float]
    @property
    def names(self) -> list[str]: ...

@dataclass(frozen=True)
class Landmarks:
    names: list[str]
    points: Floats
    triangles: Ints
    turns: Floats
    inserted: int
    remaining_flips: int
    remaining_self_intersections: int

@dataclass(frozen=True)
class Estimates:
    mean: Floats
    standard_error: Floats
    values: Optional[Floats] = None

@dataclass(frozen=True)
class ModelErrors:
    modes: Ints
    hausdorff: Estimates
    mean_surface: Estimates
    landmark_rms: Estimates

@dataclass(frozen=True)
class Compactness:
    modes: Ints
    variance_per_landmark: Floats
    fraction: Floats

@dataclass(frozen=True)
class Ensemble:
    modes: Ints
    generalization: Estimates
    specificity: Estimates

@dataclass(frozen=True)
class DrawnShapes:
    self_intersections: Ints
    folded: Ints
    opposing_mean: Ints

@dataclass(frozen=True)
class Representation:
    mean: Floats
    p95: Floats
    hausdorff: Floats
    plain_flips: Ints
    confirmed_flips: Ints
    degenerate: Ints
    opposing_mean: Ints
    self_intersections: Ints
    input_self_intersections: Ints

@dataclass(frozen=True)
class TruthError:
    error: dict[str, float]
    floor: dict[str, float]
    mean_from_shape: Floats

@dataclass(frozen=True)
class Evaluation:
    names: list[str]
    subjects: list[str]
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
    marks: Optional[dict[str, Any]]
    regions: Optional[dict[str, Any]]

class Model:
    mean: NDArray[np.float64]
    triangles: NDArray[np.int32]
    variance: NDArray[np.float64]
    basis: NDArray[np.float64]
    weights: NDArray[np.float64]
    names: list[str]
    scores: NDArray[np.float64]
    space: str
    transforms: Optional[Floats]
    correspondence: Optional[Correspondence]
    scale: Optional[str]
    landmark_weights: Optional[str]
    @classmethod
    def load(cls, path: Path) -> Model: ...
    @classmethod
    def from_corresponding(cls, points: ArrayLike, triangles: ArrayLike, *, names: Optional[Iterable[str]] = None,
                           scale: AnyScale = "keep", weights: AnyWeights = "equal", space: Space = "LPS") -> Model: ...
    @property
    def corresponding(self) -> Floats: ...
    @property
    def modes(self) -> int: ...
    def mesh(self, points: ArrayLike) -> Mesh: ...
    def reconstruct(self, scores: ArrayLike) -> NDArray[np.float64]: ...
    def scores_of(self, points: ArrayLike) -> NDArray[np.float64]: ...
    def sample(self, count: int, seed: int = 1) -> NDArray[np.float64]: ...
    def along_mode(self, mode: int, sd: float) -> NDArray[np.float64]: ...
    def project(self, mesh: Mesh, *, leave_out: Union[str, Iterable[str]] = (), threads: int = 0,
                progress: Progress = None) -> Projection: ...
    def complete(self, mesh: Mesh, *, noise_mm: float = 0.5, beyond_modes: float = 0.3, options: Options = None,
                 threads: int = 0, progress: Progress = None) -> Completion: ...
    def measure(self, definitions: Union[Path, dict[str, Any]], shapes: Union[NDArray[Any], Paths, None] = None, *,
                units: Optional[str] = None, progress: Progress = None) -> Measures: ...

def read_mesh(path: Path) -> Mesh: ...
def write_mesh(path: Path, mesh: Mesh) -> None: ...
def inspect(mesh: Mesh) -> dict[str, Any]: ...
def repair(mesh: Mesh, *, handle_limit: float = 12.0, hole_limit: float = 20.0, threads: int = 0,
           progress: Progress = None) -> Repaired: ...
def synth(shapes: int = 14, *, seed: int = 1, deformation: Literal["smooth", "rough"] = "smooth", modes: int = 4,
          amplitude: float = 2.1, correlation: float = 40.0, vertices: int = 10000, threads: int = 0,
          progress: Progress = None) -> list[tuple[Mesh, Mesh]]: ...
def surface_distance(a: Mesh, b: Mesh, *, samples: int = 20000, seed: int = 1) -> dict[str, float]: ...
def extract(inputs: Paths, output: Path, *, labels: Optional[str] = None, numbering: Optional[str] = None,
            label_names: Optional[Path] = None, keep_cut: bool = False, repair: bool = False,
            handle_limit: Optional[float] = None, hole_limit: Optional[float] = None, threads: int = 0,
            progress: Progress = None) -> dict[str, Any]: ...
def build(inputs: Paths, output: Path, *, method: Optional[AnyMethod] = None, objective: Optional[AnyObjective] = None,
          rounds: Optional[int] = None,
          distortion: Optional[AnyDistortion] = None, bending: Optional[AnyBending] = None, reference: Optional[str] = None,
          lambda_: Optional[float] = None, landmarks: Optional[int] = None, target_error: Optional[float] = None,
          samples: Optional[int] = None, seed: Optional[int] = None, scale: Optional[AnyScale] = None,
          weights: Optional[AnyWeights] = None, subject_regex: Optional[str] = None, paper: bool = False,
          initial_map: Optional[AnyInitialMap] = None, optimiser: Optional[AnyOptimiser] = None,
          units: Optional[str] = None, numbering: Optional[str] = None, labels: Optional[str] = None,
          label_names: Optional[Path] = None, keep_cut: bool = False, repair: bool = False,
          handle_limit: Optional[float] = None, hole_limit: Optional[float] = None, truth: Optional[Path] = None,
          refit: bool = False, resume: bool = False, store: Optional[Path] = None, threads: int = 0,
          progress: Progress = None) -> dict[str, Any]: ...
def correspond(shapes: Shapes, *, names: Optional[Iterable[str]] = None, method: Optional[AnyMethod] = None,
               objective: Optional[AnyObjective] = None, rounds: Optional[int] = None,
               distortion: Optional[AnyDistortion] = None, bending: Optional[AnyBending] = None,
               reference: Optional[str] = None,
               lambda_: Optional[float] = None, paper: bool = False,
               initial_map: Optional[AnyInitialMap] = None, optimiser: Optional[AnyOptimiser] = None, options: Options = None,
               threads: int = 0, progress: Progress = None) -> Correspondence: ...
def place_landmarks(shapes: Shapes, correspondence: Correspondence, *, names: Optional[Iterable[str]] = None,
                    landmarks: Optional[int] = None, target_error: Optional[float] = None, seed: Optional[int] = None,
                    scale: Optional[AnyScale] = None, options: Options = None, threads: int = 0,
                    progress: Progress = None) -> Landmarks: ...
def build_model(shapes: Shapes, *, names: Optional[Iterable[str]] = None, correspondence: Optional[Correspondence] = None,
                method: Optional[AnyMethod] = None, objective: Optional[AnyObjective] = None, rounds: Optional[int] = None,
                distortion: Optional[AnyDistortion] = None, bending: Optional[AnyBending] = None,
                reference: Optional[str] = None,
                lambda_: Optional[float] = None, landmarks: Optional[int] = None, target_error: Optional[float] = None,
                seed: Optional[int] = None, scale: Optional[AnyScale] = None, weights: Optional[AnyWeights] = None,
                paper: bool = False, initial_map: Optional[AnyInitialMap] = None, optimiser: Optional[AnyOptimiser] = None,
                options: Options = None, threads: int = 0, progress: Progress = None) -> Model: ...
def list_options(function: Union[str, Callable[..., object]]) -> list[Option]: ...
@overload
def evaluate(corresponding: Union[Model, Shapes], *, names: Optional[Iterable[str]] = None, shapes: Optional[Shapes] = None,
             truth: Optional[Shapes] = None, marks: Optional[Mapping[str, Mapping[str, AnyMark]]] = None,
             regions: Optional[Mapping[str, ArrayLike]] = None, true_landmarks: None = None, output: None = None,
             units: None = None,
             samples: Optional[int] = None, seed: Optional[int] = None, subjects: Optional[Iterable[str]] = None,
             subject_regex: str = "", scale: Optional[AnyScale] = None, weights: Optional[AnyWeights] = None,
             options: Options = None, threads: int = 0, progress: Progress = None) -> Evaluation: ...
@overload
def evaluate(corresponding: Path, *, names: None = None, shapes: Optional[Path] = None, truth: Optional[Path] = None,
             marks: Optional[Paths] = None, regions: Optional[Paths] = None, true_landmarks: Optional[Path] = None, output: Optional[Path] = None, units: Optional[str] = None,
             samples: Optional[int] = None, seed: Optional[int] = None, subjects: None = None, subject_regex: str = "",
             scale: Optional[AnyScale] = None, weights: Optional[AnyWeights] = None, options: Options = None,
             threads: int = 0, progress: Progress = None) -> dict[str, Any]: ...
def compare(models: Sequence[Path]) -> dict[str, Any]: ...
def report(model: Path, output: Optional[Path] = None, *, baseline: Optional[Path] = None,
           plain: bool = False) -> str: ...
def convert(input: Path, output: Path, *, to: Optional[str] = None, units: Optional[str] = None,
            triangles: Optional[Path] = None, scale: Optional[str] = None, threads: int = 0,
            progress: Progress = None) -> dict[str, Any]: ...
def render(model: Path, output: Path, *, baseline: Optional[Path] = None, only_curves: bool = False) -> dict[str, str]: ...
