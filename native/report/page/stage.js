/** What a click within so many pixels of an edge or a point means it. */
const REACH = { point: 6, halfedge: 5 };

/** One picture with the outlines of a mesh over it, in which elements are pointed at. */
class Pane {
  constructor(figure, mesh, picture, width, height) {
    this.figure = figure;
    this.mesh = mesh;
    this.root = svg("svg", { role: "img", "aria-label": figure.textContent.trim() }, figure);
    svg("image", { href: picture, width, height }, this.root);
    const outlines = svg("g", { class: "outlines" }, this.root);
    const curves = mesh.allOutlines();
    svg("path", { d: curves, class: "casing" }, outlines);
    svg("path", { d: curves, class: "line" }, outlines);
    const junctions = mesh.lists.point.filter((p) => p.stem !== null);
    svg(
      "path",
      { d: junctions.map((p) => this.dot(mesh.place(p.id))).join(""), class: "junctions" },
      outlines,
    );
    this.marks = svg("g", { class: "marks" }, this.root);
    this.hover = svg("g", { class: "hover" }, this.root);
    this.patches = svg("g", { class: "patches" }, this.root);
    for (const f of mesh.lists.patch)
      svg("path", { d: mesh.outline(f.id), "data-id": f.id }, this.patches);
  }

  /** A path of no length, which a round cap makes a dot of the stroke's width. */
  dot([x, y]) {
    return `M${x},${y}h0`;
  }

  /** The place of a pointer in the picture, and how many of its pixels are one of the screen's. */
  locate(event) {
    const matrix = this.root.getScreenCTM();
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
    return { at: [at.x, at.y], pixel: 1 / matrix.a };
  }

  /** The element that a pointer means: a point, else an edge, else a patch. */
  pick(event) {
    const patch = event.target.dataset?.id;
    if (patch === undefined) return null;
    const { at, pixel } = this.locate(event);
    const closest = this.mesh
      .get("patch", Number(patch))
      .halfedges.map((h) => ({ h, away: this.mesh.distance(h, at) }))
      .reduce((a, b) => (a.away <= b.away ? a : b));
    const origins = this.mesh
      .get("patch", Number(patch))
      .halfedges.map((h) => this.mesh.get("halfedge", h).origin);
    for (const point of origins) {
      const [x, y] = this.mesh.place(point);
      if (Math.hypot(x - at[0], y - at[1]) < REACH.point * pixel)
        return { kind: "point", id: point };
    }
    if (closest.away < REACH.halfedge * pixel) return { kind: "halfedge", id: closest.h };
    return { kind: "patch", id: Number(patch) };
  }

  /** Draws an element into a group that is emptied first. */
  mark(group, element) {
    group.replaceChildren();
    delete group.dataset.element;
    if (!element) return;
    const { kind, id } = element;
    const { mesh } = this;
    if (kind === "patch") svg("path", { d: mesh.outline(id), class: "area" }, group);
    if (kind === "point") svg("path", { d: this.dot(mesh.place(id)), class: "spot" }, group);
    if (kind === "halfedge") {
      svg("path", { d: mesh.path(id), class: "edge-casing" }, group);
      svg("path", { d: mesh.path(id), class: "edge" }, group);
      svg("path", { d: this.dot(mesh.at(id, 0)), class: "spot" }, group);
    }
    if (kind === "handle") {
      const [x0, y0, x1, y1] = mesh.handles.get(id).line;
      svg("path", { d: `M${x0},${y0}L${x1},${y1}`, class: "edge-casing" }, group);
      svg("path", { d: `M${x0},${y0}L${x1},${y1}`, class: "edge" }, group);
      svg("path", { d: this.dot([x1, y1]), class: "spot" }, group);
    }
    group.dataset.element = `${kind}/${id}`;
  }

  /** The selected element, and a region around it where one is shown. */
  select(element, region) {
    this.mark(this.marks, element);
    if (!region) return;
    const areas = svg("path", {
      d: region.faces.map((f) => this.mesh.outline(f)).join(""),
      class: "region",
    });
    this.marks.prepend(areas, svg("path", { d: this.mesh.border(region), class: "region-border" }));
  }
}

/** The panes together: which are seen, and which part of the picture. */
class Stage {
  constructor(data, meshes, { onPick, onHover }) {
    this.size = [data.width, data.height];
    this.box = document.getElementById("panes");
    this.box.style.setProperty("--aspect", data.width / data.height);
    this.onPick = onPick;
    this.onHover = onHover;
    const pictures = {
      before: data.before.picture,
      after: data.after.picture,
      errors: data.errors.picture,
    };
    this.panes = Object.fromEntries(
      [...this.box.querySelectorAll(".pane")].map((figure) => {
        const { side } = figure.dataset;
        return [side, new Pane(figure, meshes[side] ?? meshes.after, pictures[side], ...this.size)];
      }),
    );
    for (const pane of Object.values(this.panes)) this.listen(pane);
    this.setUpControls();
    this.setUpDivider();
    this.show("side");
    this.fit();
  }

  show(view) {
    this.box.dataset.view = view;
    document.getElementById("legend").hidden = view !== "errors";
    for (const button of document.querySelectorAll("#views button"))
      button.setAttribute("aria-pressed", button.dataset.view === view);
  }

  /** All panes of a mesh; the error map lies over the mesh after. */
  of(side) {
    return Object.values(this.panes).filter((pane) => pane.mesh.side === side);
  }

  // --- the part that is seen ---

  fit() {
    this.part = { x: 0, y: 0, zoom: 1 };
    this.update();
  }

  update() {
    const [width, height] = this.size,
      { part } = this;
    const w = width / part.zoom,
      h = height / part.zoom;
    part.x = Math.min(width - w, Math.max(0, part.x));
    part.y = Math.min(height - h, Math.max(0, part.y));
    for (const pane of Object.values(this.panes))
      pane.root.setAttribute("viewBox", `${part.x} ${part.y} ${w} ${h}`);
    this.box.classList.toggle("zoomed", part.zoom > 1);
    document.getElementById("zoom-fit").textContent = `${Math.round(100 * part.zoom)} %`;
  }

  /** Enlarges around a place of the picture, which stays where it is; the middle by default. */
  zoom(factor, at = null) {
    const [width, height] = this.size,
      { part } = this;
    const zoom = Math.min(32, Math.max(1, part.zoom * factor));
    const [x, y] = at ?? [part.x + width / part.zoom / 2, part.y + height / part.zoom / 2];
    part.x = x - ((x - part.x) * part.zoom) / zoom;
    part.y = y - ((y - part.y) * part.zoom) / zoom;
    part.zoom = zoom;
    this.update();
  }

  /** Brings a place of the picture into the middle, enlarged. */
  lookAt({ x, y }) {
    const [width, height] = this.size,
      zoom = Math.min(32, Math.max(1, Math.max(width, height) / 80));
    this.part = { x: x - width / zoom / 2, y: y - height / zoom / 2, zoom };
    this.update();
  }

  setUpControls() {
    const on = (id, action) => document.getElementById(id).addEventListener("click", action);
    on("zoom-in", () => this.zoom(1.5));
    on("zoom-out", () => this.zoom(1 / 1.5));
    on("zoom-fit", () => this.fit());
    for (const button of document.querySelectorAll("#views button"))
      button.addEventListener("click", () => this.show(button.dataset.view));
    document
      .getElementById("outlines")
      .addEventListener("change", (event) =>
        this.box.classList.toggle("bare", !event.target.checked),
      );
  }

  // --- pointing ---

  listen(pane) {
    const { root } = pane;
    let drag = null;
    root.addEventListener("pointerdown", (event) => {
      drag = { x: event.clientX, y: event.clientY, moved: false };
    });
    root.addEventListener("pointermove", (event) => {
      if (drag && event.buttons) {
        const dx = event.clientX - drag.x,
          dy = event.clientY - drag.y;
        if (!drag.moved && Math.hypot(dx, dy) < 4) return;
        if (!drag.moved) root.setPointerCapture(event.pointerId);
        const { pixel } = pane.locate(event);
        this.part.x -= dx * pixel;
        this.part.y -= dy * pixel;
        drag = { x: event.clientX, y: event.clientY, moved: true };
        this.update();
      } else {
        this.onHover(pane.mesh.side, pane.pick(event));
      }
    });
    root.addEventListener("pointerleave", () => this.onHover(pane.mesh.side, null));
    root.addEventListener("click", (event) => {
      const dragged = drag?.moved;
      drag = null;
      if (!dragged) this.onPick(pane.mesh.side, pane.pick(event));
    });
    root.addEventListener("dblclick", (event) =>
      this.zoom(event.shiftKey ? 0.5 : 2, pane.locate(event).at),
    );
    root.addEventListener(
      "wheel",
      (event) => {
        if (!event.ctrlKey && !event.metaKey) return;
        event.preventDefault();
        this.zoom(Math.exp(-0.004 * event.deltaY), pane.locate(event).at);
      },
      { passive: false },
    );
  }

  setUpDivider() {
    const divider = document.getElementById("divider");
    const move = (share) => {
      const at = Math.min(100, Math.max(0, share));
      this.box.style.setProperty("--at", `${at}%`);
      divider.setAttribute("aria-valuenow", Math.round(at));
    };
    const follow = (event) => {
      const box = this.box.getBoundingClientRect();
      move((100 * (event.clientX - box.left)) / box.width);
    };
    divider.addEventListener("pointerdown", (event) => {
      divider.setPointerCapture(event.pointerId);
      event.preventDefault();
      divider.focus();
    });
    divider.addEventListener("pointermove", (event) => {
      if (divider.hasPointerCapture(event.pointerId)) follow(event);
    });
    divider.addEventListener("keydown", (event) => {
      const now = Number(divider.getAttribute("aria-valuenow"));
      const step = {
        ArrowLeft: -2,
        ArrowRight: 2,
        PageDown: -10,
        PageUp: 10,
        Home: -100,
        End: 100,
      }[event.key];
      if (step === undefined) return;
      event.preventDefault();
      move(now + step);
    });
    move(50);
  }
}
