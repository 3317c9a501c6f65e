"""Objects of many scans, on one machine or many.

    python3 -m symscene.batch scans -o out --workers 8

makes a manifest of the scans in a folder (path and hash of the content), segments each (sequences are
reconstructed first), and merges the records into one table, out/table.csv. What is done is not done
again. In Python:

    from symscene import batch

    scans = batch.find_scans("scans")
    batch.run(scans, batch.Settings("out"), batch.Cluster(workers=8))
    batch.merge(scans, "out")
"""

from ._engine import Cluster, run, shard
from ._manifest import Scan, content_hash, find_scans, read_manifest, write_manifest
from ._table import merge
from ._task import Settings, read_record, run_scan

__all__ = [
    "Cluster",
    "Scan",
    "Settings",
    "content_hash",
    "find_scans",
    "merge",
    "read_manifest",
    "read_record",
    "run",
    "run_scan",
    "shard",
    "write_manifest",
]
