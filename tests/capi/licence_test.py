# SPDX-License-Identifier: LGPL-3.0-or-later
"""Nothing that ships is compiled from a header under the GPL.

Which headers those are is what the compiler wrote down for the build: in the log of
Ninja, or in the .d files beside the objects that Make's rules leave.
"""

import argparse
import pathlib
import re
import subprocess
import sys


def says_gpl(text: str) -> bool:
    return re.search(r"SPDX-License-Identifier:.*?(?<!L)GPL-3\.0", text) is not None


def ninja_dependencies(ninja: str, build: pathlib.Path, target: str) -> list[str]:
    lines = subprocess.run([ninja, "-C", build, "-t", "deps", target], check=True,
                           capture_output=True, text=True).stdout.splitlines()
    return [line.strip() for line in lines if line.startswith(" ")]


def make_dependencies(rule_file: pathlib.Path) -> list[str]:
    rule = rule_file.read_text().replace("\\\n", " ") if rule_file.exists() else ":"
    return re.split(r"(?<!\\)\s+", rule.split(": ", 1)[-1].strip(" :\n"))


def dependencies(build: pathlib.Path, make_program: str, target: str) -> set[pathlib.Path]:
    if (build / "build.ninja").exists():
        names = ninja_dependencies(make_program, build, target)
    else:
        names = make_dependencies(build / f"{target}.d")
    return {build / name for name in names if name}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--make-program", required=True)
    parser.add_argument("--gpl-header", type=pathlib.Path, help="a header to be recognised")
    parser.add_argument("objects", nargs="+", type=pathlib.Path)
    options = parser.parse_args()

    headers: set[pathlib.Path] = set()
    found = []
    for path in options.objects:
        names = dependencies(options.build, options.make_program,
                             str(path.relative_to(options.build)))
        if len(names) < 2:
            found.append(f"{path}: the compiler's dependencies are not known")
        headers |= names

    def under_gpl(paths: set[pathlib.Path]) -> list[pathlib.Path]:
        return [path for path in sorted(paths) if says_gpl(path.read_text(errors="replace"))]

    found += [f"{path} is under the GPL" for path in under_gpl(headers)]
    if not says_gpl("// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial"):
        found.append("a text under the GPL is not noticed")
    if says_gpl("// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial"):
        found.append("a text under the LGPL is taken for one under the GPL")
    if options.gpl_header and not under_gpl(headers | {options.gpl_header}):
        found.append(f"{options.gpl_header}, which is under the GPL, is not noticed")
    print(*found, f"{len(headers)} files read", sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
