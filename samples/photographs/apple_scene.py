"""What the picture of the apple shows: the shapes of the apple and its stem, and the colours of all surfaces."""

import numpy as np

TABLE = -0.79
STEM = np.array([[0.0, 0.35, 0.0], [0.01, 0.62, 0.0], [0.04, 0.82, 0.01], [0.10, 1.0, 0.02], [0.19, 1.14, 0.03]])


def unit(vectors):
    """Returns the vectors divided by their lengths."""
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def smoothstep(low, high, value):
    """Returns 0 where the value is below `low`, 1 where it is above `high`, and a smooth step between them."""
    part = np.clip((value - low) / (high - low), 0, 1)
    return part * part * (3 - 2 * part)


def noise(rng, rows, columns):
    """Returns a smooth random function with values about 0, of period 1 in both its arguments."""
    grid = rng.normal(size=(rows, columns))

    def value(v, u):
        v, u = np.asarray(v) * rows, np.asarray(u) * columns
        i, j = np.floor(v).astype(int), np.floor(u).astype(int)
        y, x = smoothstep(0, 1, v - i), smoothstep(0, 1, u - j)
        above = grid[i % rows, j % columns] * (1 - x) + grid[i % rows, (j + 1) % columns] * x
        below = grid[(i + 1) % rows, j % columns] * (1 - x) + grid[(i + 1) % rows, (j + 1) % columns] * x
        return above * (1 - y) + below * y

    return value


def apple_distance(points):
    """Returns about how far the points lie outside the apple: lobed, wide at its shoulders, dimpled at its ends."""
    length = np.linalg.norm(points, axis=-1) + 1e-9
    down = np.arccos(np.clip(points[..., 1] / length, -1, 1))
    around = np.arctan2(points[..., 2], points[..., 0])
    radius = 0.98 + 0.075 * np.cos(down) - 0.05 * np.cos(2 * down) - 0.56 * np.exp(-((down / 0.36) ** 2))
    radius -= 0.12 * np.exp(-(((np.pi - down) / 0.35) ** 2))
    lobes = np.cos(5 * around + 0.6) * (0.012 + 0.012 * smoothstep(1.5, 2.8, down)) + 0.02 * np.cos(2 * around - 1)
    shoulders = 0.02 * np.cos(3 * around + 2) * np.exp(-(((down - 0.55) / 0.4) ** 2))
    return length - radius - np.sin(down) * lobes - shoulders


def stem_distance(points):
    """Returns how far the points lie outside the stem: a chain of rods that grows thicker towards its end."""
    nearest = np.full(points.shape[:-1], np.inf)
    for i, (start, end) in enumerate(zip(STEM, STEM[1:])):
        along = np.clip((points - start) @ (end - start) / np.sum((end - start) ** 2), 0, 1)
        gap = np.linalg.norm(points - start - along[..., None] * (end - start), axis=-1)
        nearest = np.minimum(nearest, gap - 0.024 - 0.026 * ((i + along) / 4) ** 4)
    return nearest


def distance(points):
    """Returns about how far the points lie outside the apple and its stem."""
    return np.minimum(apple_distance(points), stem_distance(points))


def skin(points, rng):
    """Returns the skin's colour: yellow, with a red blush that ends in streaks, and small pale dots."""
    direction = unit(points)
    down, around = np.arccos(direction[:, 1]) / np.pi, np.arctan2(direction[:, 2], direction[:, 0]) / (2 * np.pi)
    clouds, streaks, fine = noise(rng, 4, 7), noise(rng, 4, 80), noise(rng, 6, 260)
    blush = 0.55 + 0.62 * (direction @ unit(np.array([0.75, 0.1, 0.55]))) + 0.16 * clouds(down, around)
    bend = around + 0.012 * clouds(down + 0.3, around)
    blush += (0.07 * streaks(down, bend) + 0.04 * fine(down, bend)) * smoothstep(0.1, 0.3, down)
    blush = smoothstep(-0.1, 0.95, blush) * (0.25 + 0.75 * smoothstep(0.05, 0.26, down + 0.02 * streaks(0.5, around)))
    yellow, red, deep = np.array([0.80, 0.56, 0.10]), np.array([0.60, 0.045, 0.03]), np.array([0.30, 0.008, 0.018])
    colour = yellow + (np.array([0.50, 0.55, 0.10]) - yellow) * smoothstep(0.2, 0.03, down)[:, None]
    blush = blush[:, None]
    colour = colour * (1 - blush) ** 1.3 + (1 - (1 - blush) ** 1.3) * (red + (deep - red) * blush**3)
    spots = unit(rng.normal(size=(450, 3)))
    nearest = np.max(direction.astype(np.float32) @ spots.T.astype(np.float32), axis=1)
    pale = (0.09 + 0.04 * clouds(7 * down, 5 * around)) * smoothstep(0.15, 0.3, down)
    dots = pale * smoothstep(1 - 0.00010, 1 - 0.00001, nearest)
    return colour + (np.array([0.85, 0.66, 0.32]) - colour) * dots[:, None]


def bark(points, rng):
    """Returns the stem's colour: a brown with small spots."""
    return np.array([0.13, 0.07, 0.035]) * (1 + 0.25 * noise(rng, 60, 90)(points[:, 1:2] / 2, points[:, :1]))


def wood(x, z, rng):
    """Returns the colour of the table's boards."""
    board = np.floor(z / 1.9 + 0.42)
    shift = board * 0.37
    warp = noise(rng, 11, 5)(z / 9 + shift, x / 16 + shift)
    rings = np.sin(26 * (z / 1.9 + 0.16 * warp + 0.05 * noise(rng, 30, 12)(z / 9, x / 16)) + 7 * shift)
    fibres = noise(rng, 420, 14)(z / 9 + shift, x / 16 + shift) + noise(rng, 900, 40)(z / 9, x / 16)
    tone = 1 + 0.10 * rings + 0.075 * fibres + 0.12 * np.sin(5.1 * board)
    gap = smoothstep(0.0, 0.014, np.abs(z / 1.9 + 0.42 - np.round(z / 1.9 + 0.42)))
    return (tone * (0.25 + 0.75 * gap))[..., None] * np.array([0.33, 0.155, 0.068])
