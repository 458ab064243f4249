"""Surfaces: the class Mesh, mesh files, audit, repair, and synthetic shapes."""

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
    """The result of repair(): mesh; origin (P,), for each point its index in the raw surface, -1 if new; report."""

    mesh: Mesh
    origin: np.ndarray
    report: dict


def read_mesh(path):
    """Reads a Mesh from PLY, STL, OBJ, OFF, VTK or VTP. A file without a SPACE tag counts as LPS."""
    points, triangles, space = _foramen.read_mesh(os.fspath(path))
    return Mesh(points, triangles, space or "LPS")


def write_mesh(path, mesh):
    """Writes a .ply (binary) or .vtp file with a SPACE tag. The file is written whole or not at all."""
    _foramen.write_mesh(os.fspath(path), mesh.points, mesh.triangles, mesh.space)


def inspect(mesh):
    """Audits a surface. The result is a dict: usable, genus, closed, manifold ...; finding and remedy if it is not
    usable."""
    return json.loads(_foramen.inspect(mesh.points, mesh.triangles))


def repair(mesh, *, handle_limit=12.0, hole_limit=20.0, threads=0, progress=None):
    """Repairs a surface to one closed, manifold surface of genus 1, wound outward. The result is a Repaired.

    handle_limit: an extra handle is noise if both its loops are at most this long [mm]; hole_limit: a hole is filled if
    its border is at most this long [mm]. Raises InvalidInput with the reason if the surface cannot be repaired.
    """
    points, triangles, origin, report_text = _foramen.repair(mesh.points, mesh.triangles, handle_limit, hole_limit,
                                                             threads, progress)
    return Repaired(Mesh(points, triangles, mesh.space), origin, json.loads(report_text))


def synth(shapes=14, *, seed=1, deformation="smooth", modes=4, amplitude=2.1, correlation=40.0, vertices=10000,
          threads=0, progress=None):
    """Makes vertebra-like shapes with known correspondence: a list of pairs (surface, truth) of Mesh objects.

    The truths have identical triangles. amplitude: RMS displacement of a coordinate [mm]; correlation: the correlation
    length of the displacement [mm]. deformation: "smooth", or "rough" for shapes that also vary on fine scales, with
    features that move by their own laws, spurs, noise and mixed numbers of vertices.
    """
    made = _foramen.synth(shapes, seed, deformation, modes, amplitude, correlation, vertices, threads, progress)
    return [(Mesh(p, t), Mesh(tp, tt)) for p, t, tp, tt in made]


def surface_distance(a, b, *, samples=20000, seed=1):
    """The distance of two surfaces in both directions, in mm: a dict of mean, p95 and hausdorff."""
    return _foramen.surface_distance(a.points, a.triangles, b.points, b.triangles, samples, seed)
