"""A peer: scikit-image's SSIM of the two images in a folder, on one thread, as JSON.

    skimage_ssim.py FOLDER REPETITIONS

`cpu_seconds` is the shortest of the repetitions; `error` is 1 - SSIM over the whole map, as ours.
"""

import json
import os
import sys
import time
from pathlib import Path

for library in ("OMP", "OPENBLAS", "MKL"):
    os.environ[f"{library}_NUM_THREADS"] = "1"

import numpy as np  # noqa: E402
from PIL import Image  # noqa: E402
from skimage.metrics import structural_similarity  # noqa: E402


def ssim(a, b):
    """The map's mean, by the settings of Wang et al. 2004, which ours has too."""
    settings = {"gaussian_weights": True, "sigma": 1.5, "use_sample_covariance": False}
    _, whole = structural_similarity(a, b, channel_axis=2, data_range=255, full=True, **settings)
    return whole.mean()


def main(folder, repetitions):
    a, b = (np.asarray(Image.open(folder / f"{name}.png")) for name in ("reference", "test"))
    times = []
    for _ in range(repetitions):
        start = time.process_time()
        value = ssim(a, b)
        times.append(time.process_time() - start)
    print(json.dumps({"cpu_seconds": min(times), "error": 1 - value}))


if __name__ == "__main__":
    main(Path(sys.argv[1]), int(sys.argv[2]))
