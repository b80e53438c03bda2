"""André et al. (2012), Tables 1 to 4, by the paper's own protocol."""

from dataclasses import replace

from book.forms import GPA, RATIO, SIGNED, Form
from book.results import study
from book.row import Row, Rows
from book.tolerances import AtMost, Near
from validation.rows.protocol import PRINTED
from validation.studies.protocol import METHODS, TESTS

#: Four packings of each kind are its default; a packing by shear compaction takes half an hour.
PROTOCOL = replace(
    study("protocol", {"protocol_errors": "protocol_errors"}),
    command="python -m validation protocol --out BUILD/protocol", takes="100 min",
)  # fmt: skip
MEASUREMENTS = (PROTOCOL,)

# Fused silica, Table 1.
E, NU = 72.5e9, 0.17
POISSON = Form(style=".4f")
MEASURES = {"paper": "eqs (12)–(15)", "affine": "affine fit of the middle half"}


def bonds() -> Rows:
    for method, words in METHODS.items():
        for measure, by in MEASURES.items():
            where = f"{words.split(',')[0]}, {by}"
            yield Row(f"r̃ for ν = 0.17: {where}", PROTOCOL.summary(method, f"r_mu_ratio_{measure}"),
                Near(relative=0.02), RATIO, source="Table 2", paper=PRINTED.radius_ratio, printed="0.71")  # fmt: skip
            yield Row(f"E_μ for E = 72.5 GPa: {where}", PROTOCOL.summary(method, f"E_mu_{measure}"),
                Near(relative=0.02), GPA, source="Table 2", paper=PRINTED.E, printed="265 GPa")  # fmt: skip
            if measure == "paper":
                yield Row(f"E with the printed bonds: {where}", PROTOCOL.summary(method, "printed_E_paper"),
                    Near(relative=0.07), GPA, source="Tables 1, 2", paper=E)  # fmt: skip
                yield Row(f"ν with the printed bonds: {where}", PROTOCOL.summary(method, "printed_nu_paper"),
                    Near(relative=0.05), POISSON, source="Tables 1, 2", paper=NU, printed="0.17")  # fmt: skip


def tests(method: str) -> Rows:
    """Rows of Tables 3 and 4 by a method of packing."""
    for name, (said, printed) in TESTS.items():
        table, _, case = said.partition(", ")
        yield Row(f"{case}: {METHODS[method].split(',')[0]}", PROTOCOL.summary(method, "errors", name), AtMost(),
            SIGNED, source=table, paper=printed)  # fmt: skip
