"""Files that a reader sees whole or not at all."""

from __future__ import annotations

import os
import pathlib
import uuid


def write_atomically(path: pathlib.Path, text: str) -> None:
    """Write a temporary file beside the path and rename it. Parents are made."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f".{path.name}.{uuid.uuid4().hex}")
    try:
        with open(temporary, "w", encoding="utf-8", newline="") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)
