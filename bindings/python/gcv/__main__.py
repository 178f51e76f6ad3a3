# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The program gcv, which python -m gcv is too."""

import sys

from ._command_line import main

if __name__ == "__main__":
    sys.exit(main())
