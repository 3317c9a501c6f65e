"""Options as dictionaries and keyword arguments, and what functions call while they run."""

from __future__ import annotations

import json
import math
import os
from typing import Any, Callable, List, Mapping, NamedTuple, Optional

import numpy as np

from . import _symscene

Options = Optional[Mapping[str, Any]]
"""Options in groups, as a --config file of the command holds them."""

Progress = Optional[Callable[[str], object]]
"""Called with the name of each stage when it begins. What it raises ends the work."""


class OptionDescription(NamedTuple):
    """An option, by its path through the groups."""

    name: str
    default: Any
    unit: str
    range: str
    help: str


def _plain(value: Any) -> Any:
    """What JSON can hold. Numbers that it cannot hold become text, which the reader refuses."""
    if isinstance(value, Mapping):
        return {str(key): _plain(inner) for key, inner in value.items()}
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if value is None or isinstance(value, (bool, int, float, str, list, tuple)):
        return value
    return repr(value)


def _merged(options: Mapping[str, Any], keywords: Mapping[str, Any]) -> dict[str, Any]:
    """Groups of both; where both have an option, that of the keywords."""
    merged = dict(options)
    for name, value in keywords.items():
        inner = merged.get(name)
        both = isinstance(inner, Mapping) and isinstance(value, Mapping)
        merged[name] = _merged(inner, value) if both else value  # type: ignore[arg-type]
    return merged


def options_json(options: Options, keywords: Mapping[str, Any]) -> str:
    """The options as the reader of the library takes them."""
    if options is not None and not isinstance(options, Mapping):
        _symscene.refuse("options", "a dictionary", f"a value of type {type(options).__name__}")
    return json.dumps(_plain(_merged(options or {}, keywords)))


def default_options(function: str) -> dict[str, Any]:
    """The options of a function and their defaults, in groups.

    function: "segment" (also of segment_depth), "symmetries", "partial_symmetries",
    "reconstruct" or "grasps".
    """
    values: dict[str, Any] = json.loads(_symscene.option_values(function))
    return values


def describe_options(function: str) -> List[OptionDescription]:
    """The options of a function with default, unit, range and help; see default_options()."""
    return [OptionDescription(*row) for row in _symscene.option_descriptions(function)]
