"""Objects that are found, compared with ground truth."""

from __future__ import annotations

import json
import os
import warnings
from typing import Any, Dict, Union

from . import _symscene
from ._options import Options, Progress, options_json


def evaluate(
    dataset: Union[str, "os.PathLike[str]"],
    *,
    fast: bool = False,
    options: Options = None,
    progress: Progress = None,
    threads: int = 0,
    **keywords: Any,
) -> Dict[str, Any]:
    """Segment the scenes of a dataset and compare the objects with their ground truth.

    dataset: a dataset folder, any folder of scene folders with truth.json, or one of labelled depth
        images, as `symscene evaluate` takes it.
    fast: leave out the variants without the rotational stream.
    options, keywords: options of `symscene segment`, in groups (default_options("segment")).
    progress: is called with scene and stage when a stage begins.
    threads: most threads; 0: all cores. All but times does not depend on it.

    Returns what report.json holds (docs/formats.md), without baselines and without a date. Raises
    InputError, with the command's sentence, also if the module was built without the evaluation's wing.
    """
    text, told = _symscene.evaluate(
        os.fspath(dataset), options_json(options, keywords), fast, progress, threads
    )
    for warning in told:
        warnings.warn(warning, stacklevel=2)
    report: Dict[str, Any] = json.loads(text)
    return report
