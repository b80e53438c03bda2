"""Transactional file: a commit changes the file as a whole or not at all.

Data beyond the committed end are written directly to the file, as nothing refers to them yet. Changes of committed
bytes are collected in pages. A commit writes these pages to a journal beside the file, with a digest, and then to the
file itself. A process that is killed meanwhile leaves a journal. A complete journal is used by the next reader and
applied by the next writer, and an incomplete journal is ignored.

h5py opens the object as a file. No error is raised while HDF5 writes, as HDF5 does not survive errors: a full disk is
detected at the commit, and the last commit remains valid.

If another process removes the file meanwhile, the next commit writes it again, as the system keeps the contents of an
open file. If another process truncates or replaces it, the next commit raises an error.
"""

import hashlib
import io
import os
import shutil
import struct
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

from bondem._lock import claim
from bondem.errors import RunFileError
from bondem.io.atomic import failed, target_of

_PAGE = 4096
_HEAD = struct.Struct("<8sqq")  # magic, length after the commit, number of pages
_PLACE = struct.Struct("<qq")  # offset and length of a page
_MAGIC = b"BONDEMJ1"
# Errors that must not reach HDF5 while it reads or writes: a failing disk, or a closed file.
_LOST = OSError, ValueError


class JournaledFile(io.RawIOBase):
    """File object with commits.

    Args:
        path: the file; behind a symbolic link, the file that it names.
        new: True for a file that is written beside `path` until the first commit, which moves it there; False for an
            existing file.

    Raises:
        RunFileError: another process writes this file, or it cannot be opened.
    """

    def __init__(self, path: Path, *, new: bool = False) -> None:
        super().__init__()
        self._path = target_of(path)
        self._aside = self._path.with_name(f".{self._path.name}.part") if new else None
        self._file = self._claimed()
        if not new:
            recover(self._path, self._file)
        self._committed = self._end = self._size = os.fstat(self._file.fileno()).st_size
        self._pages: dict[int, bytearray] = {}
        self._at = 0
        self._error: OSError | None = None

    def readable(self) -> bool:
        return True

    def writable(self) -> bool:
        return True

    def seekable(self) -> bool:
        return True

    def tell(self) -> int:
        return self._at

    def seek(self, offset: int, whence: int = io.SEEK_SET) -> int:
        self._at = offset + {io.SEEK_SET: 0, io.SEEK_CUR: self._at, io.SEEK_END: self._end}[whence]
        return self._at

    def readinto(self, buffer: Any) -> int:
        """Read as in `io.RawIOBase`, from the file as it will be after the next commit."""
        view = memoryview(buffer).cast("B")
        count = max(min(len(view), self._end - self._at), 0)
        with suppress(*_LOST):
            got = os.pread(self._file.fileno(), count, self._at)
            view[: len(got)] = got
            view[len(got) : count] = bytes(count - len(got))
        for number, first, last in _pages_of(self._at, count):
            page = self._pages.get(number)
            if page is not None:
                begin = number * _PAGE
                last = min(last, begin + len(page))
                if first < last:
                    view[first - self._at : last - self._at] = page[first - begin : last - begin]
        self._at += count
        return count

    def write(self, data: Any) -> int:
        """Write as in `io.RawIOBase`; errors are raised by `commit` only."""
        view = memoryview(data).cast("B")
        below = max(min(len(view), self._committed - self._at), 0)
        for number, first, last in _pages_of(self._at, below):
            page = self._page(number)
            page[first - number * _PAGE : last - number * _PAGE] = view[first - self._at : last - self._at]
        if below < len(view):
            self._put(view[below:], self._at + below)
        self._at += len(view)
        self._end = max(self._end, self._at)
        return len(view)

    def truncate(self, size: int | None = None) -> int:
        """Truncate as in `io.RawIOBase`; committed bytes are removed with the next commit."""
        self._end = self._at if size is None else size
        if self._end > self._committed:
            try:
                self._require_uncut()
                self._file.truncate(self._end)
                self._size = self._end
            except OSError as error:
                self._error = self._error or error
        return self._end

    def flush(self) -> None:
        """Do nothing; `commit` writes."""

    def commit(self) -> None:
        """Make all changes since the last commit valid, or none of them.

        Raises:
            RunFileError: the file cannot be written, such as on a full disk, or another process has truncated or
                replaced it. The last commit remains valid, unless the journal is complete: readers then apply it.
        """
        journal, descriptor = journal_of(self._path), self._file.fileno()
        try:
            self._require_own()
            if self._error is not None:
                raise self._error
            if self._aside is not None:
                descriptor = self._file.fileno()
                _apply(descriptor, self._end, self._pages)
                journal.unlink(missing_ok=True)
                os.replace(self._aside, self._path)
                self._aside, self._pages = None, {}
            os.fsync(descriptor)
            if self._pages:
                _write_journal(journal, self._end, self._pages)
        except OSError as error:
            self.roll_back()
            raise failed(self._path, error) from error
        try:
            _apply(descriptor, self._end, self._pages)
        except OSError as error:  # the journal is complete: the next process that opens the file applies it
            raise failed(self._path, error) from error
        if self._pages:
            journal.unlink(missing_ok=True)
        self._pages, self._committed, self._size = {}, self._end, self._end

    def roll_back(self) -> None:
        """Discard all changes since the last commit."""
        self._pages, self._end = {}, self._committed
        self._shorten()
        with suppress(OSError):
            journal_of(self._path).unlink(missing_ok=True)

    def close(self) -> None:
        """Close the file without a commit; a file that was never committed is removed."""
        if not self.closed and not self._file.closed:
            self._shorten()
            if self._aside is not None:
                self._aside.unlink(missing_ok=True)
            self._file.close()
        super().close()

    def _shorten(self) -> None:
        """Remove bytes beyond the last commit; a file that another process has truncated stays as it is."""
        with suppress(OSError):
            if os.fstat(self._file.fileno()).st_size > self._committed:
                self._file.truncate(self._committed)
            self._size = self._committed

    def _claimed(self) -> io.FileIO:
        """Open and lock the file for this process, and empty a new one."""
        place = self._path if self._aside is None else self._aside
        try:
            # unlike "w+b", which would empty the file of another process before it is claimed
            create = 0 if self._aside is None else os.O_CREAT
            file = io.FileIO(os.open(place, os.O_RDWR | create | getattr(os, "O_BINARY", 0), 0o666), "r+")
        except OSError as error:
            raise failed(self._path, error) from error
        if not claim(file.fileno()):
            file.close()
            raise RunFileError(
                f"'{self._path}' is being written by another process; give another file, or try again later"
            )
        if self._aside is not None:
            file.truncate(0)
        return file

    def _require_own(self) -> None:
        """Check that the path still names this file; a removed file is copied to a new one.

        Raises:
            OSError: another process has truncated or replaced the file.
        """
        if self._aside is not None:
            return
        own = self._require_uncut()
        try:
            found = os.stat(self._path)
        except FileNotFoundError:
            removed, self._aside = self._file, self._path.with_name(f".{self._path.name}.part")
            self._file = self._claimed()
            removed.seek(0)
            shutil.copyfileobj(removed, self._file)
            removed.close()
            return
        if (found.st_dev, found.st_ino) != (own.st_dev, own.st_ino):
            raise OSError("it was replaced by another file during the run")

    def _require_uncut(self) -> os.stat_result:
        """Return the status of the file, which must be at least as long as this process has written it.

        Raises:
            OSError: another process has truncated the file.
        """
        found = os.fstat(self._file.fileno())
        if found.st_size < self._size:
            raise OSError("it was cut during the run")
        return found

    def _page(self, number: int) -> bytearray:
        page = self._pages.get(number)
        if page is None:
            begin = number * _PAGE
            page = bytearray(min(_PAGE, self._committed - begin))
            with suppress(*_LOST):
                got = os.pread(self._file.fileno(), len(page), begin)
                page[: len(got)] = got
            self._pages[number] = page
        return page

    def _put(self, data: memoryview, at: int) -> None:
        if self._error is not None or self._file.closed:
            return
        try:
            self._require_uncut()
            _write_at(self._file.fileno(), data, at)
            self._size = max(self._size, at + len(data))
        except OSError as error:
            self._error = error


def committed(path: Path) -> Path | io.BytesIO:
    """Return the source of the committed contents: the file, or in memory the result of its complete journal."""
    found = _read_journal(journal_of(path))
    if found is None:
        return path
    length, pages = found
    data = bytearray(path.read_bytes())
    data.extend(bytes(max(length - len(data), 0)))
    for begin, page in pages:
        data[begin : begin + len(page)] = page
    return io.BytesIO(bytes(data[:length]))


def recover(path: Path, file: Any) -> None:
    """Apply the complete journal of a file, or remove an incomplete one."""
    journal = journal_of(path)
    found = _read_journal(journal)
    if found is not None:
        length, pages = found
        _apply(file.fileno(), length, {begin // _PAGE: bytearray(page) for begin, page in pages})
    journal.unlink(missing_ok=True)


def journal_of(path: Path) -> Path:
    """Return the path of the journal of a file, or of the file behind a link."""
    path = target_of(path)
    return path.with_name(f".{path.name}.journal")


def _pages_of(at: int, count: int) -> Iterator[tuple[int, int, int]]:
    """Split `count` bytes from offset `at` by pages; yield the number of each page, begin and end of its bytes."""
    for number in range(at // _PAGE, -(-(at + count) // _PAGE) if count else at // _PAGE):
        yield number, max(at, number * _PAGE), min(at + count, (number + 1) * _PAGE)


def _write_journal(journal: Path, length: int, pages: dict[int, bytearray]) -> None:
    digest = hashlib.blake2b(digest_size=32)
    with open(journal, "wb") as file:
        def put(data: bytes) -> None:
            digest.update(data)
            file.write(data)

        put(_HEAD.pack(_MAGIC, length, len(pages)))
        for number in sorted(pages):
            put(_PLACE.pack(number * _PAGE, len(pages[number])))
            put(bytes(pages[number]))
        file.write(digest.digest())
        file.flush()
        os.fsync(file.fileno())


def _read_journal(journal: Path) -> tuple[int, list[tuple[int, bytes]]] | None:
    """Read the length of the file after a commit, and pages with offsets; None without a complete journal."""
    try:
        data = journal.read_bytes()
    except OSError:
        return None
    body, digest = data[:-32], data[-32:]
    if len(data) < _HEAD.size + 32 or hashlib.blake2b(body, digest_size=32).digest() != digest:
        return None
    magic, length, count = _HEAD.unpack_from(body)
    if magic != _MAGIC:
        return None
    pages, at = [], _HEAD.size
    for _ in range(count):
        begin, size = _PLACE.unpack_from(body, at)
        at += _PLACE.size
        pages.append((begin, body[at : at + size]))
        at += size
    return length, pages


def _apply(descriptor: int, length: int, pages: dict[int, bytearray]) -> None:
    for number, page in sorted(pages.items()):
        _write_at(descriptor, memoryview(page), number * _PAGE)
    os.ftruncate(descriptor, length)
    os.fsync(descriptor)


def _write_at(descriptor: int, data: memoryview, at: int) -> None:
    """Write all bytes at an offset; the system may take only a part at a time."""
    while data:
        done = os.pwrite(descriptor, data, at)
        data, at = data[done:], at + done
