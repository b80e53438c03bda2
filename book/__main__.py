"""`python -m book`: see the package."""

import argparse
import sys
from pathlib import Path

from book.counting import counted
from book.errors import BookError
from book.markdown import counts
from book.measure import BUILD, measure
from book.measurements import MEASUREMENTS
from book.pages import chapters, differences, write
from book.results import RESULTS, ROOT


def main(arguments: list[str] | None = None) -> int:
    """Exit status 0 when all went well, 1 when a page differs or a miss is not printed, 2 on an error."""
    parser = argparse.ArgumentParser(prog="python -m book", description="Write and check the validation pages.")
    action = parser.add_mutually_exclusive_group()
    action.add_argument("--check", action="store_true",
        help="list pages that differ from the results, and missing figures")
    action.add_argument("--rows", action="store_true", help="count rows by verdict, before and after the rule")
    action.add_argument("--list", action="store_true", help="list the measurements and their commands")
    action.add_argument("--measure", nargs="*", metavar="NAME",
        help="repeat measurements, or those that a page quotes; all without names")
    parser.add_argument("--no-run", action="store_true",
        help="with --measure: use the files that the folder holds already")
    parser.add_argument("--build", type=Path, default=BUILD, help="with --measure: folder for the output of commands")
    options = parser.parse_args(arguments)
    try:
        if options.list:
            for one in MEASUREMENTS:
                print(f"{one.name:20} {one.command}{f'   ({one.takes})' if one.takes else ''}")
            for name in sorted({path.stem for path in RESULTS.glob("*.json")} - {one.name for one in MEASUREMENTS}):
                print(f"{name:20} benchmarks/results/{name}.json is in no chapter")
            return 0
        if options.check:
            found = list(differences())
            print("\n".join(found) or "the validation pages agree with the results")
            return bool(found)
        if options.rows:
            lines, lost = counted(chapters())
            print("\n".join([*lines, *(lost or ["every miss is printed on its page and on the first page"])]))
            return bool(lost)
        if options.measure is not None:
            measure(options.measure, build=options.build, run=not options.no_run)
        for path in write():
            print(f"wrote {path.relative_to(ROOT)}")
        rows = [row for chapter in chapters() for row in chapter.rows]
        print(counts(rows))
    except BookError as error:
        print(f"book: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
