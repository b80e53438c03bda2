"""Numbers that pages of prose quote, a file for each subject."""

from collections.abc import Sequence

from book.quoting import Quoted


def quoted() -> Sequence[Quoted]:
    """All quoted numbers."""
    return []
