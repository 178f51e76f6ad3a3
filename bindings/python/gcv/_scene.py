# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The class of scenes, and the lists that they give."""

from __future__ import annotations

from ctypes import byref
from types import FunctionType
from typing import Any, Optional, SupportsFloat, SupportsIndex, TypeVar

from . import _ffi, _structs
from ._call import Progress
from ._contact_list import ContactList
from ._coordinates import Points, number, pair, points, unfit
from ._drawing import GROUND_COLOUR, plot, svg
from ._many import vertices
from ._pair_list import PairList
from ._polygon import Polygon, as_polygon
from ._record_list import RecordList
from ._scene_places import Places
from ._scene_questions import NEIGHBOURS, query_of
from ._sources import PointLike, PolygonLike
from ._two_polygons import distance_in
from ._whole_numbers import WholeNumbers

_Handle = TypeVar("_Handle", _ffi.PairList, _ffi.ContactList)


class Scene(Places):
    """Polygons at positions, the members, and perhaps a container round them; it can change.

    container: what members are to be in; a polygon, or whatever Polygon can be made from,
    or None. It can be set later on.

    A member is its polygon moved by its position, exactly. Members may touch and overlap.
    They have ids: 2, 3, 4, ... as they are added. An id is never used again. The
    container's is 1. The scene keeps each Polygon as it was passed: the numbers of its
    vertices and edges are those of contacts.

    Questions are about all members and the container. layers, a whole number, leaves out
    the members that share no bit with it: set_layers gives them bits, at first they have
    all. The container is in every layer. With layers=0 there is neither. ignore, an id or
    several, leaves out these members, and 1 the container; ids that are not there are no
    error.

    The same changes in the same order give the same answers, to the bit. A change is made
    wholly or not at all. One that raises leaves the scene as it was; but KeyboardInterrupt,
    and what else a handler of a signal raises, may come after it was made. It waits for a
    change that has begun, and cancels a long question.

    Threads may share a scene. Questions of several threads run side by side. A change
    waits until no question runs, and questions wait until it is done. A progress function
    may ask the scene that is being asked, but not change it: that raises RuntimeError, and
    so cancels the question.

    len(scene), iteration and in are about the ids of members. Two scenes are equal only if
    they are one and the same. A scene can be copied and pickled: ids, layers, positions
    and container are kept, and new ids go on from where they were. To read a pickle takes
    time for every id that was ever given out. Takes version 0.2 of the library.

    Raises as Polygon does for the container.
    """

    __slots__ = ()

    def near(
        self,
        moving: PolygonLike,
        position: PointLike,
        distance: SupportsFloat = 0.0,
        *,
        layers: Optional[SupportsIndex] = None,
        ignore: WholeNumbers = (),
        threads: int = 1,
        progress: Optional[Progress] = None,
    ) -> PairList:
        """What is no further than a distance from a polygon at a position.

        Each Pair has the id of a member, or of the container, in a, and 0 in b; from the
        smallest id on.

        position: (x, y). distance: in input units, from 0 on. Exact.

        The other arguments and the errors are those of relation; InputError also for a
        distance that is negative or not finite.
        """
        polygon = as_polygon(moving, "moving")
        point = _structs.Point(*pair(position, "position"))
        limit, query, handle = (
            number(distance, "distance"),
            query_of(layers, ignore),
            _ffi.PairList(),
        )
        self._ask(
            lambda options: _ffi.scene_near(
                *(self._handle, polygon._handle, point, limit, query, options, byref(handle))
            ),
            *(self._vertices_near(vertices(polygon)), threads, progress),
        )
        return PairList(handle=handle)

    def pairs(
        self,
        distance: SupportsFloat = 0.0,
        previous: Optional[PairList] = None,
        *,
        layers: Optional[SupportsIndex] = None,
        ignore: WholeNumbers = (),
        threads: int = 1,
        progress: Optional[Progress] = None,
    ) -> PairList:
        """All pairs that are no further than a distance from each other.

        Pairs of members, and of the container and a member: with a < b, by a, then by b.

        distance: in input units, from 0 on. previous: an earlier list that pairs gave for
        this scene, or for one that it was copied from or to. What has not moved since is then not
        computed again, where distance, layers and ignore are the same. The list is the
        same as without it.

        Exact. Takes O(n log n), and gcv.distance for each pair whose boxes are as near;
        with a previous list O(n), and that for the members that have changed.

        The other arguments and the errors are those of near; InputError also for a list of
        another scene.
        """
        limit, query, handle = (
            number(distance, "distance"),
            query_of(layers, ignore),
            _ffi.PairList(),
        )
        earlier = _handle_of(previous, PairList, _ffi.PairList)
        self._ask(
            lambda options: _ffi.scene_pairs(
                *(self._handle, earlier, limit, query, options, byref(handle))
            ),
            *(self._vertices_of_pairs(limit), threads, progress),
        )
        return PairList(handle=handle)

    def contacts(
        self,
        distance: SupportsFloat = 0.0,
        slope: SupportsFloat = 0.0,
        previous: Optional[ContactList] = None,
        *,
        layers: Optional[SupportsIndex] = None,
        ignore: WholeNumbers = (),
        threads: int = 1,
        progress: Optional[Progress] = None,
    ) -> ContactList:
        """The contacts of all pairs, within a distance: those of gcv.contacts.

        Pairs of members, and of the container and a member, with id_a < id_b. In a contact,
        a is about what has id_a, and the points are where the members are. They are in the
        order of the size of the gap, then id_a, id_b, kind, a, b.

        distance, slope: as in gcv.contacts. previous: an earlier list of contacts of this
        scene, or of one that it was copied from or to. What has not moved since is then not
        computed again. ContactList.previous tells which contacts were in that list. The
        contacts are the same as without it.

        Exact as gcv.contacts. Takes as long as pairs, and gcv.contacts for each pair.

        The other arguments and the errors are those of pairs and of gcv.contacts.
        """
        limits, query = (
            (number(distance, "distance"), number(slope, "slope")),
            query_of(layers, ignore),
        )
        earlier, handle = _handle_of(previous, ContactList, _ffi.ContactList), _ffi.ContactList()
        self._ask(
            lambda options: _ffi.scene_contacts(
                *(self._handle, earlier, *limits, query, options, byref(handle))
            ),
            *(self._vertices_of_pairs(limits[0]), threads, progress),
        )
        return ContactList(handle=handle)

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Draw the container and the members with matplotlib.

        ax is the axes to draw on, by default the current ones; style goes to ax.fill, for
        each member. Returns the axes. Raises ImportError without matplotlib.
        """
        ground, members = self._all_ring_points(1)
        ax = plot(ground, (), ax, {"facecolor": GROUND_COLOUR, "alpha": 1})
        for rings in members:
            plot(rings, (), ax, style)
        return ax

    def _repr_svg_(self) -> str:
        # Half as large, so that no sum is beyond the largest float.
        ground, members = self._all_ring_points(0.5)
        return svg(members, (), ground)

    def _all_ring_points(self, scale: float) -> tuple[list[Points], list[list[Points]]]:
        """The rings of the container and those of each member, where it is."""
        container, polygons, places = self._gate.ask(
            lambda: (
                *(self._container, list(self._polygons.values())),
                points(self._all_positions()),
            )
        )

        def placed(polygon: Polygon, place: tuple[float, float]) -> list[Points]:
            x, y = scale * place[0], scale * place[1]
            return [
                [(scale * px + x, scale * py + y) for px, py in ring]
                for ring in polygon._ring_points()
            ]

        ground = [] if container is None else placed(container, (0, 0))
        return ground, [placed(*member) for member in zip(polygons, places)]

    def _vertices_of_pairs(self, distance: float) -> int:
        """A guess of the vertices of all pairs that are near: within a distance, perhaps all."""
        member = next(iter(self._polygons.values()), None)
        reach = 0.0 if member is None else min(distance_in(member, distance), 1e3)
        near = min(int(2 * NEIGHBOURS * (1 + reach) ** 2), max(len(self), 2 * NEIGHBOURS))
        return self._container_vertices() + near * self._vertices


# Messages of Python call methods by their qualified names, which no base class is to be in.
for _base in Scene.__mro__[1:-1]:
    for _method in vars(_base).values():
        if isinstance(_method, FunctionType):
            _method.__module__, _method.__qualname__ = __name__, f"Scene.{_method.__name__}"


def _handle_of(
    previous: Optional[RecordList[Any]], kind: type[RecordList[Any]], handle: type[_Handle]
) -> Optional[_Handle]:
    """The handle of an earlier list, which should be of that kind."""
    if previous is None:
        return None
    if not isinstance(previous, kind):
        raise unfit("previous", previous, f"a gcv.{kind.__name__}")
    if not isinstance(previous._handle, handle):
        raise unfit("previous", previous, "the list of a scene: it was pickled")
    return previous._handle
