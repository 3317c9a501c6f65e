"""The objects of many scans, from the command line."""

from __future__ import annotations

import argparse
import json
import os
import pathlib
import sys
from typing import Any, Dict, List, Optional, Sequence, Tuple

from .. import _symscene
from .._symscene import InputError
from . import Cluster, Scan, Settings, find_scans, merge, read_manifest, run, shard, write_manifest

EXAMPLES = """examples:
  python3 -m symscene.batch scans -o out                           this process
  python3 -m symscene.batch scans -o out --workers 8               8 processes on this machine
  python3 -m symscene.batch scans -o out --ssh host1,host2         machines that ssh reaches
  python3 -m symscene.batch scans -o out --scheduler tcp://host1:8786
  python3 -m symscene.batch scans -o out --list                    writes out/manifest.csv, which then is the input:
  python3 -m symscene.batch out/manifest.csv -o out --shard 3/16   its third share of sixteen, as a job of an array
  python3 -m symscene.batch out/manifest.csv -o out --merge        out/table.csv of all records
"""


def _shard(text: str) -> Tuple[int, int]:
    index, _, count = text.partition("/")
    if not (index.isdigit() and count.isdigit() and 1 <= int(index) <= int(count)):
        raise argparse.ArgumentTypeError(f"expected i/n with 1 <= i <= n, found {text!r}")
    return int(index), int(count)


def _count(least: int) -> Any:
    def parse(text: str) -> int:
        if not text.isdigit() or int(text) < least:
            raise argparse.ArgumentTypeError(f"expected a number from {least}, found {text!r}")
        return int(text)

    return parse


def _arguments(given: Optional[Sequence[str]]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="symscene.batch",
        description="Segment many scans: one task per scan, done once, merged into one table.",
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("input", metavar="INPUT", help="folder of scans, or a manifest (.csv)")
    parser.add_argument("-o", "--output", required=True, metavar="FOLDER", help="records, results, table.csv")
    where = parser.add_mutually_exclusive_group()
    where.add_argument("--workers", type=_count(1), default=1, metavar="N", help="processes on this machine (default: 1)")
    where.add_argument("--ssh", metavar="HOST,...", help="machines; the first also runs the scheduler")
    where.add_argument("--scheduler", metavar="ADDRESS", help="a scheduler of Dask that runs")
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--shard", type=_shard, metavar="I/N", help="only share I of N; no merge")
    what.add_argument("--list", action="store_true", help="write the manifest and nothing else")
    what.add_argument("--merge", action="store_true", help="merge the records and nothing else")
    parser.add_argument("--workers-per-host", type=_count(1), default=1, metavar="N", help="with --ssh (default: 1)")
    parser.add_argument("--retries", type=_count(0), default=2, metavar="N", help="of a scan whose worker died (default: 2)")
    parser.add_argument("--threads", type=_count(1), default=1, metavar="N", help="of one scan (default: 1)")
    parser.add_argument("--config", metavar="FILE", help="options of `symscene segment` (JSON)")
    parser.add_argument("--reconstruct-config", metavar="FILE", help="options of `symscene reconstruct`, for sequences")
    parser.add_argument("-q", "--quiet", action="store_true", help="no progress")
    return parser.parse_args(given)


def _options(file: Optional[str]) -> Optional[Dict[str, Any]]:
    if file is None:
        return None
    try:
        options = json.loads(pathlib.Path(file).read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        _symscene.refuse(file, "options as JSON", str(error))
    if not isinstance(options, dict):
        _symscene.refuse(file, "options in groups", "another value")
    return dict(options)


def _scans(arguments: argparse.Namespace) -> List[Scan]:
    """Of a manifest, or of a folder, whose manifest is then written."""
    if os.path.isdir(arguments.input):
        scan_folder = pathlib.Path(arguments.input).resolve()
        if scan_folder in pathlib.Path(arguments.output).resolve().parents:
            _symscene.refuse(arguments.output, "a folder outside the folder of scans", "one in it")
        scans = find_scans(arguments.input)
        write_manifest(pathlib.Path(arguments.output) / "manifest.csv", scans)
        return scans
    return read_manifest(arguments.input)


def _tell(line: str) -> None:
    print(line, file=sys.stderr, flush=True)


def _run(arguments: argparse.Namespace, scans: List[Scan]) -> int:
    """The number of scans that failed."""
    settings = Settings(
        os.path.abspath(arguments.output),  # workers may run in other folders
        _options(arguments.config),
        _options(arguments.reconstruct_config),
        arguments.threads,
    )
    if arguments.shard:
        scans = shard(scans, *arguments.shard)
    cluster = Cluster(
        arguments.workers,
        arguments.ssh.split(",") if arguments.ssh else (),
        arguments.workers_per_host,
        arguments.scheduler or "",
    )
    counts = run(
        scans, settings, cluster, retries=arguments.retries, tell=None if arguments.quiet else _tell
    )
    return counts["failed"]


def main(given: Optional[Sequence[str]] = None) -> int:
    arguments = _arguments(given)
    try:
        scans = _scans(arguments)
        if arguments.list:
            print(pathlib.Path(arguments.output) / "manifest.csv")
            return 0
        failed = 0 if arguments.merge else _run(arguments, scans)
        if not arguments.shard:
            print(merge(scans, arguments.output))
    except (InputError, OSError) as error:
        print(f"symscene.batch: {error}", file=sys.stderr)
        return 1
    if failed:
        print(f"symscene.batch: {failed} scans failed: their sentences are in the records", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
