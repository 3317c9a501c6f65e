"""Files that a reader sees whole or not at all."""

from __future__ import annotations

import contextlib
import os
import pathlib
import uuid
from typing import Iterator, TextIO


@contextlib.contextmanager
def replacing(path: pathlib.Path) -> Iterator[pathlib.Path]:
    """A temporary path beside the path, whose file is renamed at the end. Parents are made."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f".{path.name}.{uuid.uuid4().hex}")
    try:
        yield temporary
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


@contextlib.contextmanager
def atomic_file(path: pathlib.Path) -> Iterator[TextIO]:
    """The same, open for text, which is synced before."""
    with replacing(path) as temporary:
        with open(temporary, "w", encoding="utf-8", newline="") as file:
            yield file
            file.flush()
            os.fsync(file.fileno())


def write_atomically(path: pathlib.Path, text: str) -> None:
    with atomic_file(path) as file:
        file.write(text)
