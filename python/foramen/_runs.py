"""From files to files: the verbs that build, measure, compare, convert and picture models."""

import json
import os

from . import _foramen
from ._foramen import InvalidInput


def paths_of(inputs):
    if isinstance(inputs, (str, os.PathLike)):
        inputs = [inputs]
    return [os.fspath(path) for path in inputs]


def _path(path):
    return "" if path is None else os.fspath(path)


def _arguments(options):
    """Keywords as the program's options: landmarks=400 is --landmarks 400, refit=True is --refit."""
    arguments = []
    for key, value in options.items():
        if value is None or value is False:
            continue
        arguments.append("--" + key.replace("_", "-"))
        if value is not True:
            arguments.append(os.fspath(value) if isinstance(value, os.PathLike) else str(value))
    return arguments


def extract(inputs, output, *, labels=None, numbering=None, label_names=None, keep_cut=False, repair=False,
            handle_limit=None, hole_limit=None, threads=0, progress=None):
    """Meshes of the labels of label maps, written to a folder; what extract.json holds as a dict.

    labels: e.g. "20-24,3"; numbering: "verse" or "totalsegmentator"; label_names: a CSV file instead.
    """
    options = dict(labels=labels, numbering=numbering, label_names=label_names, keep_cut=keep_cut, repair=repair,
                   handle_limit=handle_limit, hole_limit=hole_limit)
    return json.loads(_foramen.extract(paths_of(inputs), os.fspath(output), _arguments(options), threads, progress))


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
    return json.loads(_foramen.build(paths_of(inputs), os.fspath(output), _arguments(options), threads, progress))


def evaluate(corresponding, *, shapes=None, truth=None, true_landmarks=None, output=None, samples=1000, seed=1,
             subject_regex="", scale="keep", weights="equal", threads=0, progress=None):
    """Compactness, generalization and specificity of a folder of corresponding meshes from any tool, as a dict.

    shapes: folder of the original surfaces, by the same names; without it distances are to the corresponding meshes.
    """
    if scale not in ("keep", "remove"):
        raise InvalidInput(f"scale must be keep or remove, not {scale}")
    if weights not in ("equal", "area"):
        raise InvalidInput(f"weights must be equal or area, not {weights}")
    return json.loads(_foramen.evaluate(os.fspath(corresponding), _path(shapes), _path(truth), _path(true_landmarks),
                                         _path(output), samples, seed, subject_regex, scale == "remove",
                                         weights == "area", threads, progress))


def compare(models):
    """Generalization and specificity of two or more models' folders side by side, with paired tests, as a dict."""
    return json.loads(_foramen.compare(paths_of(models)))


def report(model, output=None, *, baseline=None, plain=False):
    """Writes a model's report.html again, or elsewhere; returns its path."""
    return _foramen.report(os.fspath(model), _path(output), _path(baseline), plain)


def convert(input, output, *, to=None, units=None, triangles=None, scale=None, threads=0, progress=None):
    """Models and corresponding shapes to and from other tools' files; output, files, shapes, landmarks, notes as a dict.

    input: a model's folder, model.h5 or .h5.json, a folder of corresponding meshes, .swproj, .tps or a landmark table .csv.
    output: a file, its kind by its extension (.h5 .h5.json .swproj .tps .csv), or a folder of meshes. to: what to write where
    the name does not say it, as `foramen convert --to`; units: of the input's shapes; triangles: a mesh file for inputs that
    are points alone; scale: "keep" or "remove", where a model is made of shapes.
    """
    options = dict(to=to, units=units, triangles=triangles, scale=scale)
    return json.loads(_foramen.convert(os.fspath(input), os.fspath(output), _arguments(options), threads, progress))


def render(model, output, *, baseline=None, only_curves=False):
    """Pictures of a model as PNG, curves as SVG and PDF, written to a folder; a dict of their captions by file name.

    baseline: the folder of another model to be seen beside. Pictures need a display (xvfb-run); only_curves needs none.
    """
    return json.loads(_foramen.render(os.fspath(model), os.fspath(output), _path(baseline), only_curves))
