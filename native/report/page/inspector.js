const NAMES = { patch: "Patch", halfedge: "Half-edge", point: "Point", handle: "Handle" };

/** The entries of Eq. 3, row by row, as the paper names them. */
const HERMITE = "m0 m0v m2v m2 m0u m0uv m2uv m2u m1u m1uv m3uv m3u m1 m1v m3v m3".split(" ");

/** Lists the elements of a mesh and tells what there is to know about the selected one (B.1). */
class Inspector {
  constructor({ onSelect, onRegion, onHover }) {
    this.onSelect = onSelect;
    this.onRegion = onRegion;
    this.list = document.getElementById("list");
    this.details = document.getElementById("details");
    this.matrix = "position";
    this.kind = null;
    this.list.addEventListener("click", (event) => {
      const row = event.target.closest("li");
      if (row) onSelect({ kind: this.kind, id: Number(row.dataset.id) });
    });
    this.list.addEventListener("pointerover", (event) => {
      const row = event.target.closest("li");
      onHover(row ? { kind: this.kind, id: Number(row.dataset.id) } : null);
    });
    this.list.addEventListener("pointerleave", () => onHover(null));
    this.list.addEventListener("keydown", (event) => this.walk(event));
    this.tabs = [...document.querySelectorAll("#tabs button")];
    for (const [i, tab] of this.tabs.entries()) {
      tab.addEventListener("click", () => this.open(tab.dataset.kind));
      tab.addEventListener("keydown", (event) => {
        const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
        const next = step && this.tabs[(i + step + this.tabs.length) % this.tabs.length];
        next?.click();
        next?.focus();
      });
    }
  }

  show(mesh, element, region) {
    const other = mesh !== this.mesh;
    this.mesh = mesh;
    this.element = element;
    if (other || element.kind !== this.kind) this.open(element.kind);
    for (const row of this.list.querySelectorAll("[aria-selected=true]"))
      row.removeAttribute("aria-selected");
    const row = this.list.querySelector(`[data-id="${element.id}"]`);
    row?.setAttribute("aria-selected", true);
    if (row) this.list.setAttribute("aria-activedescendant", row.id);
    if (row) this.list.scrollTop = Math.max(0, row.offsetTop - this.list.clientHeight / 2);
    this.tell(region);
  }

  // --- the lists ---

  open(kind) {
    this.kind = kind;
    for (const tab of this.tabs) {
      const { kind: its } = tab.dataset;
      tab.setAttribute("aria-selected", its === kind);
      tab.tabIndex = its === kind ? 0 : -1;
      tab.replaceChildren(
        `${{ patch: "Patches" }[its] ?? `${NAMES[its]}s`} `,
        make("span", { class: "count" }, this.mesh.lists[its].length),
      );
    }
    this.list.setAttribute("aria-label", `${NAMES[kind]} list`);
    const { kind: selected, id } = this.element;
    this.list.replaceChildren(
      ...this.mesh.lists[kind].map((e) =>
        make(
          "li",
          {
            role: "option",
            id: `row-${e.id}`,
            "data-id": e.id,
            "aria-selected": selected === kind && e.id === id,
          },
          make("b", {}, e.id),
          make("span", {}, ...this.summary(kind, e)),
        ),
      ),
    );
  }

  summary(kind, e) {
    const mesh = this.mesh;
    if (kind === "patch") {
      const corners = e.halfedges.map((h) => swatch(mesh.get("halfedge", h).color));
      const { length } = mesh.regions.get(e.id);
      return mesh.side === "before"
        ? [...corners, length === 1 ? " 1 region" : ` ${length} regions`]
        : corners;
    }
    if (kind === "point") return [list(e.position) + (e.stem === null ? "" : " \u00b7 T-junction")];
    if (kind === "handle") return [list(e.tangent.slice(0, 2))];
    if (e.face === null) return [`parent of ${e.children.length} half-edges`];
    return [`patch ${e.face}` + (e.parent === null ? "" : `, child of ${e.parent}`)];
  }

  walk(event) {
    const step = {
      ArrowDown: 1,
      ArrowUp: -1,
      PageDown: 10,
      PageUp: -10,
      Home: -Infinity,
      End: Infinity,
    }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    const rows = this.mesh.lists[this.kind];
    const now =
      this.element.kind === this.kind ? rows.findIndex((e) => e.id === this.element.id) : -1;
    const next = Math.min(rows.length - 1, Math.max(0, now + step));
    this.onSelect({ kind: this.kind, id: rows[next].id });
  }

  // --- one element ---

  tell(region) {
    const { kind, id } = this.element;
    const e = this.mesh.get(kind, id);
    const parts = {
      patch: this.patch,
      halfedge: this.halfedge,
      point: this.point,
      handle: this.handle,
    }[kind];
    const { activeElement } = document;
    const used = this.details.contains(activeElement) ? activeElement.dataset.action : undefined;
    const children = parts.call(this, e, region).filter((child) => child !== null);
    this.details.replaceChildren(make("h2", {}, `${NAMES[kind]} ${id}`), ...children);
    // Who walks by keyboard stays on the button.
    if (used) (this.details.querySelector(`[data-action="${used}"]:enabled`) ?? this.list).focus();
  }

  /** A button that leads to another element, or says that there is none. */
  link(label, kind, id) {
    const none = id === null || id === undefined;
    return make(
      "button",
      {
        type: "button",
        class: "link",
        disabled: none,
        "data-action": label,
        onclick: () => this.onSelect({ kind, id }),
      },
      make("small", {}, label),
      none ? "none" : `${NAMES[kind]} ${id}`,
    );
  }

  links(...buttons) {
    return make("div", { class: "links" }, ...buttons);
  }

  patch(e, region) {
    const names = ["top", "right", "bottom", "left"];
    return [
      this.links(...e.halfedges.map((h, k) => this.link(names[k], "halfedge", h))),
      ...this.regionWalk(e, region),
      ...this.hermite(e),
    ];
  }

  regionWalk(e, region) {
    const title = make("h3", {}, "Regions around it");
    if (this.mesh.side === "after")
      return [title, quiet("They were worked out for the mesh before.")];
    const regions = this.mesh.regions.get(e.id);
    if (!regions.length)
      return [title, quiet("No region that can be merged within the error holds this patch.")];
    const text = make("div", { id: "region" });
    const range = make("input", {
      type: "range",
      min: 1,
      max: regions.length,
      "aria-label": "Region, by size",
      oninput: () => show(Number(range.value) - 1),
    });
    const tell = (i) => {
      const { rows, columns, error, fitted, faces } = regions[i];
      const size = faces.length === rows * columns ? `${rows} \u00d7 ${columns}` : faces.length;
      text.replaceChildren(
        make("b", {}, `${size} patches`),
        make("span", {}, `error ${short(error, 3)}`),
        fitted === null ? "" : make("span", {}, `fitted ${short(fitted, 3)}`),
        make("small", { class: "quiet" }, `${i + 1} of ${regions.length}`),
      );
      range.value = i + 1;
    };
    const show = (i) => {
      tell(i);
      this.onRegion(i);
    };
    const step = (by, label, name) =>
      make(
        "button",
        {
          type: "button",
          "data-action": name,
          "aria-label": `${name} region`,
          title: `${name} region`,
          onclick: () => show((Number(range.value) - 1 + by + regions.length) % regions.length),
        },
        label,
      );
    tell(region);
    return [
      title,
      make(
        "div",
        { class: "walk" },
        step(-1, "\u2039", "Previous"),
        text,
        step(1, "\u203a", "Next"),
        regions.length > 2 ? range : null,
      ),
    ];
  }

  hermite(e) {
    const values = this.mesh.hermite.get(e.id);
    const choice = ["position", "colour"].map((what) =>
      make(
        "button",
        {
          type: "button",
          "aria-pressed": this.matrix === what,
          onclick: () => {
            this.matrix = what;
            table.replaceWith((table = this.hermiteTable(values)));
            for (const button of choice)
              button.setAttribute("aria-pressed", button.textContent === what);
          },
        },
        what,
      ),
    );
    let table = this.hermiteTable(values);
    return [
      make(
        "div",
        { class: "bar" },
        make("h3", {}, "Hermite control matrix"),
        make(
          "div",
          { class: "choice", role: "group", "aria-label": "Part of the matrix" },
          ...choice,
        ),
      ),
      table,
    ];
  }

  hermiteTable(values) {
    const cell = (i) => {
      const base = HERMITE[i].slice(0, 2),
        derived = HERMITE[i].slice(2);
      const numbers = this.matrix === "position" ? values[i].slice(0, 2) : values[i].slice(2, 5);
      const name = make("span", { class: "entry" }, base, make("sub", {}, derived));
      if (!derived) name.append(swatch(values[i].slice(2)));
      return make("td", {}, name, ...numbers.map((x) => make("span", {}, short(x, 4))));
    };
    const row = (i) => make("tr", {}, ...[0, 1, 2, 3].map((j) => cell(4 * i + j)));
    return make("table", { class: "hermite" }, make("tbody", {}, ...[0, 1, 2, 3].map(row)));
  }

  halfedge(e) {
    const price = this.mesh.merging.get(e.id);
    return [
      this.links(
        this.link("next", "halfedge", e.next),
        this.link("prev", "halfedge", e.prev),
        this.link("twin", "halfedge", e.twin),
        this.link("parent", "halfedge", e.parent),
        this.link("origin", "point", e.origin),
        this.link("patch", "patch", e.face),
      ),
      e.children.length ? make("h3", {}, "Children") : null,
      e.children.length
        ? this.links(
            ...e.children.map((id) =>
              this.link(this.mesh.get("halfedge", id).handles ? "stem" : "bar", "halfedge", id),
            ),
          )
        : null,
      this.facts({
        "Colour at its origin":
          e.color && make("span", {}, swatch(e.color), list(e.color.slice(0, 3), 3, " ")),
        "Spans of its parent": e.interval && list(e.interval, 4, " to "),
        "Merging it costs": typeof price === "number" ? short(price, 3) : null,
        "Cannot be merged": typeof price === "string" ? price : null,
      }),
      e.handles
        ? this.links(
            this.link("handle at start", "handle", e.handles[0]),
            this.link("handle at end", "handle", e.handles[1]),
          )
        : null,
    ];
  }

  point(e) {
    return [
      this.links(
        this.link("starts there", "halfedge", e.halfedge),
        this.link("stem", "halfedge", e.stem),
      ),
      this.facts({
        Position: list(e.position, 6),
        Kind: e.stem === null ? "control point" : "T-junction",
      }),
    ];
  }

  handle(e) {
    return [
      this.links(
        this.link("starts there", "halfedge", e.halfedge),
        this.link("curve", "halfedge", this.mesh.handles.get(e.id).curve),
      ),
      this.facts({
        Tangent: list(e.tangent.slice(0, 2), 6),
        "Of the colour": e.tangent.length > 2 ? list(e.tangent.slice(2, 5), 3) : null,
      }),
    ];
  }

  facts(entries) {
    const known = Object.entries(entries).filter(
      ([, value]) => value !== null && value !== undefined,
    );
    return make(
      "dl",
      { class: "facts" },
      ...known.flatMap(([name, value]) => [make("dt", {}, name), make("dd", {}, value)]),
    );
  }
}
