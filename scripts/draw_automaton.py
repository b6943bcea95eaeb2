#!/usr/bin/python3
"""Draws the referee's automaton from its table (the paper's Figure 6), and where the ball goes for a free kick.

    scripts/draw_automaton.py            writes autoref/automaton/automaton.svg and positions.svg
    scripts/draw_automaton.py --check    changes nothing; fails when one of them is not what the program says

Both come from the program itself: `ssl-autoref automaton` prints the table, `ssl-autoref positions` the map. Needs a
build (build/release/bin/ssl-autoref; --program names another).
"""
import argparse
import html
import json
import math
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDER = ROOT / "autoref" / "automaton"
FONT = 'font-family="sans-serif"'


def die(sentence):
    print(f"draw_automaton.py: {sentence}", file=sys.stderr)
    sys.exit(2)


# --- The automaton ---

BOX = (140, 44)
PLACES = {"INIT": (90, 150), "BREAK": (360, 70), "GAME_OFF": (360, 290), "GAME_ON": (960, 290), "SETUP": (660, 520)}
# Where the rows of an edge are written: offset from the middle of the edge, and the anchor of the text.
LABELS = {("INIT", "GAME_OFF"): (-14, 20, "end"), ("GAME_OFF", "BREAK"): (12, -40, "start"),
          ("BREAK", "GAME_OFF"): (-12, -40, "end"), ("GAME_ON", "GAME_OFF"): (0, -58, "middle"),
          ("GAME_OFF", "GAME_ON"): (0, 20, "middle"), ("GAME_OFF", "SETUP"): (-14, 30, "end"),
          ("SETUP", "GAME_OFF"): (16, -26, "start"), ("SETUP", "GAME_ON"): (16, 16, "start"),
          ("GAME_ON", "GAME_ON"): (0, 0, "start"), ("GAME_OFF", "GAME_OFF"): (0, 0, "end")}
NAMES_PER_LINE = 5
LINE = 15


def on_border(center, toward, shift):
    """Where the line from a box's centre to another's, both shifted, leaves the box."""
    scale = min((math.copysign(size / 2, there - here) - aside) / (there - here)
                for size, here, there, aside in zip(BOX, center, toward, shift) if there != here)
    return tuple(here + aside + (there - here) * scale for here, there, aside in zip(center, toward, shift))


def text_lines(x, y, anchor, lines, size=12):
    return [f'<text x="{x:.0f}" y="{y + i * LINE:.0f}" font-size="{size}" text-anchor="{anchor}" {FONT}>{html.escape(line)}</text>'
            for i, line in enumerate(lines)]


def edge(start, end, rows):
    names = [row["name"] for row in rows]
    lines = [", ".join(names[i:i + NAMES_PER_LINE]) for i in range(0, len(names), NAMES_PER_LINE)]
    dx, dy, anchor = LABELS.get((start, end), (0, -8, "middle"))
    if start == end:
        side = 1 if anchor == "start" else -1
        x, y = PLACES[start][0] + side * BOX[0] / 2, PLACES[start][1]
        path = f"M {x:.0f} {y - 12:.0f} C {x + side * 60:.0f} {y - 40:.0f} {x + side * 60:.0f} {y + 40:.0f} {x:.0f} {y + 12:.0f}"
        label = (x + side * 52, y + 4)
    else:
        a, b = PLACES[start], PLACES[end]
        length = math.hypot(b[0] - a[0], b[1] - a[1])
        shift = (-(b[1] - a[1]) / length * 9, (b[0] - a[0]) / length * 9)  # so that both directions are seen
        a, b = on_border(a, b, shift), on_border(b, a, shift)
        path = f"M {a[0]:.0f} {a[1]:.0f} L {b[0]:.0f} {b[1]:.0f}"
        label = ((a[0] + b[0]) / 2 + dx, (a[1] + b[1]) / 2 + dy)
    return [f'<path d="{path}" fill="none" stroke="#444" stroke-width="1.5" marker-end="url(#tip)"/>',
            *text_lines(*label, anchor, lines)]


def automaton_svg(table):
    unknown = [name for name in table["locations"] if name not in PLACES]
    if unknown:
        die(f"no place in the picture for location {unknown[0]}; add it to PLACES")
    rows = table["rows"]
    top, per_column = 590, math.ceil(len(rows) / 2)
    width, height = 1240, top + LINE * per_column + 30
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}">',
           '<defs><marker id="tip" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="8" markerHeight="8" orient="auto">'
           '<path d="M 0 0 L 10 5 L 0 10 z" fill="#444"/></marker></defs>',
           f'<rect width="{width}" height="{height}" fill="white"/>']
    edges = {}
    for row in rows:
        edges.setdefault((row["from"], row["to"]), []).append(row)
    for (start, end), its in edges.items():
        out += edge(start, end, its)
    for name in table["locations"]:
        x, y = PLACES[name]
        out.append(f'<rect x="{x - BOX[0] / 2:.0f}" y="{y - BOX[1] / 2:.0f}" width="{BOX[0]}" height="{BOX[1]}" rx="8" fill="#e8eef8" stroke="#224"/>')
        out.append(f'<text x="{x}" y="{y + 5}" font-size="15" text-anchor="middle" font-weight="bold" {FONT}>{name}</text>')
    for i, row in enumerate(rows):
        x, y = 20 + width / 2 * (i // per_column), top + LINE * (i % per_column)
        bold = ' font-weight="bold"' if row["sends"] else ""
        out.append(f'<text x="{x:.0f}" y="{y:.0f}" font-size="12" {FONT}{bold}>{html.escape(row["name"])}</text>')
        out.append(f'<text x="{x + 75:.0f}" y="{y:.0f}" font-size="12" {FONT}>{html.escape(row["condition"])}</text>')
    out.append(f'<text x="20" y="{height - 8}" font-size="11" fill="#555" {FONT}>in the order in which they are tried; bold: sends a command</text>')
    return "\n".join(out + ["</svg>", ""])


# --- Free-kick positions ---

SCALE = 60  # pixels per metre


def field_svg(data):
    length, width, radius, stretch = data["length"], data["width"], data["area_radius"], data["area_stretch"]
    out = [f'<rect x="{-length / 2}" y="{-width / 2}" width="{length}" height="{width}"/>',
           f'<line x1="0" y1="{-width / 2}" x2="0" y2="{width / 2}"/>']
    for side in (-1, 1):
        x, sweep = side * length / 2, 0 if side > 0 else 1
        for r in (radius, radius + data["free_kick_area_distance"]):
            dash = "" if r == radius else ' stroke-dasharray="0.06 0.06"'
            out.append(f'<path d="M {x} {-stretch / 2 - r} A {r} {r} 0 0 {sweep} {x - side * r} {-stretch / 2} V {stretch / 2}'
                       f' A {r} {r} 0 0 {sweep} {x} {stretch / 2 + r}"{dash}/>')
        out.append(f'<path d="M {x} {-data["goal_width"] / 2} h {side * 0.18} v {data["goal_width"]} h {-side * 0.18}"/>')
    return ['<g fill="none" stroke="#999" stroke-width="0.02">', *out, "</g>"]


def positions_svg(data):
    panels = [("yellow", "free kick for yellow, which attacks to the right", "#c08a00"),
              ("blue", "free kick for blue, which attacks to the left", "#2050c0"),
              ("neutral", "neutral start", "#207040")]
    w, h = data["length"] + 1, data["width"] + 1.4
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {w} {h * len(panels)}" width="{w * SCALE:.0f}">',
           f'<rect width="{w}" height="{h * len(panels)}" fill="white"/>']
    for i, (key, title, colour) in enumerate(panels):
        out.append(f'<g transform="translate({w / 2} {h * i + h / 2 + 0.2:.2f})">')
        out.append(f'<text x="0" y="{-h / 2 + 0.25:.2f}" font-size="0.24" text-anchor="middle" {FONT}>{title}</text>')
        out += field_svg(data)
        stays, moves, ends = [], [], {}
        for point in data["points"]:
            (x, y), (u, v) = point["place"], point[key]
            if math.hypot(u - x, v - y) < 0.002:
                stays.append(f"M{x:g} {-y:g}h0")
            else:
                moves.append(f"M{x:g} {-y:g}L{u:.2f} {-v:.2f}")
                ends[f"M{u:.2f} {-v:.2f}h0"] = None  # a set that keeps its order
        dots = 'fill="none" stroke-linecap="round"'
        out.append(f'<path d="{"".join(stays)}" {dots} stroke="#bbb" stroke-width="0.03"/>')
        out.append(f'<path d="{"".join(moves)}" fill="none" stroke="{colour}" stroke-width="0.012" opacity="0.6"/>')
        out.append(f'<path d="{"".join(ends)}" {dots} stroke="{colour}" stroke-width="0.07"/>')
        out.append("</g>")
    return "\n".join(out + ["</svg>", ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="compare, write nothing")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/bin/ssl-autoref")
    options = parser.parse_args()
    if not options.program.exists():
        die(f"{options.program}: no such program; build it, or name it with --program")
    stale = []
    for command, draw in (("automaton", automaton_svg), ("positions", positions_svg)):
        printed = subprocess.run([options.program, command], check=True, capture_output=True, text=True).stdout
        picture, file = draw(json.loads(printed)), FOLDER / f"{command}.svg"
        if not options.check:
            file.write_text(picture)
            print(file)
        elif not file.exists() or file.read_text() != picture:
            stale.append(str(file.relative_to(ROOT)))
    if stale:
        die(f"{' and '.join(stale)}: not what the program says; run scripts/draw_automaton.py")


main()
