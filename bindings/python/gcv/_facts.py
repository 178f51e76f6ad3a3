# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What outer faces and regions have in common.

The facts that the library knows of a result, each asked once, when needed; and the
types of some of them.
"""

from __future__ import annotations

import struct
from ctypes import byref, c_char, c_double, c_uint64, c_void_p
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Callable, ClassVar, NamedTuple, Optional

from . import _ffi, _structs

if TYPE_CHECKING:
    import numpy
    import numpy.typing

EDGE_TRANSLATED = 1
"""Edge a of A, translated by vertex b of B."""
EDGE_CORNER = 2
"""Edge b of B, translated by vertex a of A."""
EDGE_TRANSLATED_CORNER = 3
"""Edge a of A and edge b of B, which have the same direction, merged."""


class EdgeSource(NamedTuple):
    """Where an edge of a sum comes from.

    The kind says whether a and b are numbers of vertices or of edges: of vertex k as
    passed, or of the edge from vertex k to k+1. As in Contact, they are no indices of
    Polygon.vertices, and edges past points on a straight line have the number of the first.
    """

    kind: int
    """EDGE_TRANSLATED, EDGE_CORNER or EDGE_TRANSLATED_CORNER; 0 where a region has no edge."""
    a: int
    """Of A."""
    b: int
    """Of B."""


class Stats(NamedTuple):
    """What a computation took: counts, the same on every run, not times."""

    walk_steps: int
    """Edges that the walk went along."""
    candidate_edges: int
    """Superset edges that it looked at."""
    predicates_filtered: int
    """Predicates settled by floats with a proven error bound or by indices."""
    predicates_fixed_width: int
    """Predicates settled by pairs of floats or integers of at most 512 bits."""
    predicates_rational: int
    """Predicates that needed larger integers, of up to 21,504 bits."""
    vertices_repaired: int
    """Vertices moved further than to the nearest float to keep rings simple and apart."""
    parts_dropped: int = 0
    """Parts of the exact region that floats cannot show; 0 for outer faces."""


class Result:
    """A result of the library, by its handle, and what is known of it without one.

    A pickle has all facts and no handle.
    """

    __slots__ = ("__weakref__", "_facts", "_handle", "_lists")

    _questions: ClassVar[dict[str, Callable[[Any], Any]]]
    """How each fact is asked of the library. An exception is a fact too."""

    def __init__(self, handle: Any = None, facts: Optional[dict[str, Any]] = None) -> None:
        if facts is None and not isinstance(handle, c_void_p):
            raise made_by_itself(self)
        self._handle = handle
        self._facts = {} if facts is None else facts
        self._lists: dict[str, list[Any]] = {}

    def _known(self, name: str) -> Any:
        if name not in self._facts:
            self._facts[name] = (
                NotImplementedError(f"{name}: not in the pickle, which an earlier version made")
                if self._handle is None
                else self._questions[name](self._handle)
            )
        return self._facts[name]

    def _fact(self, name: str) -> Any:
        fact = self._known(name)
        if isinstance(fact, Exception):
            raise fact.with_traceback(None)
        return fact

    def _list(self, name: str, make: Callable[[Any], list[Any]]) -> list[Any]:
        """A list that is made of a fact at the first access: not to be changed."""
        if name not in self._lists:
            self._lists[name] = make(self._fact(name))
        return self._lists[name]

    @property
    def _doubles(self) -> bytes:
        doubles: bytes = self._fact("doubles")
        return doubles

    @property
    def stats(self) -> Stats:
        """What the computation took."""
        stats: Stats = self._fact("stats")
        return stats

    def __reduce__(self) -> tuple[type[Result], tuple[None, dict[str, Any]]]:
        return type(self), (None, {name: self._known(name) for name in self._questions})


def made_by_itself(made: object) -> TypeError:
    """The error for arguments that neither the library nor a pickle has."""
    return TypeError(f"no {type(made).__name__} can be made by itself: functions return it")


def of_elements(function: Any, kind: Any) -> Callable[[Any], bytes]:
    """The bytes of what a buffer function gives, which are structs of that type."""
    return lambda handle: bytes(_ffi.elements(function, kind, handle))


def of_text(function: Any) -> Callable[[Any], str]:
    return lambda handle: text(function, handle)


def of_number(function: Any) -> Callable[[Any], float]:
    return lambda handle: float(_ffi.value(function, c_double, handle))


def of_area(function: Any) -> Callable[[Any], Any]:
    """The area, or the error where there is none in floats."""

    def ask(handle: Any) -> Any:
        try:
            return float(_ffi.value(function, c_double, handle))
        except _ffi.Error as error:
            return error.with_traceback(None)

    return ask


def of_indices(function: Any) -> Callable[[Any], Any]:
    """The bytes of indices, or the error of a library that has none."""

    def ask(handle: Any) -> Any:
        try:
            return bytes(_ffi.elements(function, c_uint64, handle))
        except NotImplementedError as error:
            return error.with_traceback(None)

    return ask


def of_stats(function: Any) -> Callable[[Any], Stats]:
    def ask(handle: Any) -> Stats:
        stats = _structs.sized(_structs.Stats)
        function(handle, byref(stats))
        return Stats(*(getattr(stats, name) for name in Stats._fields))

    return ask


def text(function: Any, *arguments: Any) -> str:
    """What a function for text gives."""
    encoded: bytes = _ffi.elements(function, c_char, *arguments).value
    return encoded.decode()


def exact_points(vertices: list[str]) -> list[tuple[Fraction, Fraction]]:
    """The vertices, each of which the library writes as two fractions."""
    return [(Fraction(x), Fraction(y)) for x, y in map(str.split, vertices)]


def edge_sources(sources: bytes) -> list[EdgeSource]:
    return [EdgeSource(*edge) for edge in struct.iter_unpack("=iII", sources)]


def indices(integers: bytes) -> numpy.typing.NDArray[numpy.int64]:
    """An array that looks at the integers; a list without numpy."""
    try:
        import numpy
    except ImportError:
        return [k for (k,) in struct.iter_unpack("=q", integers)]  # type: ignore[return-value]
    return numpy.frombuffer(integers, "int64")
