"""Errors of the validation pages."""


class BookError(Exception):
    """A row without its number, a figure that is not there, a page that differs from the results."""
