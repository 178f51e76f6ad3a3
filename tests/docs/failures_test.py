# SPDX-License-Identifier: LGPL-3.0-or-later
"""The tests of the pages fail where a page is wrong, and pass where it is right.

Takes the languages to be tried. Each has a page here, and what breaks it.
"""

from __future__ import annotations

import pathlib
import sys
import tempfile
import textwrap

from blocks_test import check_marks
from pages import blocks
from runners import faults

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent

# A page, and pairs: what is replaced by what to break it.
PAGES = {
    "c": (
        """
        ```c
        #include <gcv/gcv.h>
        #include <stdio.h>
        int main(void) { return puts(gcv_status_name(GCV_OK)) < 0; }
        ```

        ```
        GCV_OK
        ```
        """,
        [("\nGCV_OK", "\nGCV_NO"), ("GCV_OK)", "GCV_FINE)"), ("< 0", ">= 0")],
    ),
    "cell": (
        """
        ```{code-cell} python
        import gcv
        ```

        ```{code-cell} python
        assert gcv.Polygon([(0, 0), (1, 0), (0, 1)]).area == 0.5
        ```
        """,
        [("0.5", "0.4"), ("import gcv", "")],
    ),
    "console": (
        """
        ```console
        $ echo 'POLYGON ((0 0, 1 0, 0 1))' > triangle.wkt
        $ gcv sum triangle.wkt triangle.wkt
        POLYGON ((0 0, 2 0, 0 2, 0 0))
        ```
        """,
        [("2 0", "3 0"), ("gcv sum", "gcv some")],
    ),
    "js": (
        """
        ```js
        import { minkowskiSum } from "gcv";
        const triangle = [[0, 0], [1, 0], [0, 1]];
        console.log(minkowskiSum(triangle, triangle).area); // 2: area
        ```
        """,
        [("// 2", "// 3"), ("minkowskiSum(", "sum(")],
    ),
    "python": (
        """
        ```python
        >>> import gcv
        >>> gcv.Polygon([(0, 0), (1, 0), (0, 1)]).area
        0.5

        ```

        ```python
        print(1)
        ```

        ```
        1
        ```
        """,
        [("0.5", "0.4"), ("\n1", "\n2"), ("print", "prind")],
    ),
    "rust": (
        """
        ```rust
        fn main() {
            println!("{}", gcv::library_version().len());
        }
        ```

        ```
        5
        ```
        """,
        [("\n5", "\n6"), ("library_version", "libraries")],
    ),
    "marks": (
        """
        <!-- not run: takes minutes -->
        ```sh
        tests/run
        ```

        <!-- run by rust.test -->
        ```rust
        nothing
        ```
        """,
        [("tests/run", "tests/runs"), ("tests/run", "tests/run ("), ("rust.test", "rust.text"),
         ("<!-- not run: takes minutes -->", "")],
    ),
}  # fmt: skip


def count(text: str, language: str) -> int:
    with tempfile.TemporaryDirectory() as folder:
        page = pathlib.Path(folder) / "page.md"
        page.write_text(text)
        found = list(blocks(page))
    return len(list(check_marks(ROOT, found)) if language == "marks" else faults(found, language))


def main() -> int:
    wrong = []
    for language in sys.argv[1:]:
        page, breaks = PAGES[language]
        page = textwrap.dedent(page)
        if count(page, language):
            wrong.append(f"{language}: the page is right, and fails")
        for before, after in breaks:
            if not count(page.replace(before, after), language):
                wrong.append(f"{language}: passes with {after!r} in place of {before!r}")
        print(f"{language}: {len(breaks)} broken pages")
    print(*wrong, f"{len(wrong)} faults", sep="\n")
    return int(bool(wrong) or len(sys.argv) < 2)


if __name__ == "__main__":
    sys.exit(main())
