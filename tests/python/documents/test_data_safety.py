"""Nothing is lost: files are whole or untouched, and what is not the mesh comes back as it was."""

import os
import random
import resource
import shutil
import signal
import subprocess
import time

import pytest
from lxml import etree

from built import PROGRAM, SAMPLES, gradmesh
from lattices import gradient
from program import printed

FRUIT = SAMPLES / "fruit.svg"
QUICK = ("--resolution", "64", "--method", "gqe")
EMBEDDED = '<image id="photo" width="9" height="9" href="data:image/png;base64,{}"/>'


def with_photo(megabytes):
    """The fruit with a photo in it, so large that writing takes a while."""
    text = FRUIT.read_text()
    defs = text.index("<defs")
    return text[:defs] + EMBEDDED.format("A" * (megabytes << 20)) + text[defs:]


def limited(what, value):
    """To be called in a child: a limit that signals no more than an error."""

    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(what, (value, value))

    return limit


def leftovers(document):
    """What else lies in the folder of a document."""
    return [path.name for path in document.parent.iterdir() if path != document]


def expect_untouched(done, document, before, reason):
    """A run that ends in a sentence with the document's name and the reason, and in nothing else."""
    assert (done.returncode, done.stdout) == (1, "")
    assert str(document) in done.stderr and reason in done.stderr and done.stderr.count("\n") == 1
    assert document.read_bytes() == before and leftovers(document) == []


@pytest.mark.parametrize("times", [40, pytest.param(200, marks=pytest.mark.long)])
@pytest.mark.full
def test_a_program_killed_at_any_moment_leaves_the_file_whole(tmp_path, times):
    document, arguments = tmp_path / "drawing.svg", [PROGRAM, "simplify"]
    before = with_photo(8).encode()
    document.write_bytes(before)
    arguments += [document, "-o", document, *QUICK, "--quiet"]
    start = time.monotonic()
    subprocess.run(list(map(str, arguments)), check=True)
    usual = time.monotonic() - start
    after = document.read_bytes()
    assert after != before

    moments = random.Random(1)
    killed = finished = 0
    for i in range(times):
        document.write_bytes(before)
        with subprocess.Popen(list(map(str, arguments))) as child:
            # On a machine that has become busy since, none would get to its end by itself.
            if i % 8 == 0:
                child.wait()
            else:
                time.sleep(moments.uniform(0, 1.2 * usual))
            child.kill()
        killed += child.returncode == -signal.SIGKILL
        found = document.read_bytes()
        finished += found == after
        assert found in (before, after)
    assert killed > times / 4 and finished > 0
    # What a killed program was writing has a name of its own.
    assert all(name.startswith(".gradmesh-") for name in leftovers(document))


@pytest.mark.parametrize("room", [0, 1000, 100_000])
def test_a_full_disk(tmp_path, room):
    document = tmp_path / "drawing.svg"
    document.write_text(with_photo(1))
    before = document.read_bytes()
    full = limited(resource.RLIMIT_FSIZE, room)
    done = gradmesh("simplify", document, "-o", document, *QUICK, preexec_fn=full)
    expect_untouched(done, document, before, "cannot be written")


@pytest.mark.skipif(not shutil.which("setpriv"), reason="setpriv is not installed")
def test_a_folder_that_cannot_be_written_to(tmp_path):
    folder = tmp_path / "shelf"
    folder.mkdir()
    document = folder / "drawing.svg"
    shutil.copy(FRUIT, document)
    before = document.read_bytes()
    folder.chmod(0o555)
    # Root may write everywhere, unless it gives that up.
    humbly = ["setpriv", "--bounding-set=-dac_override"] if os.geteuid() == 0 else []
    try:
        command = [*humbly, PROGRAM, "simplify", document, "-o", document, *QUICK]
        done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    finally:
        folder.chmod(0o755)
    expect_untouched(done, document, before, "Permission denied")


def test_too_little_memory_ends_in_a_sentence(tmp_path):
    document = tmp_path / "drawing.svg"
    shutil.copy(FRUIT, document)
    before = document.read_bytes()
    endings = set()
    for megabytes in (*range(20, 120, 4), 4096):
        little = limited(resource.RLIMIT_AS, megabytes << 20)
        options = ("-o", tmp_path / "out.svg", *QUICK, "--threads", 1)
        try:
            done = gradmesh("simplify", document, *options, preexec_fn=little)
        except subprocess.TimeoutExpired:
            # oneTBB of 2022 waits for itself where it has no memory for what it would throw.
            assert megabytes < 64
            continue
        if "error while loading shared libraries" in done.stderr or done.returncode == 127:
            continue  # too little to start at all
        if done.returncode < 0 and gradmesh("--version", preexec_fn=little).returncode < 0:
            continue  # libraries that allocate as they are loaded ended it before its main()
        assert done.returncode in (0, 1), (megabytes, done)
        if done.returncode == 1:
            assert done.stderr.startswith("gradmesh: ") and done.stderr.count("\n") == 1, done.stderr
        endings.add(done.returncode)
        assert document.read_bytes() == before
    assert 0 in endings


STRANGE = """<?xml version="1.0" encoding="ISO-8859-1" standalone="no"?>
<!-- \u00fcber allem --><?strange instruction?>
<!DOCTYPE svg [<!ENTITY blue "#0000ff"><!ATTLIST rect note CDATA "x">]>
<svg xmlns="http://www.w3.org/2000/svg" xmlns:odd="urn:odd" xmlns:xlink="http://www.w3.org/1999/xlink"
     odd:order='single "quotes"'   width="200"
     height="200">
  <style><![CDATA[ rect > .a { fill: red } ]]></style><odd:thing z="1" a="2"><b xmlns=""/></odd:thing>
  <text xml:space="preserve">  &lt;kept&gt; &amp; &#13; \u00e4  <tspan>x</tspan> tail </text>
  <script>if (a &lt; b) { /* ]]&gt; */ }</script>
  <rect fill="&blue;" width="5" height="5"/>
{mesh}
  <g id="empty"></g><g/><!-- - -->
  <use xlink:href="#empty"
       x="1"/>
</svg>
<!-- behind -->
"""
MESH = f"""  <defs>{gradient([["#123456", "#345678"]] * 4)}</defs>
  <rect id="box" width="90" height="30" fill="url(#m)"/>"""


def without(tree, ids, keep):
    """The document as lxml writes it without these elements, nor others with ids not in `keep`."""
    for element in list(tree.getroot().iter("*")):
        name = element.get("id")
        if name is not None and (name in ids or name not in keep):
            parent, tail = element.getparent(), element.tail
            if parent is None:
                continue
            before = element.getprevious()
            parent.remove(element)
            if before is not None:
                before.tail = (before.tail or "") + (tail or "")
            else:
                parent.text = (parent.text or "") + (tail or "")
    return etree.tostring(tree, xml_declaration=True, encoding=tree.docinfo.encoding,
                          standalone=tree.docinfo.standalone)  # fmt: skip


def compare(before, after, gone):
    """Both documents without these elements, in bytes; new prefixes of namespaces on the root aside."""
    keep = ids_of(before)
    new = set(after.getroot().nsmap.items()) - set(before.getroot().nsmap.items())
    rest = without(after, gone, keep)
    for prefix, uri in new:
        rest = rest.replace(f' xmlns:{prefix}="{uri}"'.encode(), b"", 1)
    return without(before, gone, keep), rest


def read(path):
    parser = etree.XMLParser(resolve_entities=False, strip_cdata=False, load_dtd=False, huge_tree=True)
    return etree.parse(str(path), parser)


def ids_of(tree):
    return {element.get("id") for element in tree.getroot().iter("*")} - {None}


def test_all_that_is_not_the_mesh_comes_back_byte_for_byte(tmp_path):
    document, out = tmp_path / "strange.svg", tmp_path / "out.svg"
    document.write_bytes(STRANGE.replace("{mesh}", MESH).encode("ISO-8859-1"))
    printed("simplify", document, "-o", out, "--epsilon", 0.2)
    before, after = compare(read(document), read(out), {"box", "m"})
    assert b"odd:order" in before and b'"box"' not in before
    assert before == after


@pytest.mark.parametrize("sample, chosen", [("two", "cap"), ("fruit", "pear"), ("opacity", "bubble")])
@pytest.mark.full(all_but=1)
def test_other_meshes_come_back_byte_for_byte(tmp_path, sample, chosen):
    document, out = SAMPLES / f"{sample}.svg", tmp_path / "out.svg"
    printed("simplify", document, "-o", out, "--id", chosen, *QUICK)
    before, after = read(document), read(out)
    # With the object goes the gradient that only it used.
    first, second = compare(before, after, {chosen} | (ids_of(before) - ids_of(after)))
    assert first == second
