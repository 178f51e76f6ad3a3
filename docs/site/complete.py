# SPDX-License-Identifier: LGPL-3.0-or-later
"""The references have everything: each function that the library exports, each name of Python."""

from __future__ import annotations

import re
from pathlib import Path

import gcv
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.errors import ExtensionError

MAP = Path(__file__).resolve().parent.parent.parent / "capi" / "gcv.map"


def check(app: Sphinx, env: BuildEnvironment) -> None:
    exported = set(re.findall(r"^ +(gcv_\w+);", MAP.read_text(encoding="utf-8"), re.MULTILINE))
    in_c = {name for name, *_ in env.domains["c"].get_objects()}
    in_python = {name for name, *_ in env.domains["py"].get_objects()}
    missing = sorted(exported - in_c) + [
        name for name in gcv.__all__ if f"gcv.{name}" not in in_python
    ]
    if missing:
        raise ExtensionError(f"the references lack {', '.join(missing)}")


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("env-check-consistency", check)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
