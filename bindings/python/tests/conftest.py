# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What all tests begin with."""

from hypothesis import settings

settings.register_profile("gcv", deadline=None, derandomize=True, database=None)
settings.load_profile("gcv")
