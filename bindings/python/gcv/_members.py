# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The members of a scene and its container: how they come, change and go.

The base class of scenes. It copies, pickles and draws them, too.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from copy import deepcopy
from ctypes import byref, c_uint64, sizeof
from itertools import repeat
from typing import TYPE_CHECKING, Any, Callable, Optional, SupportsIndex, TypeVar, Union, overload

from . import _ffi, _structs
from ._at_once import at_once, setting
from ._contacts import record, records
from ._coordinates import check_order, point_or_points, points, size, unfit
from ._gate import Gate
from ._many import handle_array, vertices
from ._polygon import Polygon, as_polygon
from ._several import Polygons, polygons_of
from ._sources import PolygonLike, Vector, Vectors
from ._whole_numbers import WholeNumbers, ids_of, layers_of, one_id

if TYPE_CHECKING:
    import numpy
    import numpy.typing

_MembersType = TypeVar("_MembersType", bound="Members")

CONTAINER_ID, FIRST_ID = 1, 2
_IDS_AT_A_TIME = 1 << 16
_POSITIONS = "a pair of numbers, nor a sequence of pairs"


class Members:
    """Polygons at positions, by their ids, and perhaps a container."""

    __slots__ = (
        *("__weakref__", "_container", "_gate", "_handle", "_last", "_layers", "_polygons"),
        "_vertices",
    )

    _gate: Gate
    _handle: _ffi.Scene
    _container: Optional[Polygon]
    _polygons: dict[int, Polygon]
    """The polygons of the members as passed, by id, from the smallest on."""
    _layers: dict[int, int]
    """The layers of the members that were put into any."""
    _last: int
    """The last id that was given to a member."""
    _vertices: int
    """The number of vertices of all members."""

    def __init__(self, container: Optional[PolygonLike] = None) -> None:
        handle = _ffi.Scene()
        _ffi.scene_create(byref(handle))
        self._gate, self._handle = Gate(), handle
        self._container, self._polygons, self._layers = None, {}, {}
        self._last, self._vertices = FIRST_ID - 1, 0
        if container is not None:
            self.container = container

    @property
    def container(self) -> Optional[Polygon]:
        """The polygon that members are to be in, id 1; None for none. It can be set.

        All outside of it is solid, and so are its holes: what lies in it touches it or is
        apart from it. It may overlap members. It is set from whatever Polygon can be made
        from.
        """
        return self._container

    @container.setter
    def container(self, container: Optional[PolygonLike]) -> None:
        polygon = None if container is None else as_polygon(container, "container")
        handle = None if polygon is None else polygon._handle
        note = setting(self, "_container", (polygon,))
        self._gate.change(lambda: at_once(_ffi.scene_set_container, (self._handle, handle), note))

    @overload
    def add(  # type: ignore[overload-overlap]
        self, polygons: PolygonLike, positions: Vector = ...
    ) -> int: ...

    @overload
    def add(
        self, polygons: Polygons, positions: Union[Vector, Vectors] = ...
    ) -> numpy.typing.NDArray[numpy.uint64]: ...

    def add(self, polygons: Polygons, positions: Any = (0, 0)) -> Any:
        """Add one polygon at one position, and return its id; or many, and return an array.

        polygons: a polygon, or whatever Polygon can be made from; or a sequence of them. A
        sequence that begins with a pair of numbers is one polygon. Members that share a
        Polygon share what is computed for it.

        positions: (x, y), in input units; or an array of shape (n, 2), or a sequence of
        pairs. One polygon at many positions is as many members, and one position stands
        for all polygons. The coordinates of a member are sums of two floats, and are never
        rounded.

        An array of ids is one of n uint64; a list without numpy. New members are in all
        layers.

        Raises as Polygon does, and InputError for a position that is no pair of numbers or
        not finite, and where there are not as many polygons as positions; the scene is then
        as it was.
        """
        found, is_one = polygons_of(polygons, "polygons")
        doubles, is_pair = _pairs(positions)
        count = _in_common(
            {
                "polygons": None if is_one else len(found),
                "positions": None if is_pair else size(doubles),
            }
        )
        found = found * count if is_one else found
        doubles = doubles * count if is_pair else doubles
        ids, handles = (c_uint64 * count)(), handle_array(found)
        vertex_count = sum(map(vertices, found))

        def change() -> None:
            at_once(
                *(_ffi.scene_add, (self._handle, handles, doubles, count, ids)),
                map(self._polygons.update, (zip(ids, found),)),
                setting(self, "_last", reversed(ids)),
                setting(self, "_vertices", (self._vertices + vertex_count,)),
            )

        self._gate.change(change)
        return record(ids) if is_one and is_pair else records(ids)

    def set(
        self,
        ids: WholeNumbers,
        polygons: Optional[Polygons] = None,
        positions: Any = None,
    ) -> None:
        """Give members other polygons, or other positions, or both.

        ids: of one member, or a sequence or an array of them, each once. polygons,
        positions: as in add, one for all of them or one for each; None for those that they
        have.

        Raises as add does, and InputError for an id that is no member's or is given twice;
        the scene is then as it was.
        """
        numbers, _ = ids_of(ids, "ids")
        counts: dict[str, Optional[int]] = {"ids": len(numbers)}
        found: Optional[list[Polygon]] = None
        doubles: Optional[bytes] = None
        if polygons is not None:
            found, is_one = polygons_of(polygons, "polygons")
            counts["polygons"] = None if is_one else len(found)
            found = found * len(numbers) if is_one else found
        if positions is not None:
            doubles, is_pair = _pairs(positions)
            counts["positions"] = None if is_pair else size(doubles)
            doubles = doubles * len(numbers) if is_pair else doubles
        count = _in_common(counts, ids)
        handles = None if found is None else handle_array(found)
        arguments = self._handle, numbers.tobytes(), handles, doubles, count

        def change() -> None:
            notes: list[Iterator[object]] = []
            if found is not None:
                more = sum(map(vertices, found)) - self._vertices_of(numbers)
                notes.append(map(self._polygons.update, (zip(numbers, found),)))
                notes.append(setting(self, "_vertices", (self._vertices + more,)))
            at_once(_ffi.scene_set, arguments, *notes)

        self._gate.change(change)

    def move(self, ids: WholeNumbers, positions: Any) -> None:
        """Move members to other positions, as set does."""
        if positions is None:
            raise unfit("positions", positions, _POSITIONS)
        self.set(ids, positions=positions)

    def set_layers(self, ids: WholeNumbers, layers: WholeNumbers) -> None:
        """Put members into layers, which questions choose from.

        ids: as in set. layers: a whole number with a bit for every layer, from 0 to
        2**32 - 1, for all of them; or one for each. A member with 0 is left out of all
        questions. The container is in every layer.

        Raises InputError as set does, and for a number that has other bits.
        """
        numbers, _ = ids_of(ids, "ids")
        bits, is_one = layers_of(layers, "layers")
        count = _in_common({"ids": len(numbers), "layers": None if is_one else len(bits)}, ids)
        bits = bits * count if is_one else bits
        arguments = self._handle, numbers.tobytes(), bits.tobytes(), count
        note = map(self._layers.update, (zip(numbers, bits),))
        self._gate.change(lambda: at_once(_ffi.scene_set_layers, arguments, note))

    def remove(self, ids: WholeNumbers) -> None:
        """Take members out. Their ids are never used again.

        ids: as in set. Raises InputError as set does; the scene is then as it was.
        """
        numbers, _ = ids_of(ids, "ids")

        def change() -> None:
            vertex_count = self._vertices - self._vertices_of(numbers)
            at_once(
                *(_ffi.scene_remove, (self._handle, numbers.tobytes(), len(numbers))),
                map(self._polygons.pop, numbers),
                map(self._layers.pop, numbers, repeat(None)),
                setting(self, "_vertices", (vertex_count,)),
            )

        self._gate.change(change)

    def _vertices_of(self, ids: Iterable[int]) -> int:
        """The number of vertices of those of the ids that are of members."""
        found = map(self._polygons.get, ids)
        return sum(vertices(polygon) for polygon in found if polygon is not None)

    @property
    def ids(self) -> numpy.typing.NDArray[numpy.uint64]:
        """The ids of all members, from the smallest on: an array of n uint64.

        A list without numpy.
        """
        found: numpy.typing.NDArray[numpy.uint64] = records(self._ids())
        return found

    def _ids(self) -> Any:
        return self._gate.ask(lambda: _ffi.elements(_ffi.scene_ids, c_uint64, self._handle))

    @overload
    def positions(self, ids: int) -> tuple[float, float]: ...

    @overload
    def positions(
        self, ids: Optional[Iterable[Any]] = ...
    ) -> numpy.typing.NDArray[numpy.float64]: ...

    @overload
    def positions(self, ids: SupportsIndex) -> tuple[float, float]: ...

    def positions(self, ids: Optional[WholeNumbers] = None) -> Any:
        """The position of one member, (x, y); or of many, an array of shape (n, 2).

        ids: as in set; None for all members, from the smallest id on. The array is the
        caller's, and a list of pairs without numpy.

        Raises InputError for an id that is no member's or is given twice.
        """
        check_order(ids, "ids")

        def ask() -> tuple[Any, bool]:
            numbers, is_one = ids_of(self._ids() if ids is None else ids, "ids")
            out = (_structs.Point * len(numbers))()
            _ffi.scene_positions(self._handle, numbers.tobytes(), len(numbers), out)
            return out, is_one

        out, is_one = self._gate.ask(ask)
        return record(out) if is_one else records(out)

    def polygon(self, id: SupportsIndex) -> Polygon:
        """The polygon of a member as it was passed, before it is moved to its position.

        Raises InputError for an id that is no member's.
        """
        number = one_id(id, "id")
        polygon = self._polygons.get(number)
        if polygon is None:
            whose = "the container's, " if number == CONTAINER_ID else ""
            message = f"id is {number}, {whose}not that of a member"
            raise _ffi.InputError(_ffi.INVALID_ARGUMENT, message)
        return polygon

    def copy(self: _MembersType) -> _MembersType:
        """A scene with the same members, ids, layers and container.

        From then on each changes alone. Members that are added to both get the same ids.
        Takes O(n).
        """
        made = type(self).__new__(type(self))
        made._gate, made._handle = Gate(), _ffi.Scene()

        def ask() -> None:
            _ffi.scene_copy(self._handle, byref(made._handle))
            made._container, made._vertices = self._container, self._vertices
            made._polygons, made._layers = dict(self._polygons), dict(self._layers)
            made._last = self._last

        self._gate.ask(ask)
        _attributes(made).update(_attributes(self))
        return made

    def __copy__(self: _MembersType) -> _MembersType:
        return self.copy()

    def __deepcopy__(self: _MembersType, memo: dict[int, Any]) -> _MembersType:
        made = self.copy()
        _attributes(made).update(deepcopy(_attributes(self), memo))
        return made

    def __len__(self) -> int:
        """The number of members."""
        return len(self._polygons)

    def __iter__(self) -> Iterator[int]:
        """The ids of the members that there are now, from the smallest on."""
        return iter(list(self._polygons))

    def __contains__(self, id: object) -> bool:
        """Whether there is a member with that id."""
        try:
            return id in self._polygons
        except TypeError:  # it has no hash, so it is no id
            return False

    def __repr__(self) -> str:
        members = f"{len(self)} member{'s' if len(self) != 1 else ''}"
        container = " in a container" if self._container is not None else ""
        return f"<gcv.{type(self).__name__} of {members}{container}>"

    def __reduce__(
        self,
    ) -> tuple[Callable[..., Members], tuple[Any, ...], Optional[dict[str, Any]]]:
        state = self._gate.ask(
            lambda: (
                *(type(self), self._container, dict(self._polygons), self._all_positions()),
                *(dict(self._layers), self._last),
            )
        )
        return _restored, state, _attributes(self) or None

    def _all_positions(self) -> bytes:
        """The positions of all members, as doubles."""
        numbers = bytes(self._ids())
        out = (_structs.Point * (len(numbers) // sizeof(c_uint64)))()
        _ffi.scene_positions(self._handle, numbers, len(out), out)
        return bytes(out)


def _pairs(positions: Any) -> tuple[bytes, bool]:
    """The doubles of one position or of many, and whether it is one."""
    return point_or_points(positions, "positions", _POSITIONS)


def _attributes(scene: Members) -> dict[str, Any]:
    """The attributes that a class derived from Scene has beside its own."""
    return getattr(scene, "__dict__", {})


def _in_common(counts: dict[str, Optional[int]], ids: Any = ()) -> int:
    """The number of members that arguments are about, by the numbers that each has.

    None is for one that stands for all. Raises InputError where the others differ, and for
    a set of ids where each has something of its own.
    """
    known = {name: count for name, count in counts.items() if count is not None}
    if len(known) > 1:
        check_order(ids, "ids")
    if len(set(known.values())) > 1:
        found = " and ".join(f"{name} has {n} elements" for name, n in known.items())
        raise _ffi.InputError(_ffi.INVALID_ARGUMENT, found)
    return next(iter(known.values()), 1)


def _restored(
    kind: type[_MembersType],
    container: Optional[Polygon],
    polygons: dict[int, Polygon],
    positions: bytes,
    layers: dict[int, int],
    last: int,
) -> _MembersType:
    """The scene of a pickle.

    The library gives out ids one after the other. So members for all of them are added, and
    those for ids that are not in use are removed again. A class derived from Scene, which
    has no attributes yet, is not asked.
    """
    scene = kind.__new__(kind)
    Members.__init__(scene, container)
    places = dict(zip(polygons, points(positions)))
    none = Polygon([(0, 0), (1, 0), (0, 1)]), (0.0, 0.0)
    for start in range(FIRST_ID, last + 1, _IDS_AT_A_TIME):
        ids = range(start, min(start + _IDS_AT_A_TIME, last + 1))
        members = [(polygons[k], places[k]) if k in polygons else none for k in ids]
        Members.add(scene, [polygon for polygon, _ in members], [place for _, place in members])
        Members.remove(scene, [k for k in ids if k not in polygons])
    Members.set_layers(scene, list(layers), layers.values())
    return scene
