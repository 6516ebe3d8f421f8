"""Documents that ask for too much are refused with a sentence that says how to allow it."""

import os
import subprocess
import zlib

import pytest

import program
from bad_documents import DOCUMENT, linked
from built import PROGRAM, SAMPLES, gradmesh
from pdf_pages import pdf
from program import printed

FRUIT = SAMPLES / "fruit.svg"


def within(limits):
    return {"env": {"GRADMESH_LIMITS": limits}}


def refused(*arguments, words=(), limits=""):
    """A sentence that holds these words."""
    said = program.refused(*arguments, **within(limits))
    assert all(str(word) in said for word in words), said
    return said


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
        ("memory=1M", (FRUIT, "pear", "bytes", "the limit of 1048576")),
    ],
)
@pytest.mark.full(all_but=1)
def test_a_sentence_says_what_would_allow_it(tmp_path, limits, words):
    out = tmp_path / "out.svg"
    simplify = ("simplify", FRUIT, "-o", out, "--method", "grid")
    sentence = refused(*simplify, words=words, limits=limits)
    assert not out.exists()
    printed(*simplify, **within(allowed(sentence)))


def test_an_option_may_be_beyond_a_limit_too(tmp_path):
    done = gradmesh("simplify", FRUIT, "-o", tmp_path / "out.svg", **within("resolution=400"))
    assert done.returncode == 2 and "between 16 and 400" in done.stderr
    printed("render", FRUIT, "-o", tmp_path / "out.png", **within("resolution=700"))


def test_elements_inside_one_another(tmp_path):
    document = tmp_path / "deep.svg"
    document.write_text(nested(300))
    sentence = refused("info", document, words=(document, "301 elements lie inside one another"))
    printed("info", document, **within(allowed(sentence)))
    # Far more than any stack holds.
    document.write_text(nested(500_000))
    refused("info", document, words=(document, "500001 elements"))


def test_gradients_that_refer_to_one_another(tmp_path):
    document = tmp_path / "chain.svg"
    text = linked(*((f"m{i}" if i else "m", f"m{i + 1}") for i in range(40)))
    document.write_text(text.replace("</defs>", '<meshgradient id="m40"/></defs>'))
    simplify = ("simplify", document, "-o", tmp_path / "o.svg")
    sentence = refused(*simplify, words=(document, "41 gradients"))
    refused(*simplify, words=["meshrow"], limits=allowed(sentence))


def test_more_elements_than_memory_holds(tmp_path):
    document = tmp_path / "many.svg"
    document.write_text(FRUIT.read_text().replace("</svg>", "<g/>" * 100_000 + "</svg>"))
    sentence = refused("info", document, words=(document, "its elements take"), limits="memory=20M")
    printed("info", document, **within(allowed(sentence)))


def test_a_file_without_end():
    refused("info", "/dev/zero", words=("/dev/zero", "the limit of 1048576"), limits="document=1M")


def test_photos_in_a_document_are_no_reason_to_refuse_it(tmp_path):
    document = tmp_path / "photo.svg"
    photo = f'<image id="photo" href="data:image/png;base64,{"A" * (12 << 20)}"/></svg>'
    document.write_text(FRUIT.read_text().replace("</svg>", photo))
    printed("info", document)
    # But where a document declares entities, which may be built from one another, libxml2's limits hold.
    document.write_text("<!DOCTYPE svg [<!ENTITY a 'b'>]>" + photo.join(["<svg>", ""]))
    refused("info", document, words=[document])


def test_entities_that_grow_in_attributes(tmp_path):
    document = tmp_path / "bomb.svg"
    entities = "<!ENTITY a0 'lollollol'>" + "".join(
        f"<!ENTITY a{i + 1} '{f'&a{i};' * 10}'>" for i in range(12)
    )
    svg = DOCUMENT.format(defs="").replace("<rect", '<rect class="&a12;"', 1)
    document.write_text(f"<!DOCTYPE svg [{entities}]>{svg}")
    refused("info", document, words=[document], limits="memory=1G")


def test_the_setting_itself_may_be_wrong():
    assert '"patches=lots"' in program.refused("info", FRUIT, code=2, **within("patches=lots"))


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


@pytest.mark.parametrize("private", [b"%AI12_CompressedData" + zlib.compress(bytes(1000000)), b"%AI24_ZStandard_Data?"])
def test_a_page_is_read_without_what_illustrator_keeps_beside_it(tmp_path, private):
    page, out = tmp_path / "page.ai", tmp_path / "out.svg"
    page.write_bytes(pdf("/sh sh", private=private))
    done = gradmesh("convert", page, out, **within("document=100K"))
    if "was built without PDF" in done.stderr:
        pytest.skip(done.stderr.strip())
    assert (done.returncode, done.stderr) == (0, "")
    assert out.read_text().count("<meshpatch") == 1
