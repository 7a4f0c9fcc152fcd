// The page: reads the runs in it, lays out the picture, the plots and the controls.

import "uplot/dist/uPlot.min.css";
import "./style.css";
import { Objects } from "./objects.js";
import { leftOut } from "./left_out.js";
import { Overlay } from "./overlay.js";
import { Panel, figure } from "./panel.js";
import { Player } from "./player.js";
import { Run, fetched, unpacked } from "./run.js";
import { GAP, World } from "./world.js";

const VIEWS = [["-y", "front: along y"], ["y", "back"], ["x", "right: against x"], ["-x", "left"], ["z", "top: against z"], ["-z", "bottom"]];
const BEHIND = { true: "frames are being read", false: "frames are being unpacked" };
const SECOND = { played: "first", overlaid: "second" };

async function main() {
  const descriptions = JSON.parse(document.getElementById("runs").textContent);
  const blocks = await Promise.all(descriptions.map((_, k) => unpacked(document.getElementById(`block${k}`).textContent.trim())));
  const inPage = (name) => unpacked(document.getElementById(name).textContent.trim());
  const runs = descriptions.map((it, k) => new Run(it, blocks[k], (number, signal) => (it.pieces.streamed ? fetched : inPage)(`poses${k}-${number}`, signal)));
  runs.forEach((run, k) => (run.short = run.label && run.label.length <= 24 ? run.label : k ? SECOND.overlaid : SECOND.played));
  await Promise.all(runs.map((run) => run.poses.ready()));
  new Page(document.getElementById("viewer"), runs);
}

class Page {
  constructor(root, runs) {
    this.root = root;
    this.runs = runs;
    this.player = new Player(runs);
    root.innerHTML = layout(runs);
    this.part = (name) => root.querySelector(`.${name}`);
    this.panels = [];
    try {
      this.world = new World(this.part("canvas"), runs);
    } catch (error) {
      this.part("scene").classList.add("blind");
      this.part("message").textContent = `No three-dimensional picture: ${error.message} Plots work.`;
    }
    this.#theme();
    this.#scene();
    this.#transport();
    this.#switches();
    this.#keys();
    this.#objects();
    if (!runs[0].still) this.#plots();
    this.player.listen(() => this.#seek());
    this.player.seek(this.player.start);
    this.world?.fit();
    // for scripts and tests
    window.linkwork = { ready: true, runs, player: this.player, world: this.world, panels: this.panels };
    document.documentElement.dataset.ready = "true";
  }

  #plots() {
    const { runs } = this;
    for (const id of ["energy", runs[0].jointCount ? "violation" : "velocity", "position"].slice(0, usualPanels())) this.#addPanel({ id });
    this.part("add").addEventListener("click", () => this.#addPanel({ id: runs[0].jointCount ? "force" : "velocity" }));
    this.player.zooms.push((part) => {
      for (const panel of this.panels) panel.follow(part);
    });
  }

  #objects() {
    this.objects = new Objects(this.part("objects"), this.runs[0], this.world, (kind, index) => this.#pick(kind, index));
    if (this.runs[0].still && window.innerWidth > 820) this.part("objects").open = true;
  }

  #pick(kind, index) {
    this.world?.select(kind, index);
    this.objects.mark();
  }

  // --- time ---

  #seek() {
    const { player } = this;
    this.world?.update();
    for (const panel of this.panels) panel.seek();
    const slider = this.part("slider");
    slider.value = player.time;
    slider.style.setProperty("--done", `${(100 * (player.time - player.start)) / (player.end - player.start || 1)}%`);
    slider.setAttribute("aria-valuetext", `${clock(player.time, player)} s`);
    this.part("clock").textContent = `${clock(player.time, player)} s`;
    const button = this.part("play");
    button.dataset.state = player.playing ? "pause" : "play";
    button.setAttribute("aria-label", player.playing ? "Pause" : "Play");
    const run = this.runs[0];
    const violation = run.jointCount && !run.still ? `violation ${figure(run.violation[run.frame])}` : "";
    const broken = this.runs.find((it) => it.poses.error);
    this.part("now").textContent = broken ? `frames cannot be read: ${broken.poses.error.message}` : player.behind ? BEHIND[Boolean(run.pieces?.streamed)] : violation;
  }

  #transport() {
    const { player } = this;
    const slider = this.part("slider");
    Object.assign(slider, { min: player.start, max: player.end, step: (player.end - player.start) / 5000 || 1 });
    slider.addEventListener("input", () => {
      const time = Number(slider.value); // before the pause, which moves the slider to the present time
      player.pause();
      player.seek(time);
    });
    this.part("play").addEventListener("click", () => player.toggle());
    const speed = this.part("speed");
    for (const it of player.speeds) speed.add(new Option(`${it}×`, it, it === player.speed, it === player.speed));
    speed.addEventListener("change", () => (player.speed = Number(speed.value)));
  }

  #keys() {
    const { player } = this;
    const run = this.runs[0];
    const keys = {
      " ": () => player.toggle(),
      ArrowLeft: (event) => player.step(event.shiftKey ? -Math.ceil(run.count / 20) : -1),
      ArrowRight: (event) => player.step(event.shiftKey ? Math.ceil(run.count / 20) : 1),
      Home: () => player.step(-run.count),
      End: () => player.step(run.count),
      f: () => this.world?.fit(),
    };
    document.addEventListener("keydown", (event) => {
      const { target } = event;
      const typing = target.matches?.("select, input:not([type=range]):not([type=checkbox])");
      const pressing = event.key === " " && target.matches?.("button, summary, input[type=checkbox]");
      if (typing || pressing || event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return;
      event.preventDefault();
      keys[event.key](event);
    });
  }

  // --- what is seen ---

  #scene() {
    const { world } = this;
    if (!world) return;
    const scene = this.part("scene");
    const canvas = this.part("canvas");
    new ResizeObserver(() => world.resize(scene.clientWidth, scene.clientHeight)).observe(scene);
    world.resize(scene.clientWidth, scene.clientHeight);
    const tip = this.part("tip");
    let pending = null;
    canvas.addEventListener("pointermove", (event) => {
      clearTimeout(pending);
      tip.hidden = true;
      if (event.buttons || this.player.playing) return;
      pending = setTimeout(() => {
        const found = world.under(event.offsetX, event.offsetY);
        if (!found) return;
        tip.textContent = found.detail ? `${found.name} (${found.detail})` : found.name;
        tip.style.transform = `translate(${event.offsetX + 12}px, ${event.offsetY + 14}px)`;
        tip.hidden = false;
      }, 60);
    });
    canvas.addEventListener("pointerleave", () => {
      clearTimeout(pending);
      tip.hidden = true;
    });
    canvas.addEventListener("dblclick", (event) => {
      const found = world.under(event.offsetX, event.offsetY);
      if (!found || found.run !== this.runs[0] || found.run.still || found.name === "ground" || found.kind === "force") return;
      const ids = found.kind === "body" ? ["position", "velocity", "omega", "orientation"] : ["force", "torque", "gap"];
      const panel = this.panels.find((it) => ids.includes(it.id));
      if (panel) panel.choose(panel.id, found.name);
      else this.#addPanel({ id: ids[0], object: found.name });
    });
    this.part("view").addEventListener("change", (event) => {
      world.look(event.target.value);
      event.target.value = "";
    });
    this.part("shot").addEventListener("click", () => this.#screenshot());
    this.overlay = new Overlay(this.part("overlay"), world, this.runs);
    world.rendered.push(() => this.#sayLeftOut());
    this.part("names-of").value = this.overlay.names;
    this.part("names-of").addEventListener("change", (event) => {
      this.overlay.names = event.target.value;
      world.changed();
    });
  }

  #sayLeftOut() {
    const text = leftOut(this.runs[0], this.world, this.overlay).join(" · ");
    const place = this.part("left-out");
    if (place.textContent !== text) place.textContent = text;
  }

  async #screenshot() {
    const url = URL.createObjectURL(await this.world.screenshot());
    const link = Object.assign(document.createElement("a"), { href: url, download: `${this.runs[0].model}.png` });
    link.click();
    URL.revokeObjectURL(url);
  }

  #switches() {
    const { world, player } = this;
    for (const box of this.root.querySelectorAll("input[data-show]")) {
      box.addEventListener("change", () => {
        if (box.dataset.show === "second") {
          player.secondShown = box.checked;
          for (const panel of this.panels) panel.draw();
        }
        if (world) {
          world.shown[box.dataset.show] = box.checked;
          world.update();
        }
      });
    }
    const legend = () => {
      this.part("arrow-key").hidden = !world || world.arrows === "none";
      if (world && world.arrows !== "none") this.part("longest").textContent = `longest: ${figure(world.largest(world.arrows))} ${world.arrows === "force" ? "N" : "N m"}`;
      this.part("gap-key").hidden = !world || world.coloring !== "gap";
    };
    this.part("arrows").addEventListener("change", (event) => {
      world.arrows = event.target.value;
      legend();
      world.update();
    });
    this.part("coloring").addEventListener("change", (event) => {
      world.coloring = event.target.value;
      legend();
      world.update();
    });
    document.addEventListener("click", (event) => {
      const menu = this.part("menu");
      if (!menu.contains(event.target)) menu.open = false;
    });
  }

  #theme() {
    const dark = window.matchMedia("(prefers-color-scheme: dark)");
    const apply = () => {
      const chosen = this.root.dataset.theme;
      document.documentElement.dataset.theme = chosen ?? (dark.matches ? "dark" : "light");
      const style = getComputedStyle(document.documentElement);
      const color = (name) => style.getPropertyValue(name).trim();
      this.world?.theme({
        scene: color("--scene"), grid: color("--grid"), gridStrong: color("--grid-strong"),
        dark: document.documentElement.dataset.theme === "dark",
      });
      for (const panel of this.panels) panel.draw();
    };
    dark.addEventListener("change", apply);
    this.part("theme").addEventListener("click", () => {
      this.root.dataset.theme = document.documentElement.dataset.theme === "dark" ? "light" : "dark";
      apply();
    });
    apply();
  }

  #addPanel(choice) {
    const place = document.createComment("panel");
    this.part("panels").append(place);
    const panel = new Panel(this.player, choice, (gone) => {
      this.panels.splice(this.panels.indexOf(gone), 1);
      gone.element.remove();
    });
    place.replaceWith(panel.element);
    this.panels.push(panel);
    panel.draw();
    panel.seek();
  }
}

function usualPanels() {
  return window.innerHeight > 560 ? 3 : 2;
}

function clock(time, player) {
  const digits = Math.min(Math.max(3 - Math.floor(Math.log10(player.end - player.start || 1)), 0), 9);
  return time.toFixed(digits);
}

function escaped(text) {
  const node = document.createElement("span");
  node.textContent = text;
  return node.innerHTML;
}

function layout(runs) {
  const [run] = runs;
  const two = runs.length > 1;
  const forces = run.forces.names.length;
  const counts = `${run.bodyCount} ${run.bodyCount === 1 ? "body" : "bodies"}, ${run.jointCount} ${run.jointCount === 1 ? "joint" : "joints"}${forces ? `, ${forces} force element${forces === 1 ? "" : "s"}` : ""}`;
  const { recorded, shown } = run.frames;
  const frames = recorded === shown ? `${recorded} frames` : `${shown} of ${recorded} frames`;
  const size = document.documentElement.outerHTML.length / 1e6;
  const where = run.pieces?.streamed ? "read as the time comes to them" : `${size.toFixed(2)} MB`;
  const loose = run.loose.length ? `<span class="loose">${run.loose.length} joint${run.loose.length > 1 ? "s" : ""} not held</span>` : "";
  const facts = run.still ? "the initial pose, as it is given" : `${frames} · positions to ${figure(run.precision)} m · ${where}`;
  const second = two
    ? `<div class="runs"><span><i></i>${escaped(run.label || SECOND.played)}</span><span><i class="second"></i>${escaped(runs[1].label || SECOND.overlaid)}</span></div>`
    : "";
  const models = two && runs[1].model !== run.model ? `${run.model} and ${runs[1].model}` : run.model;
  const gaps = GAP.colors.join(", ");
  return `
<header class="top">
  <div class="title"><h1>${escaped(models.replaceAll("_", " "))}</h1><p>${escaped(counts)}${run.method ? ` · ${escaped(run.method)}` : ""}${run.finished || run.still ? "" : ' · <em>not finished</em>'}</p></div>
  ${second}
  <div class="tools">
    <select class="view" aria-label="view" title="Look from (F: show everything)"><option value="" hidden>View</option><option value="fit">everything</option><option value="picked">what is picked</option>${VIEWS.map(([name, label]) => `<option value="${name}">${label}</option>`).join("")}</select>
    <button class="shot" title="Picture as PNG" aria-label="Picture as PNG"><svg viewBox="0 0 16 16" aria-hidden="true"><path d="M2 4.5h3l1.2-2h3.6l1.2 2h3v9H2zM8 6.2a2.9 2.9 0 1 0 0 5.8 2.9 2.9 0 0 0 0-5.8z"/></svg></button>
    <details class="menu"><summary>Show</summary>
      <div class="choices">
        <label><input type="checkbox" data-show="joints" checked> Joints</label>
        ${run.forces.names.length ? '<label><input type="checkbox" data-show="forces" checked> Springs, contacts</label>' : ""}
        ${run.still ? "" : '<label><input type="checkbox" data-show="paths" checked> Paths</label>'}
        <label><input type="checkbox" data-show="axes"${run.still ? " checked" : ""}> Axes of bodies</label>
        <label><input type="checkbox" data-show="grid" checked> Grid</label>
        ${two ? '<label><input type="checkbox" data-show="second" checked> Second run</label>' : ""}
        <label class="row">Names <select class="names-of"><option value="none">none</option><option value="bodies">bodies</option><option value="joints">joints</option><option value="all">all</option></select></label>
        ${run.still ? '<div hidden>' : ""}<label class="row">Reactions <select class="arrows"><option value="none">none</option><option value="force">forces</option><option value="torque">torques</option></select></label>
        <label class="row">Color of joints <select class="coloring"><option value="body">plain</option><option value="gap">violation</option></select></label>${run.still ? "</div>" : ""}
      </div>
    </details>
    <button class="theme" title="Light or dark" aria-label="Light or dark">◐</button>
  </div>
</header>
<section class="scene" aria-label="the mechanism">
  <canvas class="canvas"></canvas>
  <p class="message"></p>
  <div class="overlay"></div>
  <div class="tip" hidden></div>
  <div class="keys">
    <div class="left-out"></div>
    <div class="arrow-key" hidden><span><i class="unique"></i>follows from the motion</span><span><i class="shared"></i>not unique: a share of least norm</span><span class="longest"></span></div>
    <div class="gap-key" hidden>violation <span>1e${GAP.low}</span><i style="background:linear-gradient(90deg, ${gaps})"></i><span>1e${GAP.high} m; angles times ${figure(run.lever)} m</span></div>
  </div>
  <p class="facts"><span class="now"></span>${loose}<span>${escaped(facts)}</span></p>
</section>
<aside class="side"><div class="panels"${run.still ? " hidden" : ""}></div>${run.still ? "" : '<button class="add">+ Plot</button>'}<details class="objects"></details></aside>
<footer class="bar"${run.still ? " hidden" : ""}>
  <button class="play" data-state="play" title="Play or pause (space)"><svg viewBox="0 0 16 16" aria-hidden="true"><path class="to-play" d="M4 2.5v11l9-5.5z"/><path class="to-pause" d="M4 3h3v10H4zM9 3h3v10H9z"/></svg></button>
  <input class="slider" type="range" aria-label="time">
  <output class="clock"></output>
  <select class="speed" aria-label="speed" title="Speed"></select>
</footer>`;
}

main().catch((error) => {
  document.getElementById("viewer").textContent = `The run in this page cannot be shown: ${error.message}`;
  throw error;
});
