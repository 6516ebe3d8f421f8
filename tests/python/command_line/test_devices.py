"""Graphics processors, or what stands in for them: `gradmesh devices` and --renderer."""

import warnings

import numpy as np
import pytest
from PIL import Image

from built import SAMPLES, gradmesh as run
from program import printed, simplified as reported

import gradmesh

TENSOR = SAMPLES / "tensor.svg"

#: With these Mesa's drivers offer no OpenGL that is new enough.
TOO_OLD = {"MESA_GL_VERSION_OVERRIDE": "3.3", "MESA_GLES_VERSION_OVERRIDE": "3.0"}
NO_DEVICE = (
    "gradmesh: EGL offers no device that can be used (gradmesh devices tells why); it goes on in software.\n"
)


@pytest.fixture(scope="module")
def device():
    """What is listed. Skips where no device can be used."""
    listed = printed("devices")
    if "can be used" not in listed.replace("cannot be used", ""):
        pytest.skip("EGL offers no device with OpenGL 4.3 or OpenGL ES 3.2")
    return listed


def test_devices_are_listed_with_what_auto_takes(device):
    names = [line for line in device.splitlines() if line and not line.startswith((" ", "auto"))]
    assert names and "  version " in device
    assert device.splitlines()[-1].startswith("auto takes ")
    if all(name.endswith(": a program in place of a graphics processor") for name in names):
        taken = printed("devices", SAMPLES / "two.svg").splitlines()[-1]
        assert taken == "auto takes software: there is no graphics processor that can be used."


def test_a_device_that_is_too_old_says_why(device):
    if "llvmpipe" not in device:
        pytest.skip("the device is not Mesa's llvmpipe")
    listed = printed("devices", env=TOO_OLD)
    assert "cannot be used: it has neither OpenGL 4.3 nor OpenGL ES 3.2" in listed


@pytest.mark.parametrize("old", [{}, {"MESA_GL_VERSION_OVERRIDE": "3.3"}], ids=["OpenGL", "OpenGL ES"])
@pytest.mark.full(all_but=1)
def test_a_device_gives_the_same_document(device, tmp_path, monkeypatch, old):
    for name, value in old.items():
        monkeypatch.setenv(name, value)
    out, files, renderers = tmp_path / "out.svg", [], []
    for renderer in ("software", "egl"):
        options = ("--method", "gqe", "--resolution", 100, "--renderer", renderer)
        (mesh,) = reported(SAMPLES / "face.svg", out, *options)
        files.append(out.read_bytes())
        renderers.append(mesh["renderer"])
    assert files[0] == files[1]
    assert renderers[0] == "software" and renderers[1] in device


def test_a_device_gives_the_same_picture(device, tmp_path):
    for renderer in ("software", "egl"):
        run("render", SAMPLES / "opacity.svg", "-o", tmp_path / f"{renderer}.png", "--renderer", renderer)
    pictures = [np.asarray(Image.open(tmp_path / f"{r}.png")).astype(int) for r in ("software", "egl")]
    difference = np.abs(pictures[0] - pictures[1]).max(axis=2)
    assert pictures[0].min() < 200
    assert difference.max() <= 1 and (difference > 0).mean() <= 0.001


def test_without_a_device_one_line_says_so_and_the_result_is_the_same(tmp_path):
    if "llvmpipe" not in printed("devices"):
        pytest.skip("only Mesa's llvmpipe can be made to offer too little")
    files = [tmp_path / f"{renderer}.svg" for renderer in ("software", "egl")]
    quick = ("--resolution", 64, "--quiet")
    printed("simplify", TENSOR, "-o", files[0], *quick)
    told = run("simplify", TENSOR, "-o", files[1], "--renderer", "egl", *quick, env=TOO_OLD)
    assert told.stderr == NO_DEVICE
    assert files[0].read_bytes() == files[1].read_bytes()


def test_an_unknown_renderer_is_refused():
    with pytest.raises(ValueError, match="auto, software and egl"):
        gradmesh.simplify(gradmesh.load(TENSOR), renderer="vulkan")


def test_the_package_takes_a_device(device):
    document = gradmesh.load(TENSOR)
    (on_device,) = gradmesh.simplify(document, resolution=64, renderer="egl", method="gqe")
    other = gradmesh.load(TENSOR)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        (in_software,) = gradmesh.simplify(other, resolution=64, method="gqe")
    assert on_device.renderer in device
    assert document.to_bytes() == other.to_bytes()
    if "processor" not in device.splitlines()[0]:
        pytest.skip("auto may have taken the device")
    assert in_software.renderer == "software"
