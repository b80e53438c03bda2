"""The chart of the first page: of every comparison the share of its tolerance that the number uses.

It is written as SVG by hand, so that the same results give the same file with any version of a library, and `--check`
can compare it.
"""

import math
from collections.abc import Sequence
from html import escape

from book.chapter import Chapter
from book.questions import QUESTIONS, by_question
from book.row import Row, Verdict

#: Shares at the ends of the axis; what lies beyond stands at the end.
_LEAST, _LARGEST = 1e-3, 1e2
#: Width, left end of the axis and its length, height of a chapter, of a question, of head and foot [px].
_WIDTH, _LEFT, _LENGTH, _LINE, _HEAD, _TOP, _FOOT = 640, 206, 418, 30, 40, 76, 64
_STYLE = """text{font:17px sans-serif;fill:#222}.s{font-size:15px;fill:#555}
.q{font-weight:600;stroke:#fff;stroke-width:6px;paint-order:stroke}
.g{stroke:#ccc;fill:none}.l{stroke:#222;stroke-width:2}.met{fill:#1f6fb2;fill-opacity:.45}
.missed{fill:none;stroke:#c2410c;stroke-width:2.5}.explained{fill:none;stroke:#c2410c;stroke-width:1.2}"""


def chart(chapters: Sequence[Chapter]) -> str:
    """`docs/figures/tolerances.svg`."""
    parts, y = [_legend()], float(_TOP)
    for question, some in by_question(chapters).items():
        parts.append(f'<text class="q" x="6" y="{y + 27:g}">{escape(question)}</text>')
        y += _HEAD
        for chapter in some:
            parts += _line(chapter, QUESTIONS[question][chapter.name], y)
            y += _LINE
    height = y + _FOOT
    head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDTH} {height:g}" font-size="17">'
    return "\n".join([head, f"<style>{_STYLE}</style>", f'<rect width="{_WIDTH}" height="{height:g}" fill="#fff"/>',
                      *_axis(y), *parts, "</svg>"]) + "\n"  # fmt: skip


def _x(share: float) -> float:
    place = math.log10(min(max(share, _LEAST), _LARGEST) / _LEAST) / math.log10(_LARGEST / _LEAST)
    return round(_LEFT + _LENGTH * place, 1)


def _axis(bottom: float) -> list[str]:
    parts = []
    for power in range(round(math.log10(_LEAST)), round(math.log10(_LARGEST)) + 1):
        x, kind = _x(10.0**power), "l" if power == 0 else "g"
        parts.append(f'<path class="{kind}" d="M{x:g} {_TOP + 6}V{bottom + 6:g}"/>')
        parts.append(f'<text class="s" x="{x:g}" y="{bottom + 26:g}" text-anchor="middle">{10.0**power:g}</text>')
    middle = _LEFT + _LENGTH / 2
    words = "error over tolerance: left of 1 is met"
    return [*parts, f'<text class="s" x="{middle:g}" y="{bottom + 50:g}" text-anchor="middle">{words}</text>']


def _legend() -> str:
    parts = ['<text class="q" x="6" y="24">Every comparison, by what it helps to decide</text>']
    for x, verdict, words in (
        (14, Verdict.MET, "met"), (84, Verdict.MISSED, "missed"), (184, Verdict.EXPLAINED, "missed, cause stated"),
    ):  # fmt: skip
        parts += [_mark(float(x), 50.0, verdict), f'<text x="{x + 14}" y="56">{words}</text>']
    return "\n".join(parts)


def _line(chapter: Chapter, label: str, y: float) -> list[str]:
    """The name of a chapter and a mark for each of its comparisons, spread in height so that marks stay apart."""
    parts = [f'<text x="18" y="{y + 20:g}">{escape(label)}</text>',
             f'<path class="g" d="M{_LEFT} {y + 15:g}H{_LEFT + _LENGTH}"/>']  # fmt: skip
    # misses last, so that they lie on top
    for k, row in enumerate(sorted(chapter.rows, key=lambda row: row.verdict.is_miss)):
        parts.append(_mark(_x(_share(row)), y + 15.0 + 4.0 * (k % 5 - 2), row.verdict))
    return parts


def _share(row: Row) -> float:
    """The share of the tolerance; of what is so or not so, the end of the axis."""
    if row.used is None:
        return _LARGEST if row.verdict.is_miss else _LEAST
    return row.used


def _mark(x: float, y: float, verdict: Verdict) -> str:
    if verdict.is_miss:
        kind = "explained" if verdict is Verdict.EXPLAINED else "missed"
        return f'<path class="{kind}" d="M{x:g} {y - 5:g}l5 5-5 5-5-5z"/>'
    return f'<circle class="met" cx="{x:g}" cy="{y:g}" r="4"/>'
