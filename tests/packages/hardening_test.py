# SPDX-License-Identifier: LGPL-3.0-or-later
"""What ships has what makes defects hard to exploit.

The shared library: full RELRO, no executable stack, the stack protector, and the checked
buffer functions of the C library. Its objects, as the static library has them, on x86: CET,
that is indirect branch tracking and the shadow stack. The shared library itself is marked
for CET only where the system's own start-up files are, which is not so in Debian 12.
"""

import argparse
import re
import subprocess
import sys


def complaints(shared: str, static: str, fortified: bool) -> list[str]:
    """What is missing, by readelf."""
    wanted = {
        "read-only relocations (RELRO)": r"GNU_RELRO\s",
        "binding at start (BIND_NOW)": r"\((FLAGS|FLAGS_1)\).*\b(BIND_)?NOW\b",
        "a stack that is not executable": r"GNU_STACK(\s+0x\w+)+\s+RW\s",
        "the stack protector": r"UND\s+__stack_chk_fail@",
    }
    if fortified:
        wanted["checked buffer functions (fortify)"] = r"UND\s+__\w+_chk@"
    found = [name for name, pattern in wanted.items() if not re.search(pattern, shared)]
    if re.search(r"Machine:.*(X86-64|80386)", shared):
        objects = re.split(r"(?m)^File: ", static)[1:]
        found += [
            f"CET in {text.splitlines()[0]}"
            for text in objects
            if not re.search(r"x86 feature:.*\bIBT, SHSTK\b", text)
        ]
        if not objects:
            found.append("an object in the static library")
    return found


def controls(shared: str, static: str, fortified: bool) -> dict[str, list[str]]:
    """What must be complained about."""
    changes = {
        "no RELRO": (r"GNU_RELRO", "LOAD"),
        "lazy binding": (r"\b(BIND_)?NOW\b", ""),
        "an executable stack": (r"(GNU_STACK.*)RW ", r"\1RWE"),
        "no header of the stack": (r"GNU_STACK", "NULL"),
        "no stack protector": (r"__stack_chk_fail", "memcpy"),
    }
    if fortified:
        changes["no fortify"] = (r"_chk@", "@")
    noticed = {
        name: complaints(re.sub(pattern, replacement, shared), static, fortified)
        for name, (pattern, replacement) in changes.items()
    }
    if "x86 feature" in static:
        noticed["an object without CET"] = complaints(
            shared, static.replace("IBT, SHSTK", "SHSTK", 1), fortified
        )
        noticed["no objects"] = complaints(shared, "", fortified)
    return noticed


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--readelf", default="readelf")
    parser.add_argument(
        "--no-fortify",
        action="store_true",
        help="compiled without optimisation, which fortify takes",
    )
    parser.add_argument("shared")
    parser.add_argument("static")
    options = parser.parse_args()

    def readelf(*arguments: str) -> str:
        return subprocess.run(
            [options.readelf, "-W", *arguments], check=True, capture_output=True, text=True
        ).stdout

    texts = (
        readelf("-h", "-l", "-d", "--dyn-syms", options.shared),
        readelf("-n", options.static),
        not options.no_fortify,
    )
    found = [f"there is not: {name}" for name in complaints(*texts)]
    found += [f"not noticed: {name}" for name, noticed in controls(*texts).items() if not noticed]
    print(*found, sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
