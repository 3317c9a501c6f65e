"""Which scans there are: names, paths and hashes of their content."""

from __future__ import annotations

import csv
import hashlib
import io
import os
import pathlib
from typing import Iterable, List, NamedTuple, Union

from .. import _symscene
from ._files import write_atomically

Path = Union[str, "os.PathLike[str]"]

_COLUMNS = ("name", "path", "sha256")
_ENDINGS = (".ply", ".pcd", ".bag", ".mcap", ".db3")


class Scan(NamedTuple):
    """A scan of a manifest."""

    name: str  # of its outputs: unique, a file name
    path: str  # a cloud, a scene, or a sequence of depth images; absolute
    sha256: str  # content_hash() when the manifest was made


def _file_hash(path: pathlib.Path) -> str:
    digest = hashlib.sha256()
    with open(path, "rb") as file:
        while block := file.read(1 << 20):
            digest.update(block)
    return digest.hexdigest()


def content_hash(path: Path) -> str:
    """The SHA-256 hash of a file; of a folder, that of the list of its files.

    The list is what `find -L * -type f -not -path '*/.*' | LC_ALL=C sort | xargs sha256sum` prints
    there, where names have no spaces and no folder is a link. Hidden files are left out.
    """
    root = pathlib.Path(path)
    if not root.is_dir():
        return _file_hash(root)
    names = []
    for folder, folders, files in os.walk(root):
        folders[:] = [name for name in folders if not name.startswith(".")]
        here = pathlib.Path(folder)
        names += [(here / name).relative_to(root).as_posix() for name in files if name[0] != "."]
    digest = hashlib.sha256()
    for name in sorted(names, key=os.fsencode):
        digest.update(f"{_file_hash(root / name)}  ".encode() + os.fsencode(name) + b"\n")
    return digest.hexdigest()


def find_scans(folder: Path) -> List[Scan]:
    """The scans of a folder, by name: its folders, and its files .ply, .pcd, .bag, .mcap and .db3."""
    root = pathlib.Path(folder).absolute()
    if not root.is_dir():
        _symscene.refuse(str(folder), "a folder of scans", "none")
    found = [
        Scan(path.name, str(path), content_hash(path))
        for path in sorted(root.iterdir())
        if not path.name.startswith(".") and (path.is_dir() or path.suffix in _ENDINGS)
    ]
    if not found:
        _symscene.refuse(str(folder), "a folder of scans", "one without any")
    return found


def _checked(scans: List[Scan], where: str) -> List[Scan]:
    names = set()
    for scan in scans:
        if not scan.name or scan.name.startswith(".") or "/" in scan.name or "\0" in scan.name:
            _symscene.refuse(where, "names of scans that can be names of files", repr(scan.name))
        if scan.name in names:
            _symscene.refuse(where, "a name for each scan", f"{scan.name} twice")
        names.add(scan.name)
    return scans


def read_manifest(file: Path) -> List[Scan]:
    """Read a manifest: CSV with the columns name, path and sha256. Paths are relative to its folder."""
    base = pathlib.Path(file).absolute().parent
    try:
        with open(file, encoding="utf-8", newline="") as stream:
            rows = list(csv.reader(stream))
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        _symscene.refuse(str(file), "a manifest that can be read", str(error))
    if not rows or tuple(rows[0]) != _COLUMNS:
        _symscene.refuse(str(file), "a manifest with the columns " + ", ".join(_COLUMNS), "others")
    for number, row in enumerate(rows[1:], start=2):
        if len(row) != len(_COLUMNS):
            _symscene.refuse(f"{file}, line {number}", "3 values", str(len(row)))
    return _checked([Scan(row[0], str(base / row[1]), row[2]) for row in rows[1:]], str(file))


def write_manifest(file: Path, scans: Iterable[Scan]) -> None:
    """Write a manifest, with absolute paths."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(_COLUMNS)
    writer.writerows(_checked(list(scans), str(file)))
    write_atomically(pathlib.Path(file), text.getvalue())
