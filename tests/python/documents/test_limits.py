"""Documents that ask for too much are refused with a sentence that says how to allow it."""

import os
import subprocess

import pytest

from bad_documents import DOCUMENT, linked
from built import PROGRAM, SAMPLES

FRUIT = SAMPLES / "fruit.svg"


def run(*arguments, limits=""):
    return subprocess.run(
        [str(PROGRAM), *map(str, arguments)],
        env={**os.environ, "GRADMESH_LIMITS": limits},
        capture_output=True,
        text=True,
        timeout=60,
    )


def refused(done, *words):
    assert done.returncode == 1 and done.stdout == ""
    assert done.stderr.count("\n") == 1 and done.stderr.startswith("gradmesh: ")
    for word in words:
        assert str(word) in done.stderr
    return done.stderr


def allowed(sentence):
    """The setting that the sentence tells of."""
    (setting,) = [word for word in sentence.split() if word.startswith("GRADMESH_LIMITS=")]
    return setting.partition("=")[2]


def nested(levels):
    text = FRUIT.read_text()
    return text.replace("</svg>", "<g>" * levels + "</g>" * levels + "</svg>")


@pytest.mark.parametrize(
    "limits, words",
    [
        ("document=2K", (FRUIT, "bytes", "the limit of 2048")),
        ("patches=100", (FRUIT, "pear", "132 patches", "the limit of 100")),
        ("resolution=400", ("between 16 and 400",)),
        ("memory=1M", (FRUIT, "pear", "bytes", "the limit of 1048576")),
    ],
)
def test_a_sentence_says_what_would_allow_it(tmp_path, limits, words):
    out = tmp_path / "out.svg"
    done = run("simplify", FRUIT, "-o", out, "--method", "grid", limits=limits)
    if limits.startswith("resolution"):  # of an option, not of the document
        assert done.returncode == 2 and all(word in done.stderr for word in words)
        assert run("render", FRUIT, "-o", out, limits="resolution=700").returncode == 0
        return
    sentence = refused(done, *words)
    assert not out.exists()
    done = run("simplify", FRUIT, "-o", out, "--method", "grid", limits=allowed(sentence))
    assert (done.returncode, done.stderr) == (0, "")


def test_elements_inside_one_another(tmp_path):
    document = tmp_path / "deep.svg"
    document.write_text(nested(300))
    sentence = refused(run("info", document), document, "301 elements lie inside one another")
    assert run("info", document, limits=allowed(sentence)).returncode == 0
    # Far more than any stack holds.
    document.write_text(nested(500_000))
    refused(run("info", document), document, "500001 elements")


def test_gradients_that_refer_to_one_another(tmp_path):
    document = tmp_path / "chain.svg"
    text = linked(*((f"m{i}" if i else "m", f"m{i + 1}") for i in range(40)))
    document.write_text(text.replace("</defs>", '<meshgradient id="m40"/></defs>'))
    sentence = refused(run("simplify", document, "-o", tmp_path / "o.svg"), document, "41 gradients")
    assert "meshrow" in refused(
        run("simplify", document, "-o", tmp_path / "o.svg", limits=allowed(sentence))
    )


def test_more_elements_than_memory_holds(tmp_path):
    document = tmp_path / "many.svg"
    document.write_text(FRUIT.read_text().replace("</svg>", "<g/>" * 100_000 + "</svg>"))
    sentence = refused(run("info", document, limits="memory=20M"), document, "its elements take")
    assert run("info", document, limits=allowed(sentence)).returncode == 0


def test_a_file_without_end():
    refused(run("info", "/dev/zero", limits="document=1M"), "/dev/zero", "the limit of 1048576")


def test_photos_in_a_document_are_no_reason_to_refuse_it(tmp_path):
    document = tmp_path / "photo.svg"
    photo = f'<image id="photo" href="data:image/png;base64,{"A" * (12 << 20)}"/></svg>'
    document.write_text(FRUIT.read_text().replace("</svg>", photo))
    assert run("info", document).returncode == 0
    # But where a document declares entities, which may be built from one another, libxml2's limits hold.
    document.write_text("<!DOCTYPE svg [<!ENTITY a 'b'>]>" + photo.join(["<svg>", ""]))
    refused(run("info", document), document)


def test_entities_that_grow_in_attributes(tmp_path):
    document = tmp_path / "bomb.svg"
    entities = "<!ENTITY a0 'lollollol'>" + "".join(
        f"<!ENTITY a{i + 1} '{f'&a{i};' * 10}'>" for i in range(12)
    )
    svg = DOCUMENT.format(defs="").replace("<rect", '<rect class="&a12;"', 1)
    document.write_text(f"<!DOCTYPE svg [{entities}]>{svg}")
    refused(run("info", document, limits="memory=1G"), document)


def test_the_setting_itself_may_be_wrong():
    done = run("info", FRUIT, limits="patches=lots")
    assert done.returncode == 2 and '"patches=lots"' in done.stderr and done.stderr.count("\n") == 1


def test_in_python(tmp_path):
    program = (
        "import gradmesh\n"
        f"document = gradmesh.load({str(FRUIT)!r})\n"
        "try:\n"
        "    gradmesh.simplify(document)\n"
        "except gradmesh.InputError as error:\n"
        "    print(error)\n"
    )
    done = subprocess.run(
        ["/usr/bin/python3", "-c", program],
        env={**os.environ, "GRADMESH_LIMITS": "patches=7", "PYTHONPATH": str(PROGRAM.parent / "python")},
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert "132 patches" in done.stdout and "GRADMESH_LIMITS=patches=132" in done.stdout
