"""Entry point of `python -m bondem`, which runs the command `bondem`."""

from bondem.cli import main

if __name__ == "__main__":
    main()
