# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The examples of the README, and those of a page of the documentation."""

import doctest

from shapes import BINDING

CONTACTS = BINDING.parent.parent / "docs" / "CONTACTS.md"


def test_readme() -> None:
    result = doctest.testfile(str(BINDING / "README.md"), module_relative=False)
    assert result.attempted >= 10
    assert result.failed == 0


def test_contacts() -> None:
    result = doctest.testfile(str(CONTACTS), module_relative=False)
    assert result.attempted >= 5
    assert result.failed == 0
