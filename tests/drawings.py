"""Reports with some of their figures, for tests of studies whose figures other tests draw."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from bondem.report import page
from bondem.report.findings import Findings


@contextmanager
def only(*names: str) -> Iterator[None]:
    """Draw figures of these names only, within the block."""
    every = page.drawings_of

    def some(findings: Findings) -> dict[str, Callable[[Path], None]]:
        drawings = every(findings)
        return {name: drawings[name] for name in names}

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(page, "drawings_of", some)
        yield
