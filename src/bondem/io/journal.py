"""A file that is changed as a whole or not at all: between two commits nothing that was there is touched.

What is written beyond the committed end goes straight to the file, as nothing refers to it yet. What is written
over committed bytes is gathered in pages. A commit writes these pages to a journal beside the file, with a digest,
and only then to the file itself; a process that is killed meanwhile leaves a journal that the next reader takes into
account and the next writer carries out, or one that is not whole and counts for nothing.

h5py opens it as a file object. Nothing raises while HDF5 writes, which does not survive that: a full disk is found
out at the commit, and the last commit stays as it was.
"""

import hashlib
import io
import os
import struct
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

from bondem._lock import claim
from bondem.errors import RunFileError

_PAGE = 4096
_HEAD = struct.Struct("<8sqq")  # magic, length after the commit, number of pages
_PLACE = struct.Struct("<qq")  # where a page begins and how long it is
_MAGIC = b"BONDEMJ1"
# What may not escape while HDF5 reads or writes: a failing disk, and a file that is closed already.
_LOST = OSError, ValueError


class JournaledFile(io.RawIOBase):
    """The file object.

    Args:
        path: the file; it is made where there is none.
        aside: where it lies until the first commit, which moves it to `path`; None for a file that is there.

    Raises:
        RunFileError: another process writes this file, or it cannot be committed.
    """

    def __init__(self, path: Path, *, aside: Path | None = None) -> None:
        super().__init__()
        self._path, self._aside = path, aside
        place = aside or path
        try:
            self._file = open(place, "r+b" if aside is None else "a+b", buffering=0)  # noqa: SIM115
            if aside is not None:
                self._file.close()
                self._file = open(place, "r+b", buffering=0)  # noqa: SIM115  "a" would write at the end only
        except OSError as error:
            raise failed(path, error) from error
        if not claim(self._file.fileno()):
            self._file.close()
            raise RunFileError(f"'{path}' is being written by another process; give another file, or wait for it")
        if aside is None:
            recover(path, self._file)
        else:
            self._file.truncate(0)
        self._committed = self._end = os.fstat(self._file.fileno()).st_size
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
        """See `io.RawIOBase`: the file as it will be after the next commit."""
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
        """See `io.RawIOBase`; it never fails, `commit` does."""
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
        """See `io.RawIOBase`: committed bytes are cut off with the commit."""
        self._end = self._at if size is None else size
        if self._end > self._committed:
            try:
                self._file.truncate(self._end)
            except OSError as error:
                self._error = self._error or error
        return self._end

    def flush(self) -> None:
        """Nothing: `commit` writes."""

    def commit(self) -> None:
        """Let all that was written since the last commit count, or none of it.

        Raises:
            RunFileError: the disk is full, or another failure to write; the last commit stands.
        """
        try:
            if self._error is not None:
                raise self._error
            os.fsync(self._file.fileno())
            journal = journal_of(self._path)
            if self._pages:
                _write_journal(journal, self._end, self._pages)
            if self._aside is not None:
                self._path.with_name(journal.name).unlink(missing_ok=True)
                os.replace(self._aside, self._path)
                self._aside = None
        except OSError as error:
            self.roll_back()
            raise failed(self._path, error) from error
        try:
            _apply(self._file.fileno(), self._end, self._pages)
        except OSError as error:  # the journal is whole: the next one who opens the file carries it out
            raise failed(self._path, error) from error
        if self._pages:
            journal.unlink(missing_ok=True)
        self._pages, self._committed = {}, self._end

    def roll_back(self) -> None:
        """Forget what was written since the last commit."""
        self._pages, self._end = {}, self._committed
        with suppress(OSError):
            self._file.truncate(self._committed)
        with suppress(OSError):
            journal_of(self._path).unlink(missing_ok=True)

    def close(self) -> None:
        """Close without a commit; a file that never had one goes."""
        if not self.closed and not self._file.closed:
            with suppress(OSError):
                self._file.truncate(self._committed)
            if self._aside is not None:
                self._aside.unlink(missing_ok=True)
            self._file.close()
        super().close()

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
            while data:
                done = os.pwrite(self._file.fileno(), data, at)
                data, at = data[done:], at + done
        except OSError as error:
            self._error = error


class RecoveredFile(io.BytesIO):
    """A file as its last commit has it, in memory, where a journal says that it is not so on the disk."""


def committed(path: Path) -> Path | RecoveredFile:
    """What to read a file from: itself, or where a whole journal lies beside it what this makes of it."""
    found = _read_journal(journal_of(path))
    if found is None:
        return path
    length, pages = found
    data = bytearray(path.read_bytes())
    data.extend(bytes(max(length - len(data), 0)))
    for begin, page in pages:
        data[begin : begin + len(page)] = page
    return RecoveredFile(bytes(data[:length]))


def recover(path: Path, file: Any) -> None:
    """Carry out a journal that was left beside a file, or throw it away where it is not whole."""
    journal = journal_of(path)
    found = _read_journal(journal)
    if found is not None:
        length, pages = found
        _apply(file.fileno(), length, {begin // _PAGE: bytearray(page) for begin, page in pages})
    journal.unlink(missing_ok=True)


def failed(path: Path, error: OSError) -> RunFileError:
    """What to say of a file that could not be written."""
    return RunFileError(
        f"'{path}' could not be written ({error.strerror or error}); make room or choose another place"
    )


def journal_of(path: Path) -> Path:
    """Where the journal of a file lies."""
    return path.with_name(f".{path.name}.journal")


def _pages_of(at: int, count: int) -> Iterator[tuple[int, int, int]]:
    """Number of each page that count bytes from `at` on touch, and which of them."""
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
    """Length after the commit, and pages with where they begin; None where there is no whole journal."""
    try:
        data = journal.read_bytes()
    except OSError:
        return None
    body, told = data[:-32], data[-32:]
    if len(data) < _HEAD.size + 32 or hashlib.blake2b(body, digest_size=32).digest() != told:
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
        view, at = memoryview(page), number * _PAGE
        while view:
            done = os.pwrite(descriptor, view, at)
            view, at = view[done:], at + done
    os.ftruncate(descriptor, length)
    os.fsync(descriptor)
