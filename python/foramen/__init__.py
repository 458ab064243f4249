"""Statistical shape models of vertebrae, automatically.

    import foramen
    summary = foramen.build(["shapes/"], "model", landmarks=2000)
    model = foramen.Model.load("model")
    shapes = model.sample(100, seed=1)            # (100, P, 3), mm
    whole = model.complete(foramen.read_mesh("damaged.ply")).mesh

or, in memory,

    model = foramen.build_model({"L1": foramen.Mesh(points, triangles), ...}, landmarks=2000)
    foramen.evaluate(model).generalization.mean_surface.mean

Surfaces are Mesh objects of numpy arrays: points (P, 3) in mm, triangles (T, 3), counter-clockwise seen from outside.
Long computations release the interpreter's lock, use `threads` threads (0: all) and call `progress(stage, fraction,
item)`, where fraction is the finished share of the stage. An exception raised in `progress`, or Ctrl-C, ends the
computation and is raised again. Errors are those of the C++ library: Error and its subclasses IoError, InvalidInput,
TopologyError (a subclass of InvalidInput), ConvergenceError and Cancelled.
"""

try:
    from . import _foramen
except ImportError as error:
    from ._libraries import explained

    raise explained(error) from None
from ._foramen import Cancelled, ConvergenceError, Error, InvalidInput, IoError, TopologyError
from ._mesh import Mesh, Repaired, inspect, read_mesh, repair, surface_distance, synth, write_mesh
from ._model import Completion, Measures, Model, Projection
from ._evaluation import (Compactness, DrawnShapes, Ensemble, Estimates, Evaluation, ModelErrors, Representation, TruthError,
                          evaluate)
from ._options import Bending, Distortion, InitialMap, Method, Objective, Optimiser, Option, Scale, Weights, list_options
from ._runs import build, compare, convert, extract, render, report
from ._stages import Correspondence, Landmarks, ShapeRegistration, build_model, correspond, place_landmarks

__version__ = _foramen.version
__all__ = ["Bending", "Cancelled", "Compactness", "Completion", "ConvergenceError", "Correspondence", "Distortion",
           "DrawnShapes", "Ensemble", "Error", "Estimates", "Evaluation", "InitialMap", "InvalidInput", "IoError",
           "Landmarks", "Measures", "Mesh", "Method", "Model", "ModelErrors", "Objective", "Optimiser", "Option",
           "Projection", "Repaired", "Representation", "Scale", "ShapeRegistration", "TopologyError", "TruthError",
           "Weights", "build", "build_model", "compare", "convert", "correspond", "evaluate", "extract", "inspect",
           "list_options", "place_landmarks", "read_mesh", "render", "repair", "report", "surface_distance", "synth",
           "write_mesh"]

for _name in __all__:
    globals()[_name].__module__ = __name__
