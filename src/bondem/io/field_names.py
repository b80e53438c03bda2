"""Names of fields that users add to exports."""

from collections.abc import Collection, Iterable

from bondem._checks import shown
from bondem.errors import InputError


def check_names(owner: str, names: Iterable[object], *, own: Collection[str], forbidden: str = "") -> None:
    """Reject names of fields that a file cannot represent, or that would replace fields of bondem.

    Args:
        owner: name of the calling function, for messages.
        names: names of the fields of users.
        own: names that bondem uses in the file.
        forbidden: characters that the format cannot represent in names.

    Raises:
        InputError: a name that is no text, is empty, contains characters that cannot be written, or is in use.
    """
    for name in names:
        if not isinstance(name, str) or not name.strip() or not name.isprintable() or name != name.strip():
            raise InputError(f"{owner}: field {shown(name)}; give a name of printable characters on one line")
        if name in own:
            raise InputError(f"{owner}: field '{name}' is in the file already; give it another name")
        found = next((mark for mark in forbidden if mark in name), None)
        if found is not None:
            kind = "a blank" if found == " " else f"'{found}'"
            raise InputError(f"{owner}: field '{name}' has {kind}, which this format cannot hold; use '_' instead")
