"""All records as one table, in the order of the manifest."""

from __future__ import annotations

import csv
import importlib.util
import pathlib
from typing import Any, Dict, Iterator, List, Sequence

from .. import _symscene
from ._files import atomic_file, replacing
from ._manifest import Scan
from ._task import read_record

_OBJECT_COLUMNS = ("object", "points", "score", "confidence", "class", "axes", "planes")
COLUMNS = ("scan", "sha256", "status", "message", *_OBJECT_COLUMNS, "x", "y", "z", "volume")


def _rows(record: Dict[str, Any]) -> Iterator[List[Any]]:
    """A row per object; one without an object if there is none."""
    head = [record["name"], record["sha256"], record["status"], record["message"]]
    if not record["objects"]:
        yield head + [None] * (len(COLUMNS) - len(head))
    for item in record["objects"]:
        place = item["centroid"] or [None] * 3
        yield [*head, *(item[name] for name in _OBJECT_COLUMNS), *place, item["volume"]]


def _all_rows(scans: Sequence[Scan], output: str) -> Iterator[List[Any]]:
    for scan in scans:
        record = read_record(output, scan.name)
        if record is None:
            _symscene.refuse(output, f"a record of each of {len(scans)} scans", f"none of {scan.name}")
        yield from _rows(record)


def _write_parquet(path: pathlib.Path, rows: Iterator[List[Any]]) -> None:
    import pyarrow
    import pyarrow.parquet

    whole, text = pyarrow.int64(), pyarrow.string()
    types = {"scan": text, "sha256": text, "status": text, "message": text, "class": text}
    types.update({name: whole for name in ("object", "points", "axes", "planes")})
    schema = pyarrow.schema([(name, types.get(name, pyarrow.float64())) for name in COLUMNS])
    columns: Dict[str, List[Any]] = {name: [] for name in COLUMNS}
    for row in rows:
        for name, value in zip(COLUMNS, row):
            columns[name].append(value)
    with replacing(path) as temporary:
        pyarrow.parquet.write_table(pyarrow.table(columns, schema=schema), temporary)


def merge(scans: Sequence[Scan], output: str) -> pathlib.Path:
    """Write table.csv, and table.parquet if pyarrow is installed. Returns the path of the first.

    Equal records give equal bytes, whoever made them in whatever order. Raises InputError if a scan has
    no record.
    """
    table = pathlib.Path(output) / "table.csv"
    with atomic_file(table) as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        writer.writerows(_all_rows(scans, output))
    if importlib.util.find_spec("pyarrow") is not None:
        _write_parquet(table.with_suffix(".parquet"), _all_rows(scans, output))
    return table
