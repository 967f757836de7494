"""Writes record.csv: 12 s of ground acceleration, in g, like that of a strong earthquake on rock."""
import math
import pathlib
import random

STEP = 0.01  # s
PEAK = 0.35  # g

random.seed(7)
waves = [(random.uniform(1.0, 12.0), random.uniform(0, 2 * math.pi)) for _ in range(40)]


def shape(time):
    """Rises within 2 s, stays until 5 s, and decays."""
    return (time / 2) ** 2 if time < 2 else math.exp(-0.45 * max(0.0, time - 5))


def acceleration(time):
    return shape(time) * sum(math.sin(2 * math.pi * hertz * time + phase) / hertz for hertz, phase in waves)


times = [STEP * i for i in range(1201)]
record = [acceleration(time) for time in times]
scale = PEAK / max(map(abs, record))
record[0] = record[-1] = 0
lines = ["time s, acceleration g"]
lines += [f"{time:.2f}, {scale * value:.5f}" for time, value in zip(times, record)]
pathlib.Path(__file__).with_name("record.csv").write_text("\n".join(lines) + "\n", encoding="ascii")
