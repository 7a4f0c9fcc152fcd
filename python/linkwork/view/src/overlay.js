// What lies over the picture: names, inertial axes and gravity in a corner, a length to compare with.

import { projection } from "./detail.js";

const NAMES = 80; // at most so many are shown at once
const CORNER = 34; // half the size of the axes' corner [pixels]

export class Overlay {
  constructor(element, world, runs) {
    Object.assign(this, { element, world, run: runs[0], names: runs[0].still && runs[0].bodyCount <= 30 ? "bodies" : "none" });
    element.innerHTML = `
      <div class="names"></div>
      <svg class="triad" viewBox="${-CORNER} ${-CORNER} ${2 * CORNER} ${2 * CORNER}" aria-label="inertial axes"></svg>
      <div class="scale"><span></span><i></i></div>`;
    this.part = (name) => element.querySelector(`.${name}`);
    world.rendered.push(() => this.update());
  }

  update() {
    this.#triad();
    this.#scale();
    this.#names();
  }

  #triad() {
    const { camera } = this.world;
    camera.updateMatrixWorld();
    const m = camera.matrixWorldInverse.elements; // column by column: where x, y, z point in the picture
    const arrows = ["x", "y", "z"].map((name, i) => ({ name, at: [m[4 * i], -m[4 * i + 1], m[4 * i + 2]], kind: name }));
    const g = this.run.gravity;
    const size = Math.hypot(...g);
    if (size > 0) {
      const at = [0, 1, 2].map((row) => (m[row] * g[0] + m[4 + row] * g[1] + m[8 + row] * g[2]) / size);
      arrows.push({ name: "g", at: [0.62 * at[0], -0.62 * at[1], at[2] - 1], kind: "gravity" });
    }
    arrows.sort((a, b) => a.at[2] - b.at[2]); // far ones first
    this.part("triad").innerHTML = arrows
      .map(({ name, at: [x, y], kind }) => `<g class="${kind}"><line x2="${22 * x}" y2="${22 * y}"/><text x="${29 * x}" y="${29 * y + 3.5}">${name}</text></g>`)
      .join("");
  }

  /** A bar of a round length, as where the camera looks at. */
  #scale() {
    const pixels = this.world.pixelsOfMeter;
    if (!(pixels > 0) || !Number.isFinite(pixels)) return;
    const power = 10 ** Math.floor(Math.log10(120 / pixels));
    const length = [5, 2, 1].map((step) => step * power).find((it) => it * pixels <= 120);
    this.part("scale").querySelector("i").style.width = `${length * pixels}px`;
    this.part("scale").querySelector("span").textContent = length >= 1000 || length < 1e-3 ? `${length.toExponential(0)} m` : `${Number(length.toPrecision(1))} m`;
  }

  #names() {
    const { run, world } = this;
    const out = [0, 0, 0];
    const wanted = [];
    this.asked = 0; // names of what is in the picture, before most are left out
    const add = (text, at, kind) => wanted.length < NAMES && wanted.push({ text, at: world.projected(...at), kind });
    for (const [joint, text] of run.loose) add(`${run.joints.names[joint]}: ${text}`, run.jointPoint(joint, 1, out), "loose");
    const { selected } = world;
    if (selected?.kind === "body") add(run.bodies.names[selected.index], run.pose.subarray(7 * selected.index, 7 * selected.index + 3), "selected");
    if (selected?.kind === "joint") add(run.joints.names[selected.index], run.jointPoint(selected.index, 0, out), "selected");
    if (this.names === "bodies" || this.names === "all") {
      const place = (i) => run.pose.subarray(7 * i, 7 * i + 3);
      for (const i of this.#some(run.bodyCount, "body", place)) add(run.bodies.names[i], place(i), "body");
    }
    if (this.names === "joints" || this.names === "all") {
      const place = (j) => run.jointPoint(j, 0, out);
      for (const j of this.#some(run.jointCount, "joint", place)) add(run.joints.names[j], place(j), "joint");
    }
    this.named = wanted.filter((it) => it.kind === "body" || it.kind === "joint").length;
    const place = this.part("names");
    while (place.childElementCount < wanted.length) place.append(document.createElement("span"));
    [...place.children].forEach((label, k) => {
      const it = wanted[k];
      label.hidden = !it;
      if (!it) return;
      if (label.textContent !== it.text) label.textContent = it.text;
      label.className = it.kind;
      label.style.transform = `translate(${it.at[0].toFixed(1)}px, ${it.at[1].toFixed(1)}px) translate(-50%, -50%)`;
    });
  }

  /** Those that can be named: all of few, else some of those in the picture, evenly. */
  #some(count, kind, place) {
    const hidden = this.world.hidden[kind];
    const all = [];
    const { clientWidth: width, clientHeight: height } = this.world.renderer.domElement;
    const project = projection(this.world.camera, width, height);
    const at = [0, 0];
    for (let i = 0; i < count; i++) {
      if (hidden.has(i)) continue;
      if (count > NAMES && !(project(...place(i), at) && at[0] >= 0 && at[0] <= width && at[1] >= 0 && at[1] <= height)) continue;
      all.push(i);
    }
    this.asked += all.length;
    const step = Math.ceil(all.length / NAMES);
    return step > 1 ? all.filter((_, k) => k % step === 0) : all;
  }
}
