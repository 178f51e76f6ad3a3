# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The examples of the README, and those of pages of the documentation."""

import doctest

import pytest
from shapes import BINDING

DOCS = BINDING.parent.parent / "docs"


def test_readme() -> None:
    result = doctest.testfile(str(BINDING / "README.md"), module_relative=False)
    assert result.attempted >= 10
    assert result.failed == 0


@pytest.mark.parametrize("page", ["CONTACTS.md", "SCENES.md"])
def test_page(page: str) -> None:
    result = doctest.testfile(str(DOCS / page), module_relative=False)
    assert result.attempted >= 5
    assert result.failed == 0
