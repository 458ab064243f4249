"""Enumerations and descriptions of options."""

from dataclasses import dataclass
from enum import Enum
from typing import Any

from . import _foramen


class Method(str, Enum):
    """How shapes are brought into correspondence: maps to a common torus, or the ICP baseline."""

    TORUS = "torus"
    ICP = "icp"


class Objective(str, Enum):
    """The term that attracts the maps to each other: points of the bent template's surface, the paper's soft
    neighbours, or the surface followed by the description length."""

    SURFACE = "surface"
    NEIGHBOURS = "neighbours"
    DESCRIPTION = "description"


class Distortion(str, Enum):
    """Where the distortion of a map is measured: on the template, or in the flat torus."""

    TEMPLATE = "template"
    PLANE = "plane"


class Bending(str, Enum):
    """How the template is fitted to a shape: bent with a prior from the other shapes, bent with a smooth prior, or
    aligned."""

    COHORT = "cohort"
    SMOOTH = "smooth"
    RIGID = "rigid"


class Scale(str, Enum):
    """Whether size is a part of shape."""

    KEEP = "keep"
    REMOVE = "remove"


class Weights(str, Enum):
    """The weights of landmarks: all equal, or by the area around each landmark."""

    EQUAL = "equal"
    AREA = "area"


class InitialMap(str, Enum):
    """The first map of a shape."""

    TORUS = "torus"
    RECTANGLE = "rectangle"


class Optimiser(str, Enum):
    """Projected Newton, or the paper's node-wise descent."""

    NEWTON = "newton"
    POLAK_RIBIERE = "polak-ribiere"


@dataclass(frozen=True)
class Option:
    """The description of an option: path, kind (bool, int, float, str, or a list), unit, default, range, words,
    meaning.

    range is text, for example "> 0", and empty if every number is allowed; words are the values of an enumeration.
    """

    path: str
    kind: str
    unit: str
    default: Any
    range: str
    words: tuple
    meaning: str


def list_options(function):
    """All options of a function: "correspond", "place_landmarks", "build_model", "evaluate", "complete", "repair" or
    "build".

    The options of the first five are set with options={path: value}. The last parts of a path are enough if no other
    option ends with them. The options of "build" are its keywords.
    """
    return [Option(*said) for said in _foramen.list_options(getattr(function, "__name__", function))]


def given(**keywords):
    """The keywords that are set, under the names of their options."""
    return {name.rstrip("_"): value for name, value in keywords.items() if value is not None and value is not False}
