"""Files that are there whole or not at all: written beside their place, then renamed."""
import os
import shutil
import tempfile
from pathlib import Path

from .problem import Stop


def write_whole(path, content):
    path = Path(path)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, beside = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    except OSError as error:
        raise Stop(f"{path}: cannot be written: {error.strerror}") from error
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(content)
        os.chmod(beside, 0o644)
        os.replace(beside, path)
    except OSError as error:
        os.unlink(beside)
        raise Stop(f"{path}: cannot be written: {error.strerror}") from error


def write_folder(folder, contents):
    """`contents` are bytes by their path below the folder; an earlier folder of that name gives way to it."""
    folder = Path(folder)
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        beside = Path(tempfile.mkdtemp(dir=folder.parent, prefix=f".{folder.name}."))
    except OSError as error:
        raise Stop(f"{folder}: cannot be written: {error.strerror}") from error
    try:
        made = beside / folder.name
        for path, content in contents.items():
            (made / path).parent.mkdir(parents=True, exist_ok=True)
            (made / path).write_bytes(content)
        if folder.exists():
            os.replace(folder, beside / "earlier")
        os.replace(made, folder)
    except OSError as error:
        raise Stop(f"{folder}: cannot be written: {error.strerror}") from error
    finally:
        shutil.rmtree(beside, ignore_errors=True)
