/** A mesh of the page's data: its elements by kind and number, and their places in the picture. */
class Mesh {
  constructor(side, data) {
    this.side = side;
    this.data = data;
    const { faces, halfedges, points, handles } = data.elements;
    this.lists = { patch: faces, halfedge: halfedges, point: points, handle: handles };
    this.tables = Object.fromEntries(
      Object.entries(this.lists).map(([kind, list]) => [kind, new Map(list.map((e) => [e.id, e]))]),
    );
    this.curves = new Map(halfedges.map((h, i) => [h.id, data.curves[i]]));
    this.hermite = new Map(faces.map((f, i) => [f.id, data.hermite[i]]));
    this.merging = new Map(data.merging.map((price, i) => [halfedges[i].id, price]));
    this.handles = new Map();
    for (const h of halfedges) {
      const c = this.curves.get(h.id);
      const lines = [c.slice(0, 4), [...c.slice(6), c[4], c[5]]];
      h.handles?.forEach((id, end) => this.handles.set(id, { curve: h.id, line: lines[end] }));
    }
    this.regions = new Map(faces.map((f) => [f.id, []]));
    for (const region of data.regions)
      for (const f of region.faces) this.regions.get(f).push(region);
  }

  get(kind, id) {
    return this.tables[kind]?.get(id);
  }

  /** The half-edge, as an open path. */
  path(halfedge) {
    return "M" + this.curves.get(halfedge).slice(0, 2) + this.onwards(halfedge);
  }

  onwards(halfedge) {
    return "C" + this.curves.get(halfedge).slice(2);
  }

  outline(patch) {
    const sides = this.get("patch", patch).halfedges;
    return (
      "M" + this.curves.get(sides[0]).slice(0, 2) + sides.map((h) => this.onwards(h)).join("") + "Z"
    );
  }

  /** Every curve once. */
  allOutlines() {
    const whole = this.lists.halfedge.filter(
      (h) => h.handles && !(h.twin !== null && h.twin < h.id),
    );
    return whole.map((h) => this.path(h.id)).join("");
  }

  place(point) {
    return this.curves.get(this.get("point", point).halfedge).slice(0, 2);
  }

  /** The sides of a region's patches that have no patch of it across. */
  border(region) {
    const inside = new Set(region.faces);
    const across = (h) => this.get("halfedge", this.get("halfedge", h).twin)?.face;
    return region.faces
      .flatMap((f) => this.get("patch", f).halfedges)
      .filter((h) => !inside.has(across(h)))
      .map((h) => this.path(h))
      .join("");
  }

  /** Where a half-edge is at t in [0, 1]. */
  at(halfedge, t) {
    const c = this.curves.get(halfedge),
      s = 1 - t;
    const b = [s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t];
    return [0, 1].map((k) => b.reduce((sum, weight, i) => sum + weight * c[2 * i + k], 0));
  }

  /** How far a place is from a half-edge. */
  distance(halfedge, [x, y]) {
    const steps = 24;
    let least = Infinity;
    let a = this.at(halfedge, 0);
    for (let i = 1; i <= steps; ++i) {
      const b = this.at(halfedge, i / steps);
      const d = [b[0] - a[0], b[1] - a[1]],
        length = d[0] * d[0] + d[1] * d[1];
      const along = length ? ((x - a[0]) * d[0] + (y - a[1]) * d[1]) / length : 0;
      const t = Math.min(1, Math.max(0, along));
      least = Math.min(least, Math.hypot(x - a[0] - t * d[0], y - a[1] - t * d[1]));
      a = b;
    }
    return least;
  }
}
