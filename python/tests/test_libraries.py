"""What the import of a wheel says if libraries of Debian are missing."""

import json

from foramen import _libraries


def test_only_the_packages_of_missing_libraries_are_named():
    libraries = {"libc.so.6": "libc6", "libabsent.so.1": "libabsent1", "libabsentmore.so.1": "libabsent1",
                 "liba.so.7": "liba7-absent"}
    assert _libraries.missing_packages(libraries) == ["liba7-absent", "libabsent1"]


def test_a_wheel_names_the_packages_to_install(tmp_path, monkeypatch):
    monkeypatch.setattr(_libraries, "__file__", str(tmp_path / "_libraries.py"))
    error = ImportError("libabsent.so.1: cannot open shared object file")
    assert _libraries.explained(error) is error  # no wheel
    (tmp_path / "libraries.json").write_text(json.dumps({"libc.so.6": "libc6"}))
    assert _libraries.explained(error) is error  # nothing of Debian is missing: the reason is another one
    (tmp_path / "libraries.json").write_text(json.dumps({"libabsent.so.1": "libabsent1"}))
    assert str(_libraries.explained(error)).endswith("cannot open shared object file\n"
                                                     "This package needs libraries of Debian: apt install libabsent1")
