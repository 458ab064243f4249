from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from os import PathLike
from typing import Any, Literal, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

Path = Union[str, "PathLike[str]"]
Paths = Union[Path, Iterable[Path]]
Progress = Optional[Callable[[str, float, str], object]]
Space = Literal["LPS", "RAS"]

__version__: str

class Error(Exception): ...
class Cancelled(Error): ...
class ConvergenceError(Error): ...
class IoError(Error): ...
class InvalidInput(Error): ...
class TopologyError(InvalidInput): ...

@dataclass
class Mesh:
    points: NDArray[np.float64]
    triangles: NDArray[np.int32]
    space: str = "LPS"

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

class Model:
    mean: NDArray[np.float64]
    triangles: NDArray[np.int32]
    variance: NDArray[np.float64]
    basis: NDArray[np.float64]
    weights: NDArray[np.float64]
    names: list[str]
    scores: NDArray[np.float64]
    space: str
    @classmethod
    def load(cls, path: Path) -> Model: ...
    @property
    def modes(self) -> int: ...
    def mesh(self, points: ArrayLike) -> Mesh: ...
    def reconstruct(self, scores: ArrayLike) -> NDArray[np.float64]: ...
    def scores_of(self, points: ArrayLike) -> NDArray[np.float64]: ...
    def sample(self, count: int, seed: int = 1) -> NDArray[np.float64]: ...
    def along_mode(self, mode: int, sd: float) -> NDArray[np.float64]: ...
    def project(self, mesh: Mesh, *, leave_out: Union[str, Iterable[str]] = (), threads: int = 0,
                progress: Progress = None) -> Projection: ...
    def complete(self, mesh: Mesh, *, noise_mm: float = 0.5, beyond_modes: float = 0.3, threads: int = 0,
                 progress: Progress = None) -> Completion: ...
    def measure(self, definitions: Union[Path, dict[str, Any]], shapes: Union[NDArray[Any], Paths, None] = None, *,
                units: str = "mm", progress: Progress = None) -> Measures: ...

def read_mesh(path: Path) -> Mesh: ...
def write_mesh(path: Path, mesh: Mesh) -> None: ...
def inspect(mesh: Mesh) -> dict[str, Any]: ...
def repair(mesh: Mesh, *, handle_limit: float = 12.0, hole_limit: float = 20.0, threads: int = 0,
           progress: Progress = None) -> Repaired: ...
def synth(shapes: int = 14, *, seed: int = 1, modes: int = 4, amplitude: float = 2.1, correlation: float = 40.0,
          vertices: int = 10000, threads: int = 0, progress: Progress = None) -> list[tuple[Mesh, Mesh]]: ...
def surface_distance(a: Mesh, b: Mesh, *, samples: int = 20000, seed: int = 1) -> dict[str, float]: ...
def extract(inputs: Paths, output: Path, *, labels: Optional[str] = None, numbering: Optional[str] = None,
            label_names: Optional[Path] = None, keep_cut: bool = False, repair: bool = False,
            handle_limit: Optional[float] = None, hole_limit: Optional[float] = None, threads: int = 0,
            progress: Progress = None) -> dict[str, Any]: ...
def build(inputs: Paths, output: Path, *, method: Optional[str] = None, objective: Optional[str] = None,
          rounds: Optional[int] = None, distortion: Optional[str] = None, bending: Optional[str] = None,
          reference: Optional[str] = None, lambda_: Optional[float] = None, landmarks: Optional[int] = None,
          target_error: Optional[float] = None, samples: Optional[int] = None, seed: Optional[int] = None,
          scale: Optional[str] = None, weights: Optional[str] = None, subject_regex: Optional[str] = None,
          paper: bool = False, initial_map: Optional[str] = None, optimiser: Optional[str] = None,
          units: Optional[str] = None, numbering: Optional[str] = None, labels: Optional[str] = None,
          label_names: Optional[Path] = None, keep_cut: bool = False, repair: bool = False,
          handle_limit: Optional[float] = None, hole_limit: Optional[float] = None, truth: Optional[Path] = None,
          refit: bool = False, resume: bool = False, threads: int = 0, progress: Progress = None) -> dict[str, Any]: ...
def evaluate(corresponding: Path, *, shapes: Optional[Path] = None, truth: Optional[Path] = None,
             true_landmarks: Optional[Path] = None, output: Optional[Path] = None, samples: int = 1000, seed: int = 1,
             subject_regex: str = "", scale: str = "keep", weights: str = "equal", threads: int = 0,
             progress: Progress = None) -> dict[str, Any]: ...
def compare(models: Sequence[Path]) -> dict[str, Any]: ...
def report(model: Path, output: Optional[Path] = None, *, baseline: Optional[Path] = None,
           plain: bool = False) -> str: ...
def convert(input: Path, output: Path, *, to: Optional[str] = None, units: Optional[str] = None,
            triangles: Optional[Path] = None, scale: Optional[str] = None, threads: int = 0,
            progress: Progress = None) -> dict[str, Any]: ...
def render(model: Path, output: Path, *, baseline: Optional[Path] = None, only_curves: bool = False) -> dict[str, str]: ...
