"""`python -m bondem` is the command `bondem`."""

from bondem.cli import main

if __name__ == "__main__":
    main()
