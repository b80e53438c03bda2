"""What several verifications share."""

from collections.abc import Iterator

import pytest

from tests.bits import threads


@pytest.fixture
def one_thread() -> Iterator[None]:
    """Small models: threads would only wait for each other."""
    with threads(1):
        yield
