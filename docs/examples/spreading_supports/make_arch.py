"""Prints the blocks of arch.toml: a semicircular arch of 15 voussoirs of radius 5 m, on two supports."""
import math

RADIUS, THICKNESS, COUNT = 5.0, 0.75, 15


def corner(radius, angle):
    return [round(radius * math.cos(angle), 9), round(radius * math.sin(angle), 9)]


inner, outer = RADIUS - THICKNESS / 2, RADIUS + THICKNESS / 2
for i in range(COUNT):
    low, high = math.pi * i / COUNT, math.pi * (i + 1) / COUNT
    corners = [corner(inner, low), corner(outer, low), corner(outer, high), corner(inner, high)]
    print(f'  {{ name = "stone.{i}", material = "stone", vertices = {corners} }},')
