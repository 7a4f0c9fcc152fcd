// The list of bodies, joints and force elements: found by name, shown or hidden, picked.

const ROWS = 200; // of a kind; more are found by their names

export class Objects {
  /** `picked(kind, index)` is called for what was clicked; `world` may be missing. */
  constructor(element, run, world, picked) {
    Object.assign(this, { element, run, world, picked });
    element.innerHTML = `<summary>Bodies and joints</summary>
      <input class="object filter" type="search" placeholder="find by name or kind" aria-label="find by name or kind" autocomplete="off" spellcheck="false">
      <div class="rows"></div>`;
    this.part = (name) => element.querySelector(`.${name}`);
    this.part("filter").addEventListener("input", () => this.#fill());
    this.part("rows").addEventListener("click", (event) => this.#clicked(event));
    element.addEventListener("toggle", () => this.#fill());
    this.#fill();
  }

  #fill() {
    if (!this.element.open) return;
    const { run } = this;
    const words = this.part("filter").value.toLowerCase().trim();
    const groups = [
      ["body", "Bodies", run.bodies.names, (i) => `${figureOf(run.masses[i])} kg`],
      ["joint", "Joints", run.joints.names, (i) => run.joints.kinds[i].replaceAll("_", " ")],
      ["force", "Force elements", run.forces.names, (i) => run.forces.kinds[i].replaceAll("_", " ")],
    ];
    this.part("rows").replaceChildren(...groups.flatMap(([kind, title, names, detail]) => this.#group(kind, title, names, detail, words)));
  }

  #group(kind, title, names, detail, words) {
    if (!names.length) return [];
    const found = [];
    let count = 0;
    for (let i = 0; i < names.length; i++) {
      if (words && !names[i].toLowerCase().includes(words) && !detail(i).toLowerCase().includes(words)) continue;
      count += 1;
      if (found.length < ROWS) found.push(this.#row(kind, i, names[i], detail(i)));
    }
    const head = document.createElement("h2");
    head.textContent = count > found.length ? `${title}: ${found.length} of ${count}` : `${title}: ${count}`;
    return [head, ...found];
  }

  #row(kind, index, name, detail) {
    const row = document.createElement("div");
    row.className = "row";
    Object.assign(row.dataset, { kind, index });
    const loose = kind === "joint" ? this.run.looseJoints.get(index) : undefined;
    row.innerHTML = `<input type="checkbox" title="Show" aria-label="show"><button class="name"></button><small></small>`;
    const [box, button, small] = row.children;
    box.checked = !this.world?.hidden[kind].has(index);
    button.textContent = name;
    small.textContent = loose ?? detail;
    row.classList.toggle("loose", loose !== undefined);
    row.classList.toggle("picked", this.world?.selected?.kind === kind && this.world.selected.index === index);
    return row;
  }

  #clicked(event) {
    const row = event.target.closest(".row");
    if (!row) return;
    const kind = row.dataset.kind;
    const index = Number(row.dataset.index);
    if (event.target.matches("input")) this.world?.hide(kind, index, !event.target.checked);
    else if (event.target.matches("button")) this.picked(kind, index);
  }

  /** What is picked has changed. */
  mark() {
    const selected = this.world?.selected;
    for (const row of this.element.querySelectorAll(".row")) {
      row.classList.toggle("picked", selected?.kind === row.dataset.kind && selected.index === Number(row.dataset.index));
    }
  }
}

function figureOf(x) {
  return String(Number(x.toPrecision(4)));
}
