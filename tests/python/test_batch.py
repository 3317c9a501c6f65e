"""Many scans: each done once, by any workers in any order, with the same table."""

import csv
import importlib.util
import json
import os
import pathlib
import signal
import subprocess
import sys
import time
import unittest
from unittest import mock

import numpy as np

import symscene
from support import FolderTest, example_result
from symscene import batch

COARSE = {"voxel_size": 0.012}
SCANS = 6


def has_dask():
    return importlib.util.find_spec("distributed") is not None


def table_of(folder):
    return (pathlib.Path(folder) / "table.csv").read_bytes()


def children_of(pid):
    """Processes that a process started, with their command lines."""
    found = {}
    for entry in pathlib.Path("/proc").iterdir():
        try:
            parent = int((entry / "stat").read_text().rpartition(")")[2].split()[1])
            if parent == pid:
                found[int(entry.name)] = (entry / "cmdline").read_bytes()
        except (OSError, ValueError, IndexError):
            continue
    return found


class BatchTest(FolderTest):
    """A folder of small scans, each of an object or more of the simulated depth image."""

    def setUp(self):
        super().setUp()
        self.scans_folder = self.folder / "scans"
        self.scans_folder.mkdir()
        items = example_result().objects
        for k in range(SCANS):
            chosen = [items[i] for i in range(len(items)) if k & (1 << i) or i == k % len(items)]
            points = np.concatenate([item.points for item in chosen])
            normals = np.concatenate([item.normals for item in chosen])
            symscene.write_cloud(self.scans_folder / f"scan{k}.ply", symscene.PointCloud(points, normals))
        self.scans = batch.find_scans(self.scans_folder)

    def settings(self, name="out", **options):
        return batch.Settings(str(self.folder / name), {**COARSE, **options})

    def start(self, *arguments):
        config = self.folder / "options.json"
        config.write_text(json.dumps(COARSE))
        return subprocess.Popen(
            [sys.executable, "-m", "symscene.batch", *map(str, arguments), "--config", str(config)],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=self.folder,
        )


class Scans(BatchTest):
    def test_are_done_once_and_again_when_the_content_or_the_options_change(self):
        counts = batch.run(self.scans, self.settings())
        self.assertEqual(counts, {"done": SCANS, "skipped": 0, "failed": 0})
        self.assertEqual(batch.run(self.scans, self.settings())["skipped"], SCANS)
        self.assertEqual(batch.run(self.scans[:1], self.settings(voxel_size=0.015))["done"], 1)
        changed = self.scans_folder / "scan1.ply"
        changed.write_bytes((self.scans_folder / "scan2.ply").read_bytes())
        counts = batch.run(batch.find_scans(self.scans_folder), self.settings())
        self.assertEqual(counts, {"done": 2, "skipped": SCANS - 2, "failed": 0})

    def test_in_shards_have_the_table_of_one_process(self):
        batch.run(self.scans, self.settings("whole"))
        whole = table_of(batch.merge(self.scans, str(self.folder / "whole")).parent)
        for index in (2, 3, 1):
            batch.run(batch.shard(self.scans, index, 3), self.settings("shards"))
        self.assertEqual(table_of(batch.merge(self.scans, str(self.folder / "shards")).parent), whole)
        rows = list(csv.DictReader(whole.decode().splitlines()))
        self.assertEqual({row["status"] for row in rows}, {"done"})
        self.assertEqual(sorted({row["scan"] for row in rows}), [scan.name for scan in self.scans])

    def test_of_a_shard_that_there_is_not_are_refused(self):
        process = self.start(self.scans_folder, "-o", "out", "--shard", "4/3")
        told = process.communicate()[1]
        self.assertEqual(process.returncode, 2)
        self.assertIn("expected i/n with 1 <= i <= n", told)

    def test_that_are_refused_keep_their_sentence_and_do_not_stop_the_others(self):
        (self.scans_folder / "scan0.ply").write_text("text")
        scans = batch.find_scans(self.scans_folder)
        self.assertEqual(batch.run(scans[:2], self.settings()), {"done": 1, "skipped": 0, "failed": 1})
        self.assertIn("scan0.ply: expected", batch.read_record(self.settings().output, "scan0.ply")["message"])
        changed = scans[1]._replace(sha256="0" * 64)
        self.assertEqual(batch.run([changed], self.settings())["failed"], 1)
        message = batch.read_record(self.settings().output, "scan1.ply")["message"]
        self.assertIn("expected the content of the manifest, 0000", message)

    def test_are_tried_again_where_something_else_goes_wrong(self):
        calls = []

        def unreliable(scan, settings):
            calls.append(scan.name)
            if len(calls) < 3:
                raise MemoryError("none left")
            return batch.run_scan(scan, settings)

        with mock.patch("symscene.batch._engine.run_scan", unreliable):
            self.assertEqual(batch.run(self.scans[:1], self.settings(), retries=2)["done"], 1)
            calls.clear()
            self.assertEqual(batch.run(self.scans[1:2], self.settings(), retries=1)["failed"], 1)
        message = batch.read_record(self.settings().output, "scan1.ply")["message"]
        self.assertEqual(message, "MemoryError: none left")

    def test_without_a_record_are_named_when_records_are_merged(self):
        with self.assertRaisesRegex(symscene.InputError, "found none of scan0.ply"):
            batch.merge(self.scans, str(self.folder))


class Manifests(BatchTest):
    def test_are_read_as_they_were_written(self):
        file = self.folder / "manifest.csv"
        batch.write_manifest(file, self.scans)
        self.assertEqual(batch.read_manifest(file), self.scans)

    def test_that_are_not_valid_are_refused(self):
        file = self.folder / "manifest.csv"
        for text, found in [
            ("", "found others"),
            ("name,path\n", "found others"),
            ("name,path,sha256\na,b\n", "line 2: expected 3 values, found 2"),
            ("name,path,sha256\na,b,c\na,d,e\n", "found a twice"),
            ("name,path,sha256\n../a,b,c\n", "names of files"),
        ]:
            file.write_text(text)
            with self.assertRaisesRegex(symscene.InputError, found):
                batch.read_manifest(file)

    def test_hash_folders_as_sha256sum_does(self):
        folder = self.folder / "scene"
        (folder / "depth").mkdir(parents=True)
        (folder / "depth" / "1.png").write_text("one")
        (folder / "a.txt").write_text("two")
        (folder / ".hidden").write_text("three")
        (folder / "depth" / ".hidden").write_text("four")
        told = subprocess.run(
            "find -L * -type f -not -path '*/.*' | LC_ALL=C sort | xargs sha256sum | sha256sum",
            shell=True, cwd=folder, capture_output=True, text=True, check=True,
        )
        self.assertEqual(batch.content_hash(folder), told.stdout.split()[0])


class Workers(BatchTest):
    def kill_a_worker(self, process):
        """Kill a worker of the cluster as soon as the first record is there."""
        records = self.folder / "out" / "records"
        deadline = time.monotonic() + 120
        while time.monotonic() < deadline and process.poll() is None:
            if any(records.glob("*/*.json")):
                workers = [p for p, line in children_of(process.pid).items() if b"spawn_main" in line]
                os.kill(workers[0], signal.SIGKILL)
                return
            time.sleep(0.005)
        self.fail("no record: " + process.communicate()[1])

    @unittest.skipUnless(has_dask(), "python3-distributed is not installed")
    def test_that_are_killed_leave_the_table_of_one_process(self):
        process = self.start(self.scans_folder, "-o", "out", "--workers", "2")
        self.kill_a_worker(process)
        self.assertEqual(process.wait(), 0, process.communicate()[1])
        self.assertIn(f"{SCANS} of {SCANS} scans", process.communicate()[1])
        batch.run(self.scans, self.settings("one"))
        batch.merge(self.scans, str(self.folder / "one"))
        self.assertEqual(table_of(self.folder / "out"), table_of(self.folder / "one"))
        for kind in ("out", "one"):
            self.assertEqual(list((self.folder / kind).glob("**/.*")), [])
        for scan in self.scans:
            one, other = (next((self.folder / k / "results").glob(f"*/{scan.name}")) for k in ("out", "one"))
            self.assert_same_files(one, other)


if __name__ == "__main__":
    unittest.main()
