#!/usr/bin/env python3
"""Renders a picture like a photograph of an apple on a table, and writes it with an outline as apple.svg.

    render_apple.py [FOLDER]      (default: the folder of this script)

The rays of a camera are marched through a distance field. The same picture on every run.
"""

import sys
from pathlib import Path

import numpy as np
from apple_camera import EYE, SCALE, SIZE, blurred, developed, rays_of_camera
from apple_scene import TABLE, apple_distance, bark, distance, skin, smoothstep, stem_distance, unit, wood
from outlined import closed_path, outlined_photograph

LIGHT, LIGHT_RIGHT, LIGHT_UP = np.array([-3.3, 4.4, 2.9]), np.array([1.25, 0.0, 1.4]), np.array([0.75, 1.25, -0.67])


def march(field, origins, rays):
    """Returns the ways along the rays to the surface of the field, and whether each ray hits it."""
    middle = -np.sum(origins * rays, axis=-1)
    way, gap = middle - 1.5, np.full(len(rays), np.inf)
    live = np.flatnonzero(np.sum((origins + middle[:, None] * rays) ** 2, axis=-1) < 1.5**2)
    for _ in range(110):
        gap[live] = field(origins[live] + way[live, None] * rays[live])
        way[live] += 0.42 * gap[live]
        live = live[(gap[live] > 2e-4) & (way[live] < middle[live] + 1.5)]
    return way, gap < 4e-3


def normals(field, points):
    """Returns the field's unit gradients."""
    steps = 1e-3 * np.eye(3)
    return unit(np.stack([field(points + step) - field(points - step) for step in steps], axis=-1))


def lit_part(points, normal):
    """Returns how much of the soft box each point sees past the apple and its stem, from 0 to 1."""
    to_light = unit(LIGHT - points)
    start, seen = points + 0.02 * normal, np.ones(len(points))
    for way in np.geomspace(0.02, 1.6, 28):
        seen = np.minimum(seen, 0.5 + 2.2 * distance(start + way * to_light) / way)
    return smoothstep(0, 1, seen)


def openness(points, normal):
    """Returns how open the surroundings of each point are, from 0 to 1, the table under the apple counted."""
    closed = np.zeros(len(points))
    for step in (0.04, 0.1, 0.2, 0.36, 0.6):
        probe = points + step * normal
        closed += np.maximum(0, step - np.minimum(distance(probe), probe[:, 1] - TABLE)) / step * 0.2
    return np.clip(1 - closed, 0, 1) ** 1.3


def surroundings(points, rays):
    """Returns the light that comes along reflected rays: the soft box, a pale wall, a white card and the table."""
    way = np.sum((LIGHT - points) * unit(LIGHT), axis=-1) / np.sum(rays * unit(LIGHT), axis=-1)
    place = points + way[:, None] * rays - LIGHT
    across = np.abs(place @ LIGHT_RIGHT) / np.sum(LIGHT_RIGHT**2)
    upwards = np.abs(place @ LIGHT_UP) / np.sum(LIGHT_UP**2)
    box = smoothstep(1.25, 0.55, (across**4 + upwards**4) ** 0.25) * (way > 0)
    up = smoothstep(-0.15, 0.25, rays[:, 1])[:, None]
    room = np.array([0.30, 0.17, 0.09]) * (1 - up) + np.array([0.42, 0.45, 0.50]) * up
    card = smoothstep(0.8, 0.98, rays @ unit(np.array([0.95, 0.25, -0.1])))[:, None] * np.array([0.8, 0.8, 0.85])
    return room + card + box[:, None] * np.array([13.0, 12.7, 12.2])


def shaded(points, rays, rng):
    """Returns the light that the apple and its stem send back along the rays."""
    normal = normals(distance, points)
    stem = (stem_distance(points) < apple_distance(points))[:, None]
    colour = np.where(stem, bark(points, rng), skin(points, rng))
    facing = np.sum(normal * unit(LIGHT - points), axis=-1)
    key = (np.clip((facing + 0.22) / 1.22, 0, 1) ** 1.6 * lit_part(points, normal))[:, None]
    up = 0.5 + 0.5 * normal[:, 1:2]
    fill = np.array([0.22, 0.24, 0.28]) * up + np.array([0.30, 0.17, 0.09]) * (1 - up)
    side = np.clip(normal @ unit(np.array([0.9, 0.2, 0.0])), 0, 1)[:, None] * np.array([0.14, 0.14, 0.14])
    open_part = openness(points, normal)[:, None]
    bump = unit(normal + 0.006 * rng.normal(size=normal.shape))
    facing_eye = np.clip(-np.sum(rays * bump, axis=-1), 0, 1)[:, None]
    mirror = surroundings(points, rays + 2 * facing_eye * bump)
    fresnel = (0.035 + 0.965 * (1 - facing_eye) ** 5 * 0.5) * np.where(stem, 0.15, 1.0)
    return colour * (1.9 * key * np.array([1.0, 0.97, 0.91]) + (fill + side) * open_part) + fresnel * mirror * open_part


def table_light(points):
    """Returns the light that falls on points of the table, past an ellipsoid in the apple's place."""
    seen = np.zeros(len(points))
    half = np.array([1.0, 0.8, 1.0])
    cells = [(a, b) for a in np.linspace(-0.9, 0.9, 9) for b in np.linspace(-0.9, 0.9, 9)]
    for a, b in cells:
        ray = unit(LIGHT + a * LIGHT_RIGHT + b * LIGHT_UP - points) / half
        start = points / half
        near = np.sum(start**2, axis=-1) - np.sum(start * ray, axis=-1) ** 2 / np.sum(ray**2, axis=-1)
        seen += smoothstep(0.985, 1.015, near) / len(cells)
    away = np.linalg.norm(points[:, [0, 2]], axis=-1)
    room = 1 - 0.93 * np.exp(-((away / 0.68) ** 2.0)) - 0.07 * np.exp(-away)
    falloff = 30 / np.sum((LIGHT - points) ** 2, axis=-1)
    return (seen * falloff)[:, None] * np.array([1.0, 0.96, 0.9]) + room[:, None] * np.array([0.22, 0.23, 0.25])


def behind(rays, rng):
    """Returns the picture behind the apple, sharp, and how far from sharp it is to be, in pixels of the raster."""
    way = (TABLE - EYE[1]) / np.minimum(rays[:, 1], -1e-3)
    points = EYE + way[:, None] * rays
    on_table = (points[:, 2] > -5.5) & (rays[:, 1] < 0)
    x, z = points[:, 0] * 0.96 + points[:, 2] * 0.28, points[:, 2] * 0.96 - points[:, 0] * 0.28
    table = wood(x, z, rng) * table_light(points)
    sheen = (0.02 + 0.30 * (1 + np.minimum(rays[:, 1], 0)) ** 5)[:, None] * np.array([0.40, 0.42, 0.46])
    side, height = rays[:, 0] / -rays[:, 2], rays[:, 1] / -rays[:, 2]
    glow = np.exp(-((side + 0.35) ** 2) * 9 - (height + 0.05) ** 2 * 12)[:, None]
    wall = np.array([0.085, 0.086, 0.078]) * (1.5 + 1.1 * glow)
    for place, width, tint in [(-0.34, 0.07, (0.20, 0.24, 0.22)), (0.27, 0.10, (0.02, 0.035, 0.03))]:
        wall += smoothstep(width, width * 0.8, np.abs(side - place))[:, None] * (np.array(tint) - wall) * 0.5
    depth = np.linalg.norm(points - EYE, axis=-1)
    focus = np.linalg.norm(EYE) - 0.9
    blur = np.where(on_table, np.minimum(20, 16 * np.abs(depth - focus) / depth), 20)
    return np.where(on_table[:, None], table + sheen, wall), blur


def photograph(rng):
    """Returns the photograph, and which pixels of its raster show the apple without its stem."""
    width, height = SIZE * SCALE
    rays = rays_of_camera()
    origins = np.broadcast_to(EYE, rays.shape)
    ways, hit = march(distance, origins, rays)
    light, blur = behind(rays, rng)
    light = blurred(light.reshape(height, width, 3), blur.reshape(height, width)).reshape(-1, 3)
    light[hit] = shaded(EYE + ways[hit, None] * rays[hit], rays[hit], rng)
    _, body = march(apple_distance, origins, rays)
    return developed(light.reshape(height, width, 3), rng), body.reshape(height, width)


def outline(mask, nodes=12, inside=2.0):
    """Returns a smooth closed path that lies `inside` pixels of the picture within the mask."""
    y, x = np.nonzero(mask)
    middle = np.array([x.mean(), y.mean()])
    turn = np.arange(720) * 2 * np.pi / 720
    reach = np.arange(0, 0.42 * min(mask.shape), 0.25)
    column = (middle[0] + np.cos(turn)[:, None] * reach).astype(int)
    row = (middle[1] + np.sin(turn)[:, None] * reach).astype(int)
    wave = np.fft.rfft(np.sum(mask[row, column], axis=1) * 0.25 / SCALE - inside)[:12]
    radius, slope = np.fft.irfft(wave, 720), np.fft.irfft(1j * np.arange(12) * wave, 720)
    ray = np.exp(1j * turn)
    points, tangents = complex(*middle / SCALE) + radius * ray, (slope + 1j * radius) * ray * 2 * np.pi / nodes
    return closed_path(points[:: 720 // nodes], tangents[:: 720 // nodes])


def main(folder):
    """Writes apple.svg into the folder."""
    image, mask = photograph(np.random.default_rng(7))
    document = outlined_photograph(image, "Apple", "apple", outline(mask), "#00e5ff")
    (folder / "apple.svg").write_text(document)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent)
