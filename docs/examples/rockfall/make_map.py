#!/usr/bin/python3
"""Writes slope.csv, a height map for rockfall.toml: a steep upper slope with a gully, a bench, and a flat valley.

Usage: docs/examples/rockfall/make_map.py      in the root of the repository
"""
import math
from pathlib import Path

SPACING, COLUMNS, ROWS = 2, 46, 26  # m, nodes from west to east, nodes from north to south


def height(x, y):
    """Falls from 40 m in the west to 0 in the east."""
    fall = 40 - 0.95 * x if x < 30 else 11.5 - 0.28 * (x - 30)
    gully = 3 * math.exp(-((y - 25 - 4 * math.sin(x / 14)) / 6) ** 2) * min(1, x / 15)
    bumps = 0.35 * math.sin(0.9 * x + 0.5 * y) * math.sin(0.7 * y - 0.2 * x)
    return max(fall - gully, 0) + bumps


def main():
    rows = [",".join(f"{height(SPACING * column, SPACING * (ROWS - 1 - row)):.2f}" for column in range(COLUMNS))
            for row in range(ROWS)]
    Path("docs/examples/rockfall/slope.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
