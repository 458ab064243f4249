"""Keywords, options and names of the package."""

import enum
import inspect

import numpy as np
import pytest

import foramen
from foramen import _foramen

FUNCTIONS = ["correspond", "place_landmarks", "build_model", "evaluate", "complete", "repair", "build"]

# The names of the package in earlier versions, which must remain.
NAMES = ["Cancelled", "Completion", "ConvergenceError", "Error", "InvalidInput", "IoError", "Measures", "Mesh", "Model",
         "Projection", "Repaired", "TopologyError", "build", "compare", "convert", "evaluate", "extract", "inspect",
         "read_mesh", "render", "repair", "report", "surface_distance", "synth", "write_mesh"]


def another(option):
    """A value of the option that is not its default."""
    if option.words:
        return next(word for word in option.words if word != option.default)
    if option.kind == "bool":
        return not option.default
    if option.kind == "str":
        return "other"
    if option.kind == "list of float":
        return [value * 0.5 for value in option.default]
    if option.kind == "list of dict":
        return [{name: value * 0.5 for name, value in item.items()} for item in option.default]
    if option.default is None:
        return 60 if option.kind == "int" else 0.75
    if option.kind == "int":
        return option.default + 1
    return option.default * 0.5 or 0.25


@pytest.mark.parametrize("function", FUNCTIONS)
def test_every_option_can_be_set_and_is_described(function):
    options = foramen.list_options(function)
    defaults = _foramen.options_with(function, {})
    assert list(defaults) == [option.path for option in options]
    for option in options:
        assert option.meaning and option.kind in ("bool", "int", "float", "str", "list of float", "list of dict"), option.path
        value = another(option)
        changed = _foramen.options_with(function, {option.path: value})
        assert {path for path in defaults if changed[path] != defaults[path]} == {option.path}
        assert changed[option.path] == value
        if option.range:
            beyond = -1e9 if "int" not in option.kind else -(2**31) + 1
            beyond = [beyond] * len(option.default) if option.kind.startswith("list") else beyond
            with pytest.raises(foramen.InvalidInput, match=f"{option.path} is .*it must be"):
                _foramen.options_with(function, {option.path: beyond})


def test_the_last_parts_of_a_path_are_enough():
    changed = _foramen.options_with("build_model", {"group.rounds": 2, "grid_points": 1000})
    assert changed["correspondence.group.rounds"] == 2 and changed["landmarks.resampling.grid_points"] == 1000


def test_values_of_numpy_and_of_enumerations_are_taken():
    changed = _foramen.options_with("correspond", {"group.rounds": np.int64(2), "group.still": np.float32(0.5), "method": "ICP",
                                                   "group.bending": foramen.Bending.RIGID})
    assert [changed[path] for path in ("group.rounds", "group.still", "method", "group.bending")] == [2, 0.5, "icp", "rigid"]
    for value in (1.5, "1", None, True):
        with pytest.raises(TypeError, match="group.rounds must be a whole number"):
            _foramen.options_with("correspond", {"group.rounds": value})
    with pytest.raises(foramen.InvalidInput, match="which no option can be"):
        _foramen.options_with("correspond", {"group.rounds": 2**70})


def test_keywords_are_the_choices_of_a_build():
    choices = {option.path: option for option in foramen.list_options(foramen.build)}
    keywords = inspect.signature(foramen.build).parameters
    assert {name + "_" * (name == "lambda") for name in choices} <= set(keywords)
    in_memory = set(inspect.signature(foramen.build_model).parameters)
    assert {name for name in choices if name + "_" * (name == "lambda") not in in_memory} == {"samples", "subject_regex"}


def test_enumerations_have_the_words_of_the_options():
    words = {option.path: option.words for option in foramen.list_options("build")}
    for name, members in (("method", foramen.Method), ("objective", foramen.Objective), ("distortion", foramen.Distortion),
                          ("bending", foramen.Bending), ("scale", foramen.Scale), ("weights", foramen.Weights),
                          ("initial_map", foramen.InitialMap), ("optimiser", foramen.Optimiser)):
        assert issubclass(members, enum.Enum) and {member.value for member in members} == set(words[name])


def test_names_of_the_package_stay():
    assert set(NAMES) <= set(foramen.__all__) and all(hasattr(foramen, name) for name in foramen.__all__)


def test_the_extension_has_no_command_line():
    with open(_foramen.__file__, "rb") as file:
        assert b"CLI::" not in file.read() and b"N3CLI" not in open(_foramen.__file__, "rb").read()
