"""Packages that a part of gaitcam needs and ``pip install gaitcam`` does not bring."""

from importlib import import_module
from typing import Any


def needed(module: str, install: str) -> Any:
    """Imports a module; where its package is missing, the error has the command that installs it."""
    package = module.split(".")[0]
    try:
        import_module(package)
    except ModuleNotFoundError as missing:
        if missing.name != package:
            raise
        text = f"{package} is not installed: pip install '{install}'"
        raise ModuleNotFoundError(text, name=package) from missing
    return import_module(module)
