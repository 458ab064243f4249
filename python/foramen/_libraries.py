"""Which libraries of Debian are missing, if the extension cannot be loaded."""

import ctypes
import json
from pathlib import Path


def missing_packages(libraries):
    """The Debian packages of those libraries (a dict from a library to its package) that cannot be loaded."""
    missing = set()
    for library, package in libraries.items():
        try:
            ctypes.CDLL(library)
        except OSError:
            missing.add(package)
    return sorted(missing)


def explained(error):
    """The error of a failed import. If this is a wheel's extension, it names the Debian packages to install."""
    # Only a wheel has this file. Debian's own package depends on what it loads.
    listed = Path(__file__).with_name("libraries.json")
    packages = missing_packages(json.loads(listed.read_text())) if listed.is_file() else []
    if not packages:
        return error
    return ImportError(f"{error}\nThis package needs libraries of Debian: apt install {' '.join(packages)}")
