"""The camera that photographs the apple: its rays, its focus, and how it makes a picture of light."""

import numpy as np
from PIL import Image

from apple_scene import unit

SIZE = np.array([600, 450])
SCALE = 2
EYE, TARGET, ZOOM = np.array([0.25, 2.25, 6.3]), np.array([0.07, 0.08, 0.0]), 2.95


def rays_of_camera():
    """Returns the camera's rays through the pixels of the raster, which is finer than the picture."""
    width, height = SIZE * SCALE
    y, x = np.mgrid[0:height, 0:width] + 0.5
    forward = unit(TARGET - EYE)
    right = unit(np.cross(forward, [0.0, 1.0, 0.0]))
    x, y = (2 * x - width) / width, (height - 2 * y) / width
    return unit(ZOOM * forward + x[..., None] * right + y[..., None] * np.cross(right, forward)).reshape(-1, 3)


def softened(picture, sigma):
    """Returns the picture under a Gaussian blur, its edges repeated outwards."""
    if sigma == 0:
        return picture
    margin = int(3 * sigma) + 1
    padded = np.pad(picture, ((margin, margin), (margin, margin), (0, 0)), mode="edge")
    down, across = np.fft.fftfreq(padded.shape[0])[:, None], np.fft.rfftfreq(padded.shape[1])
    passed = np.exp(-2 * (np.pi * sigma) ** 2 * (down**2 + across**2))
    waves = np.fft.rfft2(padded, axes=(0, 1)) * passed[..., None]
    return np.fft.irfft2(waves, padded.shape[:2], axes=(0, 1))[margin:-margin, margin:-margin]


def blurred(picture, blur):
    """Returns the picture with a Gaussian blur of its own at each pixel, between the two nearest of a few."""
    sigmas = [0, 1, 2.5, 5, 10, 20]
    level = np.interp(blur, sigmas, np.arange(len(sigmas)))[..., None]
    return sum(softened(picture, sigma) * np.clip(1 - np.abs(level - i), 0, 1) for i, sigma in enumerate(sigmas))


def developed(light, rng):
    """Returns the photograph of the light: reduced, with bloom, vignette, a film's curve and a sensor's noise."""
    height, width = light.shape[0] // SCALE, light.shape[1] // SCALE
    light = light.reshape(height, SCALE, width, SCALE, 3).mean(axis=(1, 3))
    light = 0.94 * light + 0.06 * softened(np.minimum(light, 6), 9)
    y, x = np.mgrid[-1 : 1 : height * 1j, -1 : 1 : width * 1j]
    light = light * (1 - 0.16 * (x**2 + y**2))[..., None] * 1.08
    film = np.clip(light * (2.51 * light + 0.03) / (light * (2.43 * light + 0.59) + 0.14), 0, 1) ** (1 / 2.2)
    grain = softened(rng.normal(size=film.shape), 0.5)
    film = film + grain * (0.007 + 0.009 * np.sqrt(np.clip(1 - film, 0, 1)))
    return Image.fromarray((255 * np.clip(film, 0, 1) + 0.5).astype(np.uint8))
