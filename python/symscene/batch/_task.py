"""One scan: its objects, its result folder and its record."""

from __future__ import annotations

import dataclasses
import hashlib
import json
import pathlib
import time
from typing import Any, Dict, Mapping, Optional

from .. import _symscene
from .._options import options_json
from .._reconstruct import reconstruct
from .._segment import segment
from .._symscene import InputError, SceneObject, SegmentationResult
from ._files import write_atomically
from ._manifest import Scan, content_hash

RECORD_VERSION = 1


@dataclasses.dataclass(frozen=True)
class Settings:
    """What is done with each scan, and where its outputs are."""

    output: str  # folder: records/, results/, table.csv
    options: Optional[Mapping[str, Any]] = None  # of `symscene segment`
    reconstruct_options: Optional[Mapping[str, Any]] = None  # of sequences
    threads: int = 1  # of one scan; its result does not depend on it

    def fingerprint(self) -> str:
        """What decides results beside the scan: options and version."""
        text = [options_json(o, {}) for o in (self.options, self.reconstruct_options)]
        return json.dumps([_symscene.__version__, *(json.loads(t) for t in text)], sort_keys=True)


def _place(output: str, kind: str, name: str) -> pathlib.Path:
    """A folder holds some thousands of a million outputs."""
    return pathlib.Path(output) / kind / hashlib.sha256(name.encode()).hexdigest()[:2] / name


def record_path(output: str, name: str) -> pathlib.Path:
    return _place(output, "records", name + ".json")


def result_path(output: str, name: str) -> pathlib.Path:
    return _place(output, "results", name)


def read_record(output: str, name: str) -> Optional[Dict[str, Any]]:
    """The record of a scan; None if there is none. Records are whole: they are renamed into place."""
    try:
        record: Dict[str, Any] = json.loads(record_path(output, name).read_text(encoding="utf-8"))
    except FileNotFoundError:
        return None
    return record


def is_done(scan: Scan, settings: Settings) -> bool:
    """Whether the same content has been segmented with the same options and version."""
    record = read_record(settings.output, scan.name)
    return (
        record is not None
        and record["status"] == "done"
        and record["sha256"] == scan.sha256
        and record["made_with"] == settings.fingerprint()
        and (result_path(settings.output, scan.name) / "objects.json").exists()
    )


def _segmented(scan: Scan, settings: Settings) -> SegmentationResult:
    """A cloud, a scene folder, or a sequence, which is reconstructed first."""
    path = pathlib.Path(scan.path)
    given: Any
    if path.suffix in (".ply", ".pcd") and path.is_file():
        given = _symscene.read_cloud(path)
    elif (path / "cloud.ply").exists() or (path / "cloud.pcd").exists():
        given = _symscene.read_scene(path)
    else:
        given = reconstruct(
            _symscene.open_sequence(path),
            options=settings.reconstruct_options,
            threads=settings.threads,
        )
    return segment(given, options=settings.options, threads=settings.threads)


def _object_row(item: SceneObject) -> Dict[str, Any]:
    centroid = item.centroid
    return {
        "object": item.id,
        "points": len(item.indices),
        "score": item.score,
        "confidence": item.confidence,
        "class": item.symmetry_class.name if item.symmetry_class else "none",
        "axes": len(item.axes),
        "planes": len(item.planes),
        "centroid": [float(v) for v in centroid] if centroid is not None else None,
        "volume": item.solid.volume if item.solid else None,
    }


def write_record(scan: Scan, settings: Settings, status: str, **facts: Any) -> None:
    record = {
        "version": RECORD_VERSION,
        "name": scan.name,
        "sha256": scan.sha256,
        "made_with": settings.fingerprint(),
        "status": status,
        **facts,
    }
    write_atomically(record_path(settings.output, scan.name), json.dumps(record) + "\n")


def run_scan(scan: Scan, settings: Settings) -> str:
    """Segment a scan, write its result and then its record; nothing if that is done.

    Returns "done", "skipped" or "failed". Input that is refused is a failure, and so is a scan that has
    changed since the manifest was made; the record has the sentence. Other exceptions are raised.
    """
    if is_done(scan, settings):
        return "skipped"
    start = time.perf_counter()
    try:
        found = content_hash(scan.path)
        if found != scan.sha256:
            _symscene.refuse(scan.path, f"the content of the manifest, {scan.sha256}", found)
        result = _segmented(scan, settings)
        folder = result_path(settings.output, scan.name)
        folder.parent.mkdir(parents=True, exist_ok=True)
        # An older record would be taken for that of this result.
        record_path(settings.output, scan.name).unlink(missing_ok=True)
        _symscene.write_result(folder, result)
    except (InputError, FileNotFoundError) as error:
        write_record(scan, settings, "failed", message=str(error), objects=[])
        return "failed"
    rows = [_object_row(item) for item in result.objects]
    seconds = time.perf_counter() - start
    write_record(scan, settings, "done", message="", objects=rows, seconds=seconds)
    return "done"
