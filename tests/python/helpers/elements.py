"""The elements that `info --json` lists of a mesh, and what holds between them."""

from program import meshes


def elements(path):
    """Those of a document's first mesh."""
    return meshes(path)[0]["elements"]


def by_id(elements):
    return {element["id"]: element for element in elements}


def check_elements(elements):
    """What every half-edge structure holds to, seen through the lists of `info --json`."""
    points, handles, faces, halfedges = (
        by_id(elements[kind]) for kind in ("points", "handles", "faces", "halfedges")
    )
    for point in points.values():
        assert halfedges[point["halfedge"]]["origin"] == point["id"]
        if point["stem"] is not None:
            assert halfedges[point["stem"]]["origin"] == point["id"]
    for face in faces.values():
        edge = face["halfedges"][0]
        for side in face["halfedges"]:
            assert side == edge and halfedges[side]["face"] == face["id"]
            edge = halfedges[edge]["next"]
        assert edge == face["halfedges"][0]
    for handle in handles.values():
        if handle["halfedge"] is not None:
            assert halfedges[handle["halfedge"]]["handles"][0] == handle["id"]
    for name, edge in halfedges.items():
        assert edge["origin"] in points
        if edge["next"] is not None:
            assert halfedges[edge["next"]]["prev"] == name
        if edge["twin"] is not None:
            twin = halfedges[edge["twin"]]
            assert twin["twin"] == name
            assert twin["handles"] == edge["handles"][::-1]
        for child in edge["children"]:
            assert halfedges[child]["parent"] == name
        if edge["parent"] is not None:
            assert name in halfedges[edge["parent"]]["children"]
            first, second = edge["interval"]
            assert 0 <= first <= second <= 1
            assert (edge["handles"] is None) == (first < second)
        assert (edge["color"] is None) == (edge["face"] is None) == bool(edge["children"])
