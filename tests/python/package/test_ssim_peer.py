"""SSIM against a peer, scikit-image, on random pairs of pictures of all sizes."""

import pytest

import built  # noqa: F401  finds the package

np = pytest.importorskip("numpy")
peer = pytest.importorskip("skimage.metrics", reason="Debian package python3-skimage is absent")
gradmesh = pytest.importorskip("gradmesh", reason="the compiled package is not there")

REACH = 5  # of the 11 x 11 window

pytestmark = pytest.mark.module_only


def peers_error(a, b):
    """1 - SSIM by scikit-image with the constants of Wang et al. 2004, which are ours.

    It leaves out of its mean what lies within the window's reach of the border. So the pictures
    are grown by that, with the pixels of their edges, which is what ours takes beyond the border.
    """
    a, b = (np.pad(p, ((REACH, REACH), (REACH, REACH), (0, 0)), mode="edge") for p in (a, b))
    settings = {"gaussian_weights": True, "sigma": 1.5, "use_sample_covariance": False}
    return 1 - peer.structural_similarity(a, b, channel_axis=2, data_range=255, **settings)


def noise(numbers, height, width):
    return numbers.integers(0, 256, (height, width, 3))


def ramp(numbers, height, width):
    """From one colour to another, across and down."""
    first, across, down = numbers.uniform(0, 255, (3, 3))
    y, x = np.mgrid[0:height, 0:width] / max(height, width)
    return first + x[..., None] * (across - first) + y[..., None] * (down - first)


def flat(numbers, height, width):
    return np.ones((height, width, 1)) * numbers.integers(0, 256, 3)


def blurred(picture):
    for axis in (0, 1):
        picture = (np.roll(picture, 1, axis) + 2 * picture + np.roll(picture, -1, axis)) / 4
    return picture


CHANGES = {
    "equal": lambda numbers, p: p,
    "one level": lambda numbers, p: p + numbers.integers(-1, 2, p.shape),
    "one pixel": lambda numbers, p: p + 255.0 * (np.arange(p.size).reshape(p.shape) // 3 == p.size // 6),
    "noisy": lambda numbers, p: p + numbers.normal(0, 20, p.shape),
    "blurred": lambda numbers, p: blurred(p),
    "darker": lambda numbers, p: 0.7 * p,
    "shifted": lambda numbers, p: np.roll(p, (1, 2), (0, 1)),
    "inverse": lambda numbers, p: 255 - p,
    "another": lambda numbers, p: noise(numbers, *p.shape[:2]),
}
SIZES = ((11, 11), (1, 1), (1, 40), (5, 3), (10, 12), (12, 10), (23, 65), (64, 64), (97, 31), (128, 131))


CLOSE = ("equal", "one level", "noisy", "blurred", "shifted")
PICTURES = (noise, ramp, flat, lambda *sizes: blurred(noise(*sizes)))
PAIRS = 56  # of each change, 504 in all


def pairs(change):
    numbers = np.random.default_rng(list(CHANGES).index(change))
    for i in range(PAIRS):
        reference = PICTURES[i % 4](numbers, *SIZES[i // 4 % len(SIZES)])
        test = CHANGES[change](numbers, reference)
        yield tuple(np.clip(np.rint(p), 0, 255).astype(np.uint8) for p in (reference, test))


@pytest.mark.parametrize("change", CHANGES)
@pytest.mark.full(all_but=1)
def test_ssim_is_that_of_scikit_image(change):
    off = [abs(gradmesh.compare(*pair, "ssim") - peers_error(*pair)) for pair in pairs(change)]
    # Ours adds floats, theirs doubles: of a difference that is large and flat, the mean square and
    # the squared mean all but cancel.
    assert max(off) <= (1e-6 if change in CLOSE else 1e-5)
    assert np.median(off) <= 1e-7
    if change == "equal":
        assert max(off) <= 1e-15
