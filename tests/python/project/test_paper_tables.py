"""scripts/paper_tables, on meshes of our own under the names of the authors' files."""

import json

from built import script
from hemesh_files import grid

METHODS = ["random", "grid", "dual-grid", "motorcycle", "gqe", "gqe1", "best"]


def test_every_table_is_run_on_the_meshes_present(tmp_path):
    # Exact parts of one patch, which gqe puts together again.
    for name in ("teardrop", "banana"):
        (tmp_path / f"{name}.hemesh").write_text(grid(3, 3))
    out, data = tmp_path / "tables.md", tmp_path / "tables.json"
    quick = ["--iterations", 2, "--resolution", 64]
    note = ["--note", "Others were at work."]
    done = script("paper_tables", "--meshes", tmp_path, *quick, *note, "-o", out, "--json", data)
    assert done.returncode == 0, done.stderr
    assert "Watermelon is not there and left out" in done.stderr

    tables = json.loads(data.read_text())["tables"]
    assert list(tables) == ["2", "3", "4", "D.6"]
    (banana,) = tables["2"]["rows"]
    assert list(banana["ours"]) == METHODS
    assert banana["ours"]["gqe"]["patches"] == 1
    assert banana["paper"]["gqe"] == {"patches": 53, "error": 0.00484, "seconds": 862.8}
    assert [row["metric"] for row in tables["4"]["rows"]] == ["ssim", "flip"]
    assert [row["ours"][-1]["patches"] for row in tables["4"]["rows"]] == [1, 1]
    assert [row["mesh"] for row in tables["D.6"]["rows"]] == ["Raindrop", "Banana"]

    for row in tables["4"]["rows"]:
        assert all(b["patches"] <= o["patches"] for b, o in zip(row["best"], row["ours"], strict=True))

    text = out.read_text()
    assert "best leaves 0% fewer patches than gqe in the median, both together" in text
    assert "in 14 of 14 places" in text
    assert "- Not among the meshes at hand, and left out: Perfect6, Perturbed6, Watermelon, Duck" in text
    assert "\n- Others were at work." in text
    assert "| Banana | patches left | " in text and " 1 / 53 |" in text


def test_a_folder_that_is_not_there_is_named(tmp_path):
    done = script("paper_tables", "--meshes", tmp_path / "nowhere")
    assert done.returncode == 1
    assert done.stderr == f"{tmp_path / 'nowhere'}: there is no such folder.\n"
