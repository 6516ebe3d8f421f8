"""What people wait for is the same to the byte on any number of threads."""

import pytest
from PIL import Image

import built

gradmesh = pytest.importorskip("gradmesh", reason="the compiled package is not there")
pytestmark = [pytest.mark.module_only, pytest.mark.full]

THREADS = (1, 2, 3, 7)
SHARED = built.ROOT.parent / "shared"
#: The documents of `scripts/bench --only threads`, at a resolution at which a run takes a second.
DOCUMENTS = [
    built.SAMPLES / "photo.svg",
    built.SAMPLES / "face.svg",
    built.SAMPLES / "fruit.svg",
    built.SAMPLES / "ellipse.svg",
    built.SAMPLES / "two.svg",
    SHARED / "dense" / "face_sampled_41.svg",
    SHARED / "dense" / "sunset_sampled_41.svg",
    SHARED / "real" / "oxygen-juk.svg",
    SHARED / "real" / "suru-disks-app.svg",
]


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.stem)
def test_simplified_documents(path):
    if not path.exists():
        pytest.skip(f"{path.name} is absent.")

    def simplified(threads):
        document = gradmesh.load(path)
        results = gradmesh.simplify(document, amount="balanced", resolution=200, threads=threads)
        told = [(r.id, r.method, r.error, r.evaluations, r.handles_after) for r in results]
        return document.to_bytes(), told

    alone = simplified(THREADS[0])
    for threads in THREADS[1:]:
        assert simplified(threads) == alone


def test_a_trace(tmp_path):
    picture = tmp_path / "picture.png"
    Image.fromarray(gradmesh.render(gradmesh.load(built.SAMPLES / "face.svg"), resolution=240)).save(picture)
    traced = [gradmesh.trace(picture, handles=150, epsilon=0, threads=threads) for threads in THREADS]
    assert len({made.document.to_bytes() for made in traced}) == 1


def test_blocks():
    path = SHARED / "meshes" / "global_duck.hemesh"
    if not path.exists():
        pytest.skip(f"{path.name} is absent.")

    def best(threads):
        document = gradmesh.load(path)
        gradmesh.simplify(document, method="best", epsilon=0.02, resolution=200, threads=threads)
        return document.to_bytes()

    alone = best(THREADS[0])
    for threads in THREADS[1:]:
        assert best(threads) == alone
