"""Makes a wheel of the Python package for this Debian's python3: python3 -m build --wheel --no-isolation python

CMake builds the extension in build/wheel. If FORAMEN_EXTENSION names an extension that is already built, it is taken.
The wheel holds no library. Its libraries.json names the Debian packages of those that the extension loads, and the
import says which are missing.
"""

import json
import os
import re
import shutil
import subprocess
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

PROJECT = Path(__file__).resolve().parent.parent


def run(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def build_extension():
    """The file of the extension, built by CMake."""
    if "FORAMEN_EXTENSION" in os.environ:
        return Path(os.environ["FORAMEN_EXTENSION"])
    folder = PROJECT / "build" / "wheel"
    run("cmake", "-S", str(PROJECT), "-B", str(folder), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
        "-DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON")
    run("cmake", "--build", str(folder), "--target", "foramen_python")
    return next((folder / "python" / "foramen").glob("_foramen.*.so"))


def debian_packages(extension):
    """The libraries that the extension loads, and the Debian package of each."""
    paths = dict(re.findall(r"^\s*(\S+) => (\S+)", run("ldd", str(extension)), re.MULTILINE))
    needed = re.findall(r"NEEDED\s+(\S+)", run("objdump", "-p", str(extension)))
    packages = {}
    for library in needed:
        if library not in paths:
            continue  # the dynamic loader itself
        # dpkg may know the file below /usr or, from the time before the two were merged, below /.
        path = os.path.realpath(paths[library])
        for candidate in (path, path.removeprefix("/usr"), paths[library]):
            found = subprocess.run(["dpkg", "-S", candidate], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
            if found.returncode == 0:
                packages[library] = found.stdout.split(":")[0]
                break
        else:
            raise SystemExit(f"{library} ({path}) is in no Debian package")
    return packages


class BuildByCMake(build_ext):
    """Puts the extension and libraries.json into the package."""

    def build_extension(self, extension):
        built = build_extension()
        target = Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(built, target)
        run("strip", "--strip-unneeded", str(target))
        (target.parent / "libraries.json").write_text(json.dumps(debian_packages(target), indent=1) + "\n")


setup(
    name="foramen",
    version=re.search(r"^project\(foramen VERSION ([0-9.]+)", (PROJECT / "CMakeLists.txt").read_text(), re.MULTILINE)[1],
    description="Statistical shape models of vertebrae, without any interaction",
    license="Apache-2.0",
    packages=["foramen"],
    package_data={"foramen": ["*.pyi", "py.typed"]},
    ext_modules=[Extension("foramen._foramen", sources=[])],
    cmdclass={"build_ext": BuildByCMake},
    python_requires=">=3.9",
    install_requires=["numpy"],
)
