# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Computes the no-fit polygons of all pairs of parts on a Dask cluster.

Polygons and outer faces can be pickled, so the functions of gcv are tasks as they are: the
parts travel to the workers once, and the no-fit polygons back. The workers need gcv too.
The parts are those of the example nesting, or those in a folder, one WKT file each; the
reference point of each is the lower left corner of its box.
"""

from __future__ import annotations

import argparse
from itertools import product
from math import fsum
from pathlib import Path
from typing import Optional

import nesting
from dask.distributed import Client, as_completed
from tqdm import tqdm

import gcv


def read(folder: Path) -> list[gcv.Polygon]:
    return [gcv.Polygon(file.read_text()) for file in sorted(folder.glob("*.wkt"))]


def connect(scheduler: Optional[str], workers: Optional[int]) -> Client:
    if scheduler:
        return Client(scheduler)
    return Client(n_workers=workers, threads_per_worker=1, processes=True, dashboard_address=None)


def no_fit_polygons(client: Client, parts: list[gcv.Polygon]) -> list[gcv.OuterFace]:
    """The no-fit polygon of every part, fixed, with every part, moving; in this order."""
    on_cluster = client.scatter(parts, broadcast=True)
    fixed, moving = zip(*product(on_cluster, repeat=2))
    references = [part.bounds[:2] for _, part in product(parts, repeat=2)]
    futures = client.map(gcv.no_fit_polygon, fixed, moving, references, batch_size=64)
    for _ in tqdm(as_completed(futures), total=len(futures), unit=" pairs"):
        pass
    faces: list[gcv.OuterFace] = client.gather(futures)
    return faces


def check(parts: list[gcv.Polygon], faces: list[gcv.OuterFace]) -> None:
    """The faces are, to the bit, those that one process computes: their rings and sources."""
    for (fixed, moving), face in zip(product(parts, repeat=2), faces):
        serial = gcv.no_fit_polygon(fixed, moving, moving.bounds[:2])
        if (serial, serial.sources) != (face, face.sources):
            raise SystemExit(f"nfp_dask: {fixed} and {moving} have another no-fit polygon here")
    print("the same to the bit as in one process")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, nargs="?", help="of the parts, as *.wkt")
    parser.add_argument("--scheduler", metavar="ADDRESS", help="default: a cluster on this machine")
    parser.add_argument("--workers", type=int, metavar="N", help="of the cluster on this machine")
    parser.add_argument("--check", action="store_true", help="compare with the serial results")
    options = parser.parse_args()
    folder: Optional[Path] = options.folder
    parts = read(folder) if folder else nesting.parts()
    if not parts:
        parser.error(f"no parts *.wkt in {folder}")

    with connect(options.scheduler, options.workers) as client:
        faces = no_fit_polygons(client, parts)
    if options.check:
        check(parts, faces)
    area = fsum(face.area for face in faces)
    print(f"{len(faces)} no-fit polygons of {len(parts)} parts, {area:.3f} in area together")


if __name__ == "__main__":
    main()
