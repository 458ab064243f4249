"""Functions from files to files: they build, measure, compare, convert and draw models."""

import json
import os

from . import _foramen
from ._options import given


def paths_of(inputs):
    if isinstance(inputs, (str, os.PathLike)):
        inputs = [inputs]
    return [os.fspath(path) for path in inputs]


def _path(path):
    return "" if path is None else os.fspath(path)


def extract(inputs, output, *, labels=None, numbering=None, label_names=None, keep_cut=False, repair=False,
            handle_limit=None, hole_limit=None, threads=0, progress=None):
    """Writes meshes of the labels of label maps to a folder. Returns the contents of extract.json as a dict.

    labels: for example "20-24,3"; numbering: "verse", "totalsegmentator", "totalsegmentator-v1" or
    "totalspineseg"; label_names: a CSV file with the names.
    """
    return json.loads(_foramen.extract(paths_of(inputs), os.fspath(output), _labels(labels, numbering, label_names, keep_cut),
                                       bool(repair), given(handle_limit=handle_limit, hole_limit=hole_limit), threads,
                                       progress))


def _labels(labels, numbering, label_names, keep_cut):
    return given(labels=labels, numbering=numbering, label_names=label_names, keep_cut=keep_cut)


def build(inputs, output, *, method=None, objective=None, rounds=None, distortion=None, bending=None, reference=None,
          lambda_=None, landmarks=None, target_error=None, samples=None, seed=None, scale=None, weights=None,
          subject_regex=None, paper=False, initial_map=None, optimiser=None, units=None, numbering=None, labels=None,
          label_names=None, keep_cut=False, repair=False, handle_limit=None, hole_limit=None, truth=None, refit=False,
          resume=False, store=None, threads=0, progress=None):
    """Builds a model from surfaces or label maps, and writes it with its evaluation and report to a folder. Returns a
    summary.

    inputs: a path or a list of files and folders. Keywords are the options of `foramen build`, with the same defaults.
    The same options give the same bytes in the files. See `foramen build --help`.
    """
    chosen = given(method=method, objective=objective, rounds=rounds, distortion=distortion, bending=bending,
                   reference=reference, lambda_=lambda_, landmarks=landmarks, target_error=target_error, samples=samples,
                   seed=seed, scale=scale, weights=weights, subject_regex=subject_regex, paper=paper, initial_map=initial_map,
                   optimiser=optimiser)
    return json.loads(_foramen.build_folder(paths_of(inputs), os.fspath(output), chosen,
                                            _labels(labels, numbering, label_names, keep_cut), bool(repair),
                                            given(handle_limit=handle_limit, hole_limit=hole_limit), units, _path(truth),
                                            bool(refit), bool(resume), _path(store), threads, progress))


def compare(models):
    """Compares generalization and specificity of two or more models' folders, with paired tests. Returns a dict."""
    return json.loads(_foramen.compare(paths_of(models)))


def report(model, output=None, *, baseline=None, plain=False):
    """Writes the report of a model, to report.html in its folder or to another file. Returns the path."""
    return _foramen.report(os.fspath(model), _path(output), _path(baseline), plain)


def convert(input, output, *, to=None, units=None, triangles=None, scale=None, threads=0, progress=None):
    """Converts models and corresponding shapes between the files of different tools.

    Returns a dict with output, files, shapes, landmarks and notes.

    input: a model's folder, model.h5 or .h5.json, a folder of corresponding meshes, .swproj, .xlsx, .tps or a landmark
    table .csv. output: a file, whose format follows from its extension (.h5 .h5.json .swproj .tps .csv), or a folder of
    meshes. to: the format, as in `foramen convert --to`, if the extension does not determine it; units: the unit of the
    input's shapes; triangles: a mesh file, for inputs of points without triangles; scale: "keep" or "remove", if a
    model is made from shapes.
    """
    files, shapes, landmarks, notes = _foramen.convert(os.fspath(input), os.fspath(output), to, units, _path(triangles),
                                                       scale, threads, progress)
    return {"output": os.fspath(output), "files": files, "shapes": shapes, "landmarks": landmarks, "notes": notes}


def render(model, output, *, baseline=None, only_curves=False):
    """Writes pictures of a model as PNG, and curves as SVG and PDF, to a folder. Returns the captions by file name.

    baseline: the folder of another model for comparison. Pictures need a display (xvfb-run); only_curves needs none.
    """
    return json.loads(_foramen.render(os.fspath(model), os.fspath(output), _path(baseline), only_curves))
