# SPDX-License-Identifier: LGPL-3.0-or-later
"""The shared library exports the functions of gcv.h, all of them and nothing else."""

import argparse
import pathlib
import re
import subprocess
import sys


def exported(nm: str) -> set[str]:
    """The defined symbols of `nm -D --defined-only`, but for version nodes (type A)."""
    lines = [line.split() for line in nm.splitlines()]
    return {line[-1].split("@")[0] for line in lines if line and line[-2] != "A"}


def mapped(version_script: str) -> set[str]:
    names = re.findall(r"global:(.*?)(?:local:|\})", version_script, re.DOTALL)
    return {name for part in names for name in re.findall(r"[^\s;]+", part)}


def declared(header: str) -> set[str]:
    code = re.sub(r"/\*.*?\*/|^#.*?$", "", header, flags=re.DOTALL | re.MULTILINE)
    return set(re.findall(r"GCV_API\b[^;()]*?(\w+)\(", code))


def complaints(nm: str, version_script: str, header: str, readelf: str) -> list[str]:
    names = declared(header)
    found = [] if names else ["the header declares nothing"]
    for place, others in (("library", exported(nm)), ("version script", mapped(version_script))):
        found += [f"{name} is in the header, not in the {place}" for name in names - others]
        found += [f"{name} is in the {place}, not in the header" for name in others - names]
    if not re.search(r"\(SONAME\).*\[libgcv\.so\.0\]", readelf):
        found.append("the SONAME is not libgcv.so.0")
    return found


def controls(nm: str, version_script: str, header: str, readelf: str) -> dict[str, list[str]]:
    """What must be complained about."""
    symbol = "0000000000001000 T "
    return {
        "a symbol too many": complaints(nm + symbol + "_ZN3gcv3sumEv@@GCV_0.1\n",
                                        version_script, header, readelf),
        "a weak symbol too many": complaints(nm + symbol.replace("T", "u") + "_ZGVfoo\n",
                                             version_script, header, readelf),
        "a symbol too few": complaints(re.sub(r".* gcv_polygon_area\b.*\n", "", nm),
                                       version_script, header, readelf),
        "a wildcard": complaints(nm, version_script.replace("global:", "global: gcv_*;"),
                                 header, readelf),
        "a mapped name too few": complaints(nm, version_script.replace("gcv_polygon_area;", ""),
                                            header, readelf),
        "a function too many": complaints(
            nm, version_script, header + "GCV_API int gcv_new(void);\n", readelf),
        "another SONAME": complaints(nm, version_script, header,
                                     readelf.replace("libgcv.so.0", "libgcv.so.1")),
    }


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--nm", required=True)
    parser.add_argument("--readelf", required=True)
    parser.add_argument("--library", required=True)
    parser.add_argument("--version-script", type=pathlib.Path, required=True)
    parser.add_argument("--header", type=pathlib.Path, required=True)
    options = parser.parse_args()

    def output_of(*command: str) -> str:
        return subprocess.run(command, check=True, capture_output=True, text=True).stdout

    texts = (output_of(options.nm, "-D", "--defined-only", options.library),
             options.version_script.read_text(), options.header.read_text(),
             output_of(options.readelf, "-d", "-W", options.library))
    found = complaints(*texts)
    found += [f"not noticed: {name}" for name, noticed in controls(*texts).items() if not noticed]
    print(*found, sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
