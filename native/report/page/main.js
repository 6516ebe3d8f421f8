const data = JSON.parse(document.getElementById("data").textContent);
const meshes = { before: new Mesh("before", data.before), after: new Mesh("after", data.after) };

/** What is selected in each mesh, and whose details are shown. */
const state = { side: "before", before: null, after: null, region: 0 };

function markSelection() {
  const { side } = state;
  const element = state[side];
  const region =
    element.kind === "patch" ? meshes[side].regions.get(element.id)[state.region] : null;
  for (const other of ["before", "after"])
    for (const pane of stage.of(other))
      pane.select(other === side ? element : null, other === side ? region : null);
}

function refresh() {
  const { side } = state;
  const element = state[side];
  markSelection();
  for (const button of document.querySelectorAll("#sides button"))
    button.setAttribute("aria-pressed", button.dataset.side === side);
  inspector.show(meshes[side], element, state.region);
  history.replaceState(null, "", `#${side}/${element.kind}/${element.id}`);
}

function select(side, element) {
  if (!element || !meshes[side].get(element.kind, element.id)) return;
  Object.assign(state, { side, [side]: element, region: 0 });
  refresh();
}

function hover(side, element) {
  for (const pane of stage.of(side)) pane.mark(pane.hover, element);
}

const stage = new Stage(data, meshes, { onPick: select, onHover: hover });
const inspector = new Inspector({
  onSelect: (element) => select(state.side, element),
  onHover: (element) => hover(state.side, element),
  onRegion: (region) => {
    state.region = region;
    markSelection();
  },
});

/** The address names an element: #before/patch/12. */
function follow(address) {
  const [, side, kind, id] = address.match(/^#(before|after)\/(\w+)\/(\d+)$/) ?? [];
  if (side) select(side, { kind, id: Number(id) });
}

// --- the page around them ---

function describePage() {
  const { before, after } = data;
  document.title = `${data.id}: ${before.handles} \u2192 ${after.handles} handles`;
  document.getElementById("title").textContent = data.id;
  document.getElementById("files").textContent = `${before.file} \u2192 ${after.file}`;
  const change = (name, key) => [
    make("dt", {}, name),
    make("dd", {}, `${before[key]} `, make("span", { class: "quiet" }, "\u2192"), ` ${after[key]}`),
  ];
  const less = Math.round(100 * (1 - after.handles / before.handles));
  document
    .getElementById("summary")
    .append(
      make(
        "div",
        {},
        ...change("Handles", "handles"),
        make("dd", { class: "quiet" }, less > 0 ? `${less} % fewer` : "none fewer"),
      ),
      make("div", {}, ...change("Patches", "patches")),
      make("div", {}, ...change("Objects", "objects")),
      make("div", {}, ...change("Points", "points")),
      make("div", {}, ...change("T-junctions", "t_junctions")),
      make(
        "div",
        {},
        make("dt", {}, "Error"),
        make("dd", { id: "error" }, short(data.error, 3)),
        make("dd", { class: "quiet" }, `${data.metric}, ${data.width} \u00d7 ${data.height} px`),
        make(
          "dd",
          { id: "local-error", class: "quiet" },
          `up to ${short(data.local_error, 3)} in 32 \u00d7 32 px`,
        ),
      ),
    );
  for (const side of ["before", "after"]) {
    const caption = stage.panes[side].figure.querySelector("figcaption");
    const { handles, patches } = data[side];
    caption.append(make("span", { class: "quiet" }, ` ${handles} handles, ${patches} patches`));
  }
}

const OPTION_NAMES = {
  method: "Method",
  color_model: "Colour model",
  metric: "Metric",
  epsilon: "Largest error (epsilon)",
  max_local_error: "Largest error in 32 \u00d7 32 px",
  max_detail_error: "Largest error in 4 \u00d7 4 px",
  resolution: "Resolution",
  seed: "Seed",
  omega: "Weight of size (omega)",
  kappa: "Costly edges from (kappa)",
  handles_before: "Handles before",
  handles_after: "Handles after",
  patches_before: "Patches before",
  patches_after: "Patches after",
  objects: "Objects after",
  error: "Error",
  local_error: "Error in 32 \u00d7 32 px, up to",
  detail_error: "Error in 4 \u00d7 4 px, up to",
  evaluations: "Merges measured",
  stopped: "Stopped",
};

function describeRun() {
  const { run } = data;
  const list = document.getElementById("options");
  const add = (name, value) =>
    list.append(make("div", {}, make("dt", {}, name), make("dd", {}, value)));
  if (!run) {
    list.replaceWith(
      quiet(
        "Not known. The option --run of gradmesh report takes the file that --report of " +
          "gradmesh simplify writes.",
      ),
    );
    return;
  }
  for (const [key, name] of Object.entries(OPTION_NAMES)) {
    const value = run[key];
    const matters = data.heeded_by[key]?.includes(run.method) ?? true;
    if (value != null && matters)
      add(name, typeof value === "number" ? short(value, 5) : String(value));
  }
  if (run.seconds?.total !== undefined) add("Time", `${short(run.seconds.total, 3)} s`);
  const share = fittedShare(data.before.regions);
  if (share !== undefined) add("Error of a region once fitted", `${short(share, 2)} of its price`);
}

/** How much of a region's error is left once it is fitted, in the median. */
function fittedShare(regions) {
  const shares = regions
    .filter(({ error, fitted }) => error > 0 && fitted !== null)
    .map(({ error, fitted }) => fitted / error)
    .sort((a, b) => a - b);
  return shares[Math.floor(shares.length / 2)];
}

function describeErrors() {
  const { largest, scale } = data.errors;
  const legend = document.getElementById("legend");
  const say = (text) => legend.append(quiet(text));
  if (largest === 0) {
    say("The pictures do not differ.");
    return;
  }
  const gradient = `background: linear-gradient(to right, ${scale.join(", ")})`;
  const tick = (t) => make("span", { style: `left:${100 * t}%` }, short(t * largest, 2));
  legend.append(
    make("div", { class: "scale", style: gradient }),
    make("div", { class: "ticks" }, ...[0, 0.25, 0.5, 0.75, 1].map(tick)),
  );
  say(`${data.metric} of each pixel; its mean is ${short(data.error, 3)}`);
}

/** Buttons that lead to where details differ most. */
function describeWorst() {
  const box = document.getElementById("worst");
  box.hidden = data.worst.length === 0;
  for (const place of data.worst) {
    const title = `${data.metric} of 4 \u00d7 4 px at (${place.x}, ${place.y})`;
    const onclick = () => stage.lookAt(place);
    box.append(make("button", { type: "button", title, onclick }, short(place.error, 2)));
  }
}

function shortcuts(event) {
  if (event.ctrlKey || event.metaKey || event.altKey || event.target.matches("input")) return;
  if (event.key === "+") stage.zoom(1.5);
  if (event.key === "-") stage.zoom(1 / 1.5);
  if (event.key === "0") stage.fit();
}

describePage();
describeRun();
describeErrors();
describeWorst();
for (const button of document.querySelectorAll("#sides button"))
  button.addEventListener("click", () => select(button.dataset.side, state[button.dataset.side]));
document.addEventListener("keydown", shortcuts);
window.addEventListener("hashchange", () => follow(location.hash));
const address = location.hash;
for (const side of ["after", "before"])
  select(side, { kind: "patch", id: meshes[side].lists.patch[0].id });
follow(address);
