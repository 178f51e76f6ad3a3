# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Where what the program prints goes."""

from __future__ import annotations

import errno
import io
import os
import select
import stat
import sys
from contextlib import suppress
from typing import Optional

STANDARD_OUTPUT = "-"
_FOLDERS_OF_STREAMS = ("/dev/", "/proc/")
_MOST_LINKS = 40
_NOT_ALLOWED = (errno.EACCES, errno.EPERM, errno.EROFS)


def write(text: str, file: str) -> None:
    """Write a text to a file, or to standard output.

    A file that was there keeps what it has until all of the text is written. Raises OSError
    that has the name of either.
    """
    name = "standard output" if file == STANDARD_OUTPUT else file
    try:
        if file == STANDARD_OUTPUT:
            _print(text)
        elif not _replace(text, file):
            with open(file, "w") as opened:
                opened.write(text)
    except OSError as error:
        error.filename = name
        raise


def _print(text: str) -> None:
    stdout = sys.stdout
    if stdout is None:
        raise OSError(errno.EBADF, os.strerror(errno.EBADF))
    binary = getattr(stdout, "buffer", None)
    if not isinstance(binary, (io.BufferedWriter, io.FileIO)):
        print(text, end="", flush=True)
        return
    # By hand, for where Python does not buffer, print loses what does not go out at once; and
    # where it does, Python tries once more when it ends.
    stdout.flush()
    data = text.replace("\n", os.linesep).encode(stdout.encoding, stdout.errors or "strict")
    left = memoryview(data)
    while left:
        try:
            left = left[os.write(binary.fileno(), left) :]
        except BlockingIOError:
            select.select([], [binary], [])


def _replace(text: str, file: str) -> bool:
    """Put a new file with the text in the place of a file, or where none is.

    False where that cannot be done, or would change more than what the file says: where it is
    no regular file, has several names, or belongs to somebody else.
    """
    target = _target(file)
    if target is None:
        return False
    old = os.stat(target) if os.path.exists(target) else None
    if old and not (stat.S_ISREG(old.st_mode) and old.st_nlink == 1 and os.access(target, os.W_OK)):
        return False
    # Beside the file: a file cannot be renamed to a place on another disc.
    new = os.path.join(os.path.dirname(target), f".gcv-{os.urandom(8).hex()}")
    try:
        descriptor = os.open(new, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o666)
    except OSError as error:
        if error.errno in _NOT_ALLOWED:
            return False
        raise
    try:
        with open(descriptor, "w") as opened:
            made = os.fstat(descriptor)
            if old:
                if (old.st_uid, old.st_gid) != (made.st_uid, made.st_gid):
                    return False
                os.chmod(new, stat.S_IMODE(old.st_mode))
            opened.write(text)
        try:
            os.replace(new, target)
        except OSError:  # as where the file is mounted
            return False
    finally:
        with suppress(FileNotFoundError):
            os.unlink(new)
    return True


def _target(file: str) -> Optional[str]:
    """The path of a file at the end of symbolic links.

    None for a name that no file can have, and for what a process has open, such as
    /dev/stdout.
    """
    for _ in range(_MOST_LINKS):
        folder, name = os.path.split(file)
        file = os.path.join(os.path.realpath(folder), name)
        if not name or file.startswith(_FOLDERS_OF_STREAMS):
            return None
        if not os.path.islink(file):
            return file
        file = os.path.join(os.path.dirname(file), os.readlink(file))
    return None
