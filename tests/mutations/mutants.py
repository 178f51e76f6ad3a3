# SPDX-License-Identifier: LGPL-3.0-or-later
"""The mutants of sources of C++: one small change each, in code that is compiled.

Sources are formatted, so that binary operators have spaces around them and unary ones do not.
Comments, literals of text, lines of the preprocessor, assertions and what stands in angle brackets
stay as they are.
"""

import dataclasses
import difflib
import hashlib
import pathlib
import re
from collections.abc import Iterable, Iterator

NOT_CODE = re.compile(
    r"//[^\n]*"
    r"|/\*.*?\*/"
    r'|R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"'
    r'|"(?:\\.|[^"\\\n])*"'
    r"|(?<![0-9A-Fa-f])'(?:\\.|[^'\\\n])+'"
    r"|^[ \t]*#(?:\\\n|[^\n])*",
    re.DOTALL | re.MULTILINE,
)
ASSERTION = re.compile(r"\b(?:static_)?assert(?=\()")

OPERATORS = {
    "<": ("<=", ">="),
    "<=": ("<", ">"),
    ">": (">=", "<="),
    ">=": (">", "<"),
    "==": ("!=",),
    "!=": ("==",),
    "&&": ("||",),
    "||": ("&&",),
    "+": ("-",),
    "-": ("+",),
    "+=": ("-=",),
    "-=": ("+=",),
}
BINARY = re.compile(r"(?<= )(?:[<>=!]=|[-+]=|&&|\|\||[-+<>])(?=\s)")
UNARY = re.compile(r"(?<=[\s(\[{])[-!](?=[\w(])")
WHOLE = re.compile(r"(?<![\w.'<])(?P<number>\d+)(?:[uU]?[lL]{0,2})(?![\w.'>])")
DECIMAL = re.compile(r"(?<![\w.'])(?P<number>\d+\.\d+)(?![\w.'])")
POWER = re.compile(r"\b0x1p(?P<number>-?\d+)\b")
WORD = re.compile(r"\b(?:true|false|std::min|std::max)\b(?=\W)")
WORDS = {"true": "false", "false": "true", "std::min": "std::max", "std::max": "std::min"}
CONDITION = re.compile(r"\b(?:if|while) \(")
DECLARES = re.compile(r";|\s=\s")
NEGATED = re.compile(r"&&|\|\||[<>=!]=|\s[<>]\s|!")  # what is negated by a change of its own


@dataclasses.dataclass(frozen=True)
class Mutant:
    """The characters `begin` to `end` of a file are replaced by `after`."""

    file: str
    line: int
    column: int
    begin: int
    end: int
    before: str
    after: str

    @property
    def place(self) -> str:
        return f"{self.file}:{self.line}:{self.column}"

    @property
    def change(self) -> str:
        return f"{' '.join(self.before.split())} -> {' '.join(self.after.split()) or 'nothing'}"

    def applied(self, text: str) -> str:
        return text[: self.begin] + self.after + text[self.end :]

    def difference(self, text: str) -> str:
        changed = self.applied(text).splitlines(keepends=True)
        names = (f"a/{self.file}", f"b/{self.file}")
        return "".join(difflib.unified_diff(text.splitlines(keepends=True), changed, *names))

    def changed_lines(self, text: str) -> tuple[str, ...]:
        """The lines that the difference takes away and adds, without indentation."""
        lines = self.difference(text).splitlines()[2:]
        return tuple(line[0] + " " + line[1:].strip() for line in lines if line[0] in "-+")


def closing(text: str, opening: int) -> int:
    """The parenthesis that closes the one at `opening`."""
    depth = 0
    for k in range(opening, len(text)):
        depth += {"(": 1, ")": -1}.get(text[k], 0)
        if depth == 0:
            return k
    raise ValueError("parentheses do not match")


def code_of(text: str) -> str:
    """The text with spaces in place of all that is no code to change."""

    def blank(part: str) -> str:
        return re.sub(r"[^\n]", " ", part)

    text = NOT_CODE.sub(lambda found: blank(found.group()), text)
    for found in ASSERTION.finditer(text):
        end = closing(text, found.end())
        text = text[: found.start()] + blank(text[found.start() : end]) + text[end:]
    return text


def changes(text: str) -> Iterator[tuple[int, int, str]]:
    """Begin, end, and what is put there."""
    code = code_of(text)
    for found in BINARY.finditer(code):
        for after in OPERATORS[found.group()]:
            yield found.start(), found.end(), after
    for found in UNARY.finditer(code):
        yield found.start(), found.end(), ""
    for found in WHOLE.finditer(code):
        number = int(found["number"])
        for changed in [number + 1] + ([number - 1] if number > 0 else []):
            yield *found.span("number"), str(changed)
    for found in DECIMAL.finditer(code):
        yield *found.span("number"), str(float(found["number"]) + 1)
    for found in POWER.finditer(code):
        for changed in (int(found["number"]) + 8, int(found["number"]) - 8):
            yield *found.span("number"), str(changed)
    for found in WORD.finditer(code):
        yield found.start(), found.end(), WORDS[found.group()]
    for found in CONDITION.finditer(code):
        end = closing(code, found.end() - 1)
        condition = code[found.end() : end]
        if not DECLARES.search(condition) and len(NEGATED.findall(condition)) != 1:
            yield found.end(), end, f"!({text[found.end() : end]})"


def mutants_of(file: str, text: str) -> Iterator[Mutant]:
    for begin, end, after in changes(text):
        line = text.count("\n", 0, begin) + 1
        column = begin - (text.rfind("\n", 0, begin) + 1) + 1
        yield Mutant(file, line, column, begin, end, text[begin:end], after)


def in_order(mutants: Iterable[Mutant], seed: int) -> list[Mutant]:
    """At random by the seed: each has the same place among others whatever these are."""

    def key(mutant: Mutant) -> bytes:
        return hashlib.sha256(f"{seed} {mutant.place} {mutant.change}".encode()).digest()

    return sorted(mutants, key=key)


def all_mutants(tree: pathlib.Path, rooms: Iterable[str], seed: int) -> list[Mutant]:
    files = [file for room in rooms for file in sorted((tree / "cpp" / room).glob("*.?pp"))]
    found = [
        mutant
        for file in files
        for mutant in mutants_of(str(file.relative_to(tree)), file.read_text())
    ]
    return in_order(found, seed)
