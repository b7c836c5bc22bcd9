"""Optional packages that ``pip install gaitcam`` does not install."""

from importlib import import_module
from typing import Any


def needed(module: str, install: str) -> Any:
    """Imports a module. If its package is missing, the error contains the command that installs it."""
    package = module.split(".")[0]
    try:
        import_module(package)
    except ModuleNotFoundError as missing:
        if missing.name != package:
            raise
        text = f"{package} is not installed: pip install '{install}'"
        raise ModuleNotFoundError(text, name=package) from missing
    return import_module(module)
