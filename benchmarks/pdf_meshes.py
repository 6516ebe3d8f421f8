"""What is read of the meshes of PDF documents, as rows of a Markdown table: patches and handles that the page has, the
grid that was found, and the handles before and after *Simplify* at Balanced.

    benchmarks/pdf_meshes.py GRADMESH FILE.pdf...
"""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path


def run(program, *arguments):
    return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)


def size(mesh):
    """The rows and columns of a mesh, and the kind of its colours."""
    found = mesh["found"]
    if not found["rows"]:
        return f"{mesh['patches']} patches, {mesh['objects']} objects"
    return f"{found['rows']} x {found['columns']}" + (", smooth" if found["smooth"] else "")


def rows(program, path):
    """The rows of a document: one for each mesh, or one that says why there is none."""
    name = "/".join(Path(path).parts[-2:])
    told = run(program, "info", path, "--json")
    if told.returncode:
        yield f"| {name} | {told.stderr.strip().split(': ', 2)[-1]} | | | | | |"
        return
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        run(program, "simplify", path, "-o", Path(folder) / "out.svg", "--amount", "balanced", "--report", report)
        after = {m["id"]: m["handles_after"] for m in json.loads(report.read_text())["meshes"] if "handles_after" in m}
    for mesh in json.loads(told.stdout)["meshes"]:
        found = mesh["found"]
        yield (
            f"| {name} {found['number']} | {found['patches']} | {found['handles']} | {size(mesh)} | {mesh['handles']} "
            f"| {after[mesh['id']]} | {found['difference']:.4f} |"
        )


def main():
    program, *files = sys.argv[1:]
    print("| file, mesh | patches on the page | handles | read as | handles | Balanced | FLIP |")
    print("|---|---|---|---|---|---|---|")
    for path in files:
        for row in rows(os.path.abspath(program), path):
            print(row, flush=True)


if __name__ == "__main__":
    main()
