# SPDX-License-Identifier: LGPL-3.0-or-later
"""gcv.dll exports the functions of gcv.h and nothing else, and needs only DLLs of Windows.

It can be loaded at any address, and its data cannot be executed.
"""

import argparse
import pathlib
import re
import subprocess
import sys

SYSTEM = {"KERNEL32.dll", "msvcrt.dll"}
GUARDS = ("HIGH_ENTROPY_VA", "DYNAMIC_BASE", "NX_COMPAT")


def declared(header: str) -> set[str]:
    code = re.sub(r"/\*.*?\*/|^#.*?$", "", header, flags=re.DOTALL | re.MULTILINE)
    return set(re.findall(r"GCV_API\b[^;()]*?(\w+)\(", code))


def complaints(objdump: str, header: str) -> list[str]:
    """What is wrong, by `objdump -p`."""
    names = declared(header)
    exported = set(re.findall(r"(?m)^\t\[ *\d+\] (\w+)$", objdump))
    needed = set(re.findall(r"DLL Name: (\S+)", objdump))
    found = [] if names and needed else ["nothing is declared, or nothing needed"]
    found += [f"{name} is in the header, not in the DLL" for name in sorted(names - exported)]
    found += [f"{name} is in the DLL, not in the header" for name in sorted(exported - names)]
    found += [f"{name} is not a DLL of Windows" for name in sorted(needed - SYSTEM)]
    found += [f"there is not: {guard}" for guard in GUARDS if guard not in objdump]
    return found


def controls(objdump: str, header: str) -> dict[str, list[str]]:
    """What must be complained about."""
    return {
        "a function too many": complaints(objdump + "\t[ 999] _ZN3gcv3sumEv\n", header),
        "a function too few": complaints(objdump.replace("gcv_polygon_area", "", 1), header),
        "another DLL": complaints(objdump + "\tDLL Name: libstdc++-6.dll\n", header),
        **{guard: complaints(objdump.replace(guard, ""), header) for guard in GUARDS},
    }


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--objdump", required=True)
    parser.add_argument("--header", type=pathlib.Path, required=True)
    parser.add_argument("dll")
    options = parser.parse_args()

    command = [options.objdump, "-p", options.dll]
    objdump = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    texts = (objdump, options.header.read_text())
    found = complaints(*texts)
    found += [f"not noticed: {name}" for name, noticed in controls(*texts).items() if not noticed]
    print(*found, sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
