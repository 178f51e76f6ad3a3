# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The examples of the README."""

import doctest

from shapes import BINDING


def test_readme() -> None:
    result = doctest.testfile(str(BINDING / "README.md"), module_relative=False)
    assert result.attempted >= 10
    assert result.failed == 0
