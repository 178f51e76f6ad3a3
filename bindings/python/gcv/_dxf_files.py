# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The polygons of DXF drawings, which ezdxf reads."""

from __future__ import annotations

import io
import math
from collections import Counter
from typing import Any, Optional

from ._coordinates import Points
from ._named import NamedPolygon, Reading, curve, invalid, package, too_fine
from ._nested_rings import Ring, polygons_of_rings

_POLYLINES = {"LWPOLYLINE", "POLYLINE"}
_CLOSED_KINDS = {*_POLYLINES, "CIRCLE", "ELLIPSE", "SPLINE"}
_LEAST_LINES = 4
"""A curve has at least as many lines in its place."""
_FINEST = 1e-9
"""How near they may be at most, as a part of the size of the curve."""


def polygons_of_dxf(data: bytes, reading: Reading) -> list[NamedPolygon]:
    """The polygons of the closed polylines in the model space, blocks resolved.

    A closed polyline inside another one of its layer is a hole in it, and one inside the
    hole a polygon of its own.
    """
    recover = package("ezdxf.recover", "dxf", reading.file)
    disassemble = package("ezdxf.disassemble", "dxf", reading.file)
    path = package("ezdxf.path", "dxf", reading.file)
    layers: dict[str, list[Ring]] = {}
    left_out = Counter[str]()
    try:
        document, _ = recover.read(io.BytesIO(data))
        entities = list(disassemble.recursive_decompose(document.modelspace()))
    except Exception as error:  # whatever a damaged drawing leads to
        raise invalid(reading.file, f"DXF: {error}") from None
    for entity in entities:
        name = f"{reading.file}: {_name(entity)}"
        points = _outline(path.make_path, entity, name, reading)
        if points is None:
            left_out[entity.dxftype()] += 1
        else:
            layers.setdefault(entity.dxf.layer, []).append(Ring(name, points))
    reading.leave_out(left_out)
    return [polygon for rings in layers.values() for polygon in polygons_of_rings(rings)]


def _name(entity: Any) -> str:
    """What a message calls an entity; those of blocks have no handle."""
    handle = f" {entity.dxf.handle}" if entity.dxf.handle else ""
    return f"{entity.dxftype()}{handle} of layer '{entity.dxf.layer}'"


def _outline(make_path: Any, entity: Any, name: str, reading: Reading) -> Optional[Points]:
    """The vertices of an entity that is closed; None for others."""
    kind = entity.dxftype()
    if kind not in _CLOSED_KINDS or _is_mesh(entity):
        return None
    path = make_path(entity)
    if not path.is_closed:
        return None
    controls = _points(path.control_vertices())
    if not path.has_curves:
        return controls
    if reading.flatten is None:
        raise curve(name)
    size = max(math.dist(point, controls[0]) for point in controls)
    if reading.flatten < _FINEST * size:
        raise too_fine(name)
    if kind in _POLYLINES:
        points = _flattened_polyline(controls[0], entity, reading.flatten)
    else:
        points = _lines(entity, reading.flatten)
    # The last point is computed, and only near the first one.
    return points[:-1]


def _is_mesh(entity: Any) -> bool:
    return entity.dxftype() == "POLYLINE" and not (entity.is_2d_polyline or entity.is_3d_polyline)


def _flattened_polyline(start: tuple[float, float], polyline: Any, distance: float) -> Points:
    points = [start]
    for piece in polyline.virtual_entities():
        lines = _lines(piece, distance)
        # Arcs are counter-clockwise, whichever way the polyline goes.
        if math.dist(lines[-1], points[-1]) < math.dist(lines[0], points[-1]):
            lines.reverse()
        points += lines[1:]
    return points


def _lines(entity: Any, distance: float) -> Points:
    kind = entity.dxftype()
    if kind == "LINE":
        vertices = [entity.dxf.start, entity.dxf.end]
    elif kind in ("ELLIPSE", "SPLINE"):
        vertices = list(entity.flattening(distance, _LEAST_LINES))
    else:
        vertices = list(entity.flattening(min(distance, entity.dxf.radius / 2)))
    return _points(vertices)


def _points(vertices: Any) -> Points:
    return [(vertex.x, vertex.y) for vertex in vertices]
