"""What can be wrong with the book."""


class BookError(Exception):
    """A row without its number, a figure that is not there, a page that is not what the results render to."""
