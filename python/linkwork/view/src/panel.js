// A plot of a recorded quantity over time, with a mark at the present time; a click in it seeks.

import uPlot from "uplot";

const COLORS = ["#4c78a8", "#e08a3c", "#5a9e6f", "#b279a2", "#c9a227"];

export class Panel {
  /** `player` has the runs, the time, and seek(time). */
  constructor(player, choice, remove) {
    this.player = player;
    this.element = document.createElement("section");
    this.element.className = "panel";
    this.element.innerHTML = `
      <header>
        <select class="quantity" aria-label="quantity"></select>
        <input class="object" aria-label="body or joint" autocomplete="off" spellcheck="false">
        <button class="remove" title="Remove this plot" aria-label="Remove this plot">×</button>
      </header>
      <div class="legend"></div>
      <div class="plot"></div>`;
    this.part = (name) => this.element.querySelector(`.${name}`);
    this.quantities = player.runs[0].quantities();
    for (const it of this.quantities) this.part("quantity").add(new Option(it.label, it.id));
    this.part("quantity").value = choice.id;
    this.part("quantity").addEventListener("change", () => this.choose(this.part("quantity").value));
    this.part("remove").addEventListener("click", () => remove(this));
    this.object = choice.object;
    new ResizeObserver(() => this.#resize()).observe(this.part("plot"));
    this.#replaceInput();
    this.choose(choice.id);
  }

  get quantity() {
    return this.quantities.find((it) => it.id === this.id);
  }

  /** The names that can be chosen: those of which the page has the series. */
  names(kind, every) {
    const [run] = this.player.runs;
    const names = run.names(kind);
    if (every || kind === "coordinate") return names;
    return (kind === "body" ? run.bodies : run.joints).plotted.map((index) => names[index]);
  }

  choose(id, object) {
    this.id = id;
    this.part("quantity").value = id;
    const { of, every } = this.quantity;
    const input = this.part("object");
    input.hidden = !of;
    if (of) {
      const names = this.names(of, every);
      this.object = [object, this.object].find((name) => names.includes(name)) ?? this.#usual(of, names);
      this.#offer(names);
      input.value = this.object ?? "";
    }
    this.draw();
  }

  /** Of bodies the one that moves most, of joints the one with the largest force. */
  #usual(of, names) {
    const run = this.player.runs[0];
    if (of === "coordinate") return names[0];
    if (of === "body") return run.bodies.names[run.movers(1)[0]] ?? names[0];
    const width = 3 * run.joints.plotted.length;
    const largest = run.joints.plotted.map(() => 0);
    for (let i = 0; i < run.force.length; i += 3) {
      const place = (i % width) / 3;
      largest[place] = Math.max(largest[place], Math.hypot(run.force[i], run.force[i + 1], run.force[i + 2]));
    }
    return names[largest.indexOf(Math.max(...largest))] ?? names[0];
  }

  /** A short list is a menu; a long one a field that completes. */
  #replaceInput() {
    const long = Math.max(this.player.runs[0].bodyCount, this.player.runs[0].jointCount) > 60;
    if (long) {
      const list = document.createElement("datalist");
      list.id = `names${Math.random().toString(36).slice(2)}`;
      this.element.append(list);
      this.part("object").setAttribute("list", list.id);
      this.list = list;
    } else {
      const select = document.createElement("select");
      select.className = "object";
      select.setAttribute("aria-label", "body or joint");
      this.part("object").replaceWith(select);
      this.list = select;
    }
    this.part("object").addEventListener("change", () => this.choose(this.id, this.part("object").value));
  }

  #offer(names) {
    this.list.replaceChildren(...names.map((name) => new Option(name, name)));
  }

  draw() {
    const { runs } = this.player;
    const { unit, log, of } = this.quantity;
    const tables = runs.map((run) => {
      const lines = this.player.visible(run) ? run.lines(this.quantity, this.object) : [];
      return { run, lines: lines.filter(([name, values]) => name !== "work of other forces" || values.some((x) => x !== 0)) };
    });
    this.lines = tables.flatMap(({ run, lines }, number) =>
      lines.map(([name, values], k) => ({ run, name, number, values: log ? values.map((x) => (Math.abs(x) > 0 ? Math.abs(x) : NaN)) : values, color: COLORS[k % COLORS.length] })),
    );
    const columns = tables.map(({ run, lines }, number) => [run.t, ...this.lines.filter((it) => it.number === number).map((it) => Array.from(it.values, (x) => (Number.isFinite(x) ? x : null)))]);
    this.data = columns.length > 1 ? uPlot.join(columns) : columns[0];
    const joint = of === "joint" ? runs[0].joints.names.indexOf(this.object) : -1;
    this.note = joint >= 0 && this.id !== "gap" && !runs[0].joints.unique[joint] ? "not unique: a share of least norm" : "";
    if (joint >= 0 && this.id === "gap" && !runs[0].joints.held[joint]) this.note = "this joint rolls, turns as a thread, or drives: no points or axes that could be apart";
    this.#legend();
    this.plot?.destroy();
    const style = getComputedStyle(this.element);
    const text = style.getPropertyValue("--muted");
    const grid = { stroke: style.getPropertyValue("--line"), width: 1 };
    const font = "11px system-ui, sans-serif";
    const axis = { stroke: text, grid, ticks: { ...grid, size: 4 }, font };
    const anything = this.lines.some((it) => it.values.some((x) => Number.isFinite(x)));
    this.plot = new uPlot(
      {
        width: this.part("plot").clientWidth || 320,
        height: this.part("plot").clientHeight || 140,
        padding: [8, 10, 0, 0],
        legend: { show: false },
        cursor: { y: false, points: { size: 5 }, drag: { x: true, y: false, setScale: true } },
        scales: { x: { time: false }, y: log && anything ? { distr: 3, range: () => this.#logRange() } : { range: () => this.#range() } },
        hooks: { setScale: [(plot, key) => key === "x" && this.#zoomed(plot)] },
        axes: [
          { ...axis, size: 24, gap: 2 },
          { ...axis, size: 58, gap: 3, ...(log && anything ? { splits: decades } : {}), values: (_, ticks) => ticks.map((x) => (x === null ? "" : figure(x, log))) },
        ],
        series: [{}, ...this.lines.map((it) => ({
          label: it.name, stroke: it.color, width: it.number ? 1.4 : 1.6, dash: it.number ? [5, 4] : undefined,
          pxAlign: 0, spanGaps: this.player.runs.length > 1, points: { show: false },
        }))],
      },
      this.data,
      this.part("plot"),
    );
    this.part("plot").dataset.unit = unit;
    this.#mark();
    this.follow(this.player.part);
    this.seek();
  }

  /** A part of the time is chosen in one plot: all show it. */
  #zoomed(plot) {
    const { min, max } = plot.scales.x;
    if (this.following || min === null || (this.player.part?.[0] === min && this.player.part?.[1] === max)) return;
    this.player.zoom(min, max);
  }

  /** Another plot shows this part of the time. */
  follow(part) {
    if (!part || (this.plot.scales.x.min === part[0] && this.plot.scales.x.max === part[1])) return;
    this.following = true;
    this.plot.batch(() => this.plot.setScale("x", { min: part[0], max: part[1] }));
    this.following = false;
    this.seek();
  }

  /** Values that count for the axis: not those of a run that failed, where another did not. */
  #counted() {
    const good = this.lines.filter((it) => it.run.finished);
    const lines = good.length ? good : this.lines;
    const { min, max } = this.plot?.scales.x ?? {};
    const [from, to] = [min ?? -Infinity, max ?? Infinity]; // null before the first picture
    const values = [];
    for (const { run, values: all } of lines) {
      for (let k = 0; k < all.length; k++) {
        if (Number.isFinite(all[k]) && !(run.t[k] < from) && !(run.t[k] > to)) values.push(all[k]);
      }
    }
    values.sort((a, b) => a - b);
    return { values, failed: !good.length };
  }

  #range() {
    const { values, failed } = this.#counted();
    if (!values.length) return [0, 1];
    let [low, high] = [values[0], values.at(-1)];
    const at = (part) => values[Math.round(part * (values.length - 1))];
    const usual = at(0.95) - at(0.05);
    if (failed && usual > 0 && high - low > 100 * usual) [low, high] = [at(0.05) - 3 * usual, at(0.95) + 3 * usual]; // it blew up
    const floor = 1e-9 * Math.max(...this.player.runs.map((run) => run.largestOf(this.quantity)));
    return padded(low, high, floor);
  }

  #logRange() {
    const values = this.#counted().values.filter((x) => x > 0);
    if (!values.length) return [1e-16, 1];
    const low = Math.max(values[0], values[Math.floor(0.03 * values.length)] / 10); // one 1e-33 stretches nothing
    const high = values.at(-1);
    return [low / 1.5, high * 1.5];
  }

  /** The mark of the present time; a click beside it moves it there. */
  #mark() {
    const { over } = this.plot;
    this.mark = document.createElement("div");
    this.mark.className = "mark";
    over.append(this.mark);
    let pressed = null;
    over.addEventListener("mousedown", (event) => (pressed = event.clientX));
    over.addEventListener("mouseup", (event) => {
      if (pressed === null || Math.abs(event.clientX - pressed) > 3) return;
      this.player.seek(this.plot.posToVal(event.clientX - over.getBoundingClientRect().left, "x"));
    });
  }

  #legend() {
    const unit = this.quantity.unit;
    const note = this.note ? `<span class="warning">${this.note}</span>` : "";
    const key = (it) => `<span class="key"><i class="${it.number ? "second" : ""}" style="color:${it.color}"></i>${it.name} <b></b></span>`;
    const several = new Set(this.lines.map((it) => it.number)).size > 1;
    const groups = this.player.runs.map((run, number) => {
      const keys = this.lines.filter((it) => it.number === number).map(key).join("");
      return several ? `<div class="of-run"><em></em>${keys}</div>` : keys;
    });
    this.part("legend").innerHTML = `<span class="unit">${unit}</span>${groups.join("")}${note}`;
    this.part("legend").querySelectorAll("em").forEach((it, number) => (it.textContent = this.player.runs[number].short));
    this.values = [...this.part("legend").querySelectorAll("b")];
  }

  /** The time has changed. */
  seek() {
    const x = this.plot.valToPos(this.player.time, "x");
    const width = this.plot.over.clientWidth;
    this.mark.style.transform = `translateX(${x}px)`;
    this.mark.hidden = !(x >= -0.5 && x <= width + 0.5);
    const roundoff = 1e-12 * this.player.runs[0].largestOf(this.quantity);
    this.lines.forEach((it, k) => {
      const value = it.values[it.run.frame];
      this.values[k].textContent = figure(Math.abs(value) < roundoff ? 0 : value, this.quantity.log);
    });
  }

  #resize() {
    const { clientWidth: width, clientHeight: height } = this.part("plot");
    if (!this.plot || !width || !height) return;
    this.plot.setSize({ width, height });
    this.seek();
  }
}

/** The range of an axis: what is nearly constant, or all roundoff, is no line at full height. */
function padded(low, high, floor) {
  const middle = Math.abs(low + high) / 2;
  const half = Math.max((high - low) / 2, 1e-6 * middle, floor, 1e-300);
  return [(low + high) / 2 - 1.08 * half, (low + high) / 2 + 1.08 * half];
}

/** Powers of ten, not more than six. */
function decades(plot, axis, low, high) {
  const [first, last] = [Math.ceil(Math.log10(low) - 1e-9), Math.floor(Math.log10(high) + 1e-9)];
  const every = Math.max(1, Math.ceil((last - first) / 5));
  return Array.from({ length: Math.floor((last - first) / every) + 1 }, (_, k) => 10 ** (first + k * every));
}

/** A number in few characters. */
export function figure(x, short) {
  if (x === undefined || x === null || Number.isNaN(x)) return "–";
  if (x === 0) return "0";
  const size = Math.abs(x);
  if (size >= 1e5 || size < 1e-3) return x.toExponential(short ? 0 : 2).replace("e+", "e");
  return String(Number(x.toPrecision(4)));
}
