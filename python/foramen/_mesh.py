"""Surfaces: Mesh, their files, audit, repair, and synthetic ones."""

import json
import os
from dataclasses import dataclass

import numpy as np

from . import _foramen


@dataclass
class Mesh:
    """A triangle surface: points (P, 3) float64 in mm, triangles (T, 3) int32, space "LPS" or "RAS"."""

    points: np.ndarray
    triangles: np.ndarray
    space: str = "LPS"


@dataclass
class Repaired:
    """What repair() gives: the mesh; for each of its points the raw point it was, -1 if new (P,); the report."""

    mesh: Mesh
    origin: np.ndarray
    report: dict


def read_mesh(path):
    """A Mesh from PLY, STL, OBJ, OFF, VTK or VTP; untagged files count as LPS."""
    points, triangles, space = _foramen.read_mesh(os.fspath(path))
    return Mesh(points, triangles, space or "LPS")


def write_mesh(path, mesh):
    """Writes .ply (binary) or .vtp, with a SPACE tag, whole or not at all."""
    _foramen.write_mesh(os.fspath(path), mesh.points, mesh.triangles, mesh.space)


def inspect(mesh):
    """The audit of a surface as a dict: usable, genus, closed, manifold ...; if not usable, finding and remedy."""
    return json.loads(_foramen.inspect(mesh.points, mesh.triangles))


def repair(mesh, *, handle_limit=12.0, hole_limit=20.0, threads=0, progress=None):
    """One closed, manifold, outward surface of genus 1, as a Repaired.

    handle_limit: an extra handle is noise if both its loops are at most this long [mm]; hole_limit: a hole is filled if its
    border is at most this long [mm]. Raises InvalidInput with the reason if the surface cannot be repaired.
    """
    points, triangles, origin, report_text = _foramen.repair(mesh.points, mesh.triangles, handle_limit, hole_limit,
                                                             threads, progress)
    return Repaired(Mesh(points, triangles, mesh.space), origin, json.loads(report_text))


def synth(shapes=14, *, seed=1, modes=4, amplitude=2.1, correlation=40.0, vertices=10000, threads=0, progress=None):
    """Vertebra-like shapes with known correspondence: a list of (surface, truth), two Mesh objects each.

    Truths have identical triangles. amplitude: RMS displacement of a coordinate [mm]; correlation: its length [mm].
    """
    made = _foramen.synth(shapes, seed, modes, amplitude, correlation, vertices, threads, progress)
    return [(Mesh(p, t), Mesh(tp, tt)) for p, t, tp, tt in made]


def surface_distance(a, b, *, samples=20000, seed=1):
    """Distance of two surfaces, both ways, in mm: a dict of mean, p95 and hausdorff."""
    return _foramen.surface_distance(a.points, a.triangles, b.points, b.triangles, samples, seed)
