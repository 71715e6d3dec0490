"""The plot of docs/validation.md as SVG: for each test the bracket and the component method, as parts of the largest measured moment."""

WIDTH, ROW, TOP, LEFT, RIGHT = 860, 26, 62, 110, 30
MOST = 1.6
INK, SOFT, BAR, OVER, METHOD = "#222222", "#bbbbbb", "#3a78b5", "#c23b22", "#b07d00"


def x_of(value: float) -> float:
    """Horizontal place of a ratio; what is beyond the axis stands at its end."""
    return LEFT + min(value, MOST) / MOST * (WIDTH - LEFT - RIGHT)


def text(x: float, y: float, words: str, anchor: str = "start", size: int = 12) -> str:
    """A text."""
    return f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}" fill="{INK}">{words}</text>'


def line(x1: float, y1: float, x2: float, y2: float, colour: str, width: float = 1) -> str:
    """A line."""
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{colour}" stroke-width="{width:g}"/>'


def diamond(x: float, y: float, colour: str) -> str:
    """The mark of the component method."""
    return f'<path d="M {x:.1f} {y - 5:.1f} l 5 5 l -5 5 l -5 -5 z" fill="{colour}"/>'


def legend() -> list[str]:
    """What the marks mean."""
    y = 24
    parts = [f'<rect x="{LEFT}" y="{y - 9}" width="30" height="8" fill="{BAR}"/>', text(LEFT + 36, y, "bracket M_low to M_up")]
    parts += [line(LEFT + 196, y - 13, LEFT + 196, y + 3, INK, 3), text(LEFT + 204, y, "measured M_int")]
    parts += [line(LEFT + 322, y - 13, LEFT + 322, y + 3, OVER, 1.5), text(LEFT + 330, y, "measured M_max = 1")]
    parts += [f'<rect x="{LEFT + 610}" y="{y - 9}" width="20" height="8" fill="{OVER}"/>', text(LEFT + 634, y, "above M_max")]
    parts += [diamond(LEFT + 482, y - 5, METHOD), text(LEFT + 492, y, "by code")]
    return parts


def row(y: float, name: str, m: dict[str, float | None]) -> list[str]:
    """One test."""
    parts = [text(LEFT - 10, y + 4, name, "end")]
    most = m["max"]
    if m["low"] is not None:
        low, up = x_of(m["low"] / most), x_of((m["up"] or MOST * most) / most)
        colour = OVER if m["low"] > most else BAR
        parts.append(f'<rect x="{low:.1f}" y="{y - 6:.1f}" width="{max(up - low, 1):.1f}" height="12" fill="{colour}" fill-opacity="0.55"/>')
        parts.append(line(low, y - 8, low, y + 8, colour, 2.5))
        if m["up"] is not None:
            parts.append(line(up, y - 8, up, y + 8, colour, 1))
    if m["int"] is not None:
        parts.append(line(x_of(m["int"] / most), y - 10, x_of(m["int"] / most), y + 10, INK, 3))
    if m["method"] is not None:
        parts.append(diamond(x_of(m["method"] / most), y, METHOD))
    return parts


def draw(rows: list[tuple[str, dict[str, float | None]]]) -> str:
    """The whole picture."""
    height = TOP + ROW * len(rows) + 44
    foot = TOP + ROW * len(rows)
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height}" viewBox="0 0 {WIDTH} {height}" font-family="sans-serif">',
        f'<rect width="{WIDTH}" height="{height}" fill="white"/>',
        *legend(),
    ]
    for tick in range(int(MOST * 5) + 1):
        value = tick / 5
        strong = abs(value - 1) < 1e-9
        parts.append(line(x_of(value), TOP - 12, x_of(value), foot, OVER if strong else SOFT, 1.5 if strong else 0.7))
        parts.append(text(x_of(value), foot + 16, f"{value:.1f}", "middle", 11))
    for n, (name, m) in enumerate(rows):
        parts += row(TOP + ROW * n + ROW / 2 - 6, name, m)
    parts.append(text((LEFT + WIDTH - RIGHT) / 2, foot + 34, "moment at the column face / largest measured moment", "middle"))
    return "\n".join([*parts, "</svg>", ""])
