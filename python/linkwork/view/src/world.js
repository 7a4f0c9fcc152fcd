// The three-dimensional picture of one run, or of two laid over each other. It is drawn when something changed.

import {
  AmbientLight, BoxGeometry, BufferAttribute, BufferGeometry, Color, ConeGeometry, Curve, CylinderGeometry, DirectionalLight,
  DynamicDrawUsage, GridHelper, Group, HemisphereLight, InstancedMesh, LatheGeometry, Line, LineBasicMaterial, LineSegments, Matrix4,
  MeshLambertMaterial, MeshStandardMaterial, PerspectiveCamera, Points, PointsMaterial, Quaternion, Raycaster, Scene, SphereGeometry,
  TubeGeometry, Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { Crowd, Eye, Lines, projection } from "./detail.js";
import { turned } from "./run.js";

const GHOST = "#d1495b";
const UNIQUE = "#1f9d78";
const SHARED = "#d99a00";
const LOOSE = "#e0322b"; // joints that the initial pose violates
const SELECTED = "#00b7ff";
const LONGEST = 0.22; // arrow, of the box around everything
export const PATHS = 6; // bodies of which the way is drawn
const DOTS = 200; // bodies from which on each has a dot
const DOT = { thin: 4.5, thick: 1.5 }; // pixels of it, where bodies are thinner than a pixel, and where one sees them
export const FRAMES = 2000; // bodies of which the axes are drawn
const MANY = 1500; // instances from which on they have fewer triangles
const CROWDED = 6000; // from which on each is drawn as what one can see of it
const CLOSE = 16; // times the lever of the run: from where one looks at what is picked
const NEAR = 6; // pixels within which a dot or a line is under a place of the picture

/** Colors of 1e-14 m (dark) to 1e-3 m (bright) and beyond. */
export const GAP = { low: -14, high: -3, colors: ["#30366b", "#3b6f9c", "#3aa69b", "#9fce63", "#f2c14e", "#e4572e"] };

export class World {
  constructor(canvas, runs) {
    this.runs = runs;
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(32, 1, 0.01, 100);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.addEventListener("change", () => this.#moved());
    this.shown = { joints: true, forces: true, paths: true, grid: true, axes: Boolean(runs[0].still), second: true };
    this.arrows = "none";
    this.coloring = "body";
    this.hidden = { body: new Set(), joint: new Set(), force: new Set() };
    this.selected = null; // {kind, index}
    this.rendered = []; // called after each picture
    this.#place();
    this.#light();
    const instances = runs.reduce((sum, run) => sum + [...run.solids, ...run.spans].reduce((n, it) => n + run.arrays[`${it.key}.color`].shape[0], 0), 0);
    this.crowded = instances > CROWDED;
    this.figures = runs.map((run, number) => new Figure(run, number > 0, instances > MANY, this));
    for (const figure of this.figures) this.scene.add(figure.group);
    this.update();
  }

  /** Ask for a new picture. */
  changed() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => this.render());
  }

  render() {
    this.waiting = false;
    for (const figure of this.figures) figure.sizeDots();
    if (this.crowded) this.#choose();
    this.renderer.render(this.scene, this.camera);
    for (const listener of this.rendered) listener();
  }

  /** From near a link of a long chain one sees it, too, and the whole chain from afar. */
  #moved() {
    const distance = this.camera.position.distanceTo(this.controls.target);
    this.#clip(distance);
    this.changed();
  }

  #clip(distance) {
    this.farthest ??= distance;
    this.camera.near = distance / 500;
    this.camera.far = 50 * Math.max(distance, this.farthest);
    this.camera.updateProjectionMatrix();
  }

  /** What is seen of each instance, from here. */
  #choose() {
    const eye = new Eye(this.camera, this.renderer.domElement.clientHeight);
    for (const figure of this.figures) if (figure.group.visible) figure.choose(eye);
  }

  /** The picture as it is seen, as a PNG. */
  async screenshot() {
    this.render(); // a canvas keeps its picture only until the browser has shown it
    return new Promise((resolve) => this.renderer.domElement.toBlob(resolve, "image/png"));
  }

  /** Force [N] or torque [N m] of the longest arrow. */
  largest(kind) {
    return Math.max(...this.figures.map((it) => it.largest[kind]));
  }

  hide(kind, index, hidden) {
    if (hidden) this.hidden[kind].add(index);
    else this.hidden[kind].delete(index);
    this.update();
  }

  select(kind, index) {
    const same = this.selected && this.selected.kind === kind && this.selected.index === index;
    this.selected = same || index === undefined ? null : { kind, index };
    for (const figure of this.figures) figure.recolor();
    this.update();
    return this.selected;
  }

  /** The runs have moved, or what is shown of them is another. */
  update() {
    for (const figure of this.figures) figure.update();
    this.grid.visible = this.shown.grid;
    this.changed();
  }

  resize(width, height) {
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / Math.max(height, 1);
    this.camera.updateProjectionMatrix();
    if (!this.fitted) this.fit();
    this.changed();
  }

  theme(colors) {
    this.scene.background = new Color(colors.scene);
    this.scene.remove(this.grid);
    this.#floor(colors.grid, colors.gridStrong);
    this.dark = colors.dark;
    for (const figure of this.figures) figure.recolor();
    this.update();
  }

  /** Look at everything along an inertial axis, or from the side that shows the most: "x", "-y", "z", ..., "fit"; at what is "picked". */
  look(preset) {
    if (preset === "fit") return this.fit();
    if (preset === "picked") return this.approach();
    const axis = "xyz".indexOf(preset.at(-1));
    const towards = new Vector3().setComponent(axis, preset.startsWith("-") ? -1 : 1);
    const up = this.camera.up;
    if (Math.abs(towards.dot(up)) > 0.999) {
      const aside = Math.abs(up.y) < 0.5 ? new Vector3(0, 1, 0) : new Vector3(1, 0, 0);
      towards.addScaledVector(aside, -1e-3).normalize(); // a camera that looks along up has no right
    }
    this.#from(towards);
  }

  /** Look at what is picked, from where the camera is, so near that one sees it. */
  approach() {
    if (!this.selected || this.selected.kind === "force") return;
    const { run, point } = this.figures[0];
    const { kind, index } = this.selected;
    const at = kind === "body" ? run.pose.subarray(7 * index, 7 * index + 3) : run.jointPoint(index, 0, point);
    const direction = this.camera.position.clone().sub(this.controls.target).normalize();
    this.controls.target.fromArray(at);
    this.camera.position.fromArray(at).addScaledVector(direction, CLOSE * run.lever);
    this.#clip(CLOSE * run.lever);
    this.controls.update();
    this.changed();
  }

  /** Look at everything from the side that shows the most. */
  fit() {
    this.fitted = true;
    const size = this.high.clone().sub(this.low);
    const sides = size.toArray();
    const flat = sides.indexOf(Math.min(...sides));
    const up = this.camera.up;
    const isFlat = sides[flat] < 0.25 * Math.max(...sides) && Math.abs(up.getComponent(flat)) < 0.5;
    const direction = new Vector3();
    if (isFlat) {
      direction.setComponent(flat, 1);
      // the viewer's right is up x direction: x, or y, points to the right
      const right = up.clone().cross(direction);
      if (right.x + right.y + right.z < 0) direction.negate();
      direction.addScaledVector(up.clone().cross(direction), 0.28);
    } else {
      const side = Math.abs(up.x) < 0.5 ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0);
      side.addScaledVector(up, -side.dot(up)).normalize();
      direction.copy(side).multiplyScalar(0.75).addScaledVector(side.clone().cross(up), 1);
    }
    const lies = sides[flat] < 0.25 * Math.max(...sides) && !isFlat; // in a level plane: seen from above
    this.#from(direction.normalize().addScaledVector(up, lies ? 1.4 : 0.34).normalize());
  }

  #from(direction) {
    const { up } = this.camera;
    const sides = this.high.clone().sub(this.low).toArray();
    const center = this.low.clone().add(this.high).multiplyScalar(0.5);
    // the distance at which the eight corners of the box are inside the picture
    const half = Math.tan((this.camera.fov * Math.PI) / 360);
    const view = direction.clone().negate();
    const right = view.clone().cross(up).normalize();
    const top = right.clone().cross(view);
    let distance = 1e-9;
    for (let corner = 0; corner < 8; corner++) {
      const c = new Vector3().fromArray([0, 1, 2].map((i) => ((corner >> i) & 1 ? 0.5 : -0.5) * sides[i]));
      const wide = Math.max(Math.abs(c.dot(top)), Math.abs(c.dot(right)) / this.camera.aspect) / half;
      distance = Math.max(distance, wide - c.dot(view));
    }
    this.controls.target.copy(center);
    this.camera.position.copy(center).addScaledVector(direction, 1.06 * distance);
    this.farthest = distance;
    this.#clip(distance);
    this.controls.update();
    this.changed();
  }

  /** Pixels of a meter where the camera looks at. */
  get pixelsOfMeter() {
    const distance = this.camera.position.distanceTo(this.controls.target);
    const high = 2 * distance * Math.tan((this.camera.fov * Math.PI) / 360);
    return this.renderer.domElement.clientHeight / high;
  }

  /** Where a point (x, y, z) is in the picture, in pixels of the page from the canvas' corner. */
  projected(x, y, z) {
    this.camera.updateMatrixWorld();
    const p = new Vector3(x, y, z).project(this.camera);
    const { clientWidth: width, clientHeight: height } = this.renderer.domElement;
    return [((p.x + 1) / 2) * width, ((1 - p.y) / 2) * height];
  }

  /** The body or joint under a place of the canvas in pixels: {layer, name}. */
  under(x, y) {
    const { clientWidth: width, clientHeight: height } = this.renderer.domElement;
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2((2 * x) / width - 1, 1 - (2 * y) / height), this.camera);
    const shown = this.figures.filter((it) => it.group.visible);
    const meshes = shown.flatMap((it) => it.parts).flatMap((it) => it.meshes).filter((it) => it.mesh.visible && it.mesh.count > 0);
    for (const { mesh } of meshes) mesh.computeBoundingSphere();
    const hit = ray.intersectObjects(meshes.map((it) => it.mesh), false)[0];
    if (!hit) return this.crowded ? this.#nearest(shown, x, y) : null;
    const { part, place } = meshes.find((it) => it.mesh === hit.object);
    const index = part.index[place(hit.instanceId)];
    const { run } = part.figure;
    if (part.layer === "body") return { kind: "body", name: run.bodies.names[index], run };
    if (index < 0) return { kind: "body", name: "ground", run };
    if (part.layer === "force") return { kind: "force", name: run.forces.names[index], detail: run.forces.kinds[index].replaceAll("_", " "), run };
    return { kind: "joint", name: run.joints.names[index], detail: run.joints.kinds[index].replaceAll("_", " "), run };
  }

  /** The body whose center is nearest to a place of the picture. */
  #nearest(figures, x, y) {
    const { clientWidth: width, clientHeight: height } = this.renderer.domElement;
    const project = projection(this.camera, width, height);
    const at = [0, 0];
    let [least, found] = [NEAR, null];
    for (const { run } of figures) {
      for (let i = 0; i < run.bodyCount; i++) {
        if (!project(run.pose[7 * i], run.pose[7 * i + 1], run.pose[7 * i + 2], at) || this.hidden.body.has(i)) continue;
        const apart = Math.hypot(at[0] - x, at[1] - y);
        if (apart < least) [least, found] = [apart, { kind: "body", name: run.bodies.names[i], run }];
      }
    }
    return found;
  }

  #place() {
    const ends = this.runs.map((run) => run.extent.map((end) => new Vector3(...end)));
    this.low = ends.reduce((low, end) => low.min(end[0]), ends[0][0].clone());
    this.high = ends.reduce((high, end) => high.max(end[1]), ends[0][1].clone());
    this.size = this.high.clone().sub(this.low).length() || 1;
    const gravity = new Vector3(...this.runs[0].gravity);
    const sides = this.high.clone().sub(this.low);
    const free = sides.z < 0.25 * Math.max(sides.x, sides.y) ? new Vector3(0, 1, 0) : new Vector3(0, 0, 1);
    this.camera.up.copy(gravity.length() > 0 ? gravity.normalize().negate() : free);
    this.#floor("#ccc", "#aaa");
  }

  #light() {
    const { up } = this.camera;
    const sun = new DirectionalLight("#ffffff", 2.1);
    const side = new Vector3(0.55, -0.75, 0.35);
    sun.position.copy(side).addScaledVector(up, 1.4);
    const sky = new HemisphereLight("#ffffff", "#8b93a1", 1.5);
    sky.position.copy(up);
    this.scene.add(sun, sky, new AmbientLight("#ffffff", 0.35));
  }

  /** A grid below everything, with round distances. */
  #floor(color, strong) {
    const { up } = this.camera;
    const spacing = round(this.size / 12);
    const count = 2 * Math.ceil((0.8 * this.size) / spacing);
    this.grid = new GridHelper(count * spacing, count, strong, color);
    this.grid.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), up);
    const center = this.low.clone().add(this.high).multiplyScalar(0.5);
    const snapped = center.toArray().map((x) => Math.round(x / spacing) * spacing);
    const below = [this.low, this.high].map((corner) => corner.clone().multiply(up)).map((c) => c.x + c.y + c.z);
    this.grid.position.fromArray(snapped);
    this.grid.position.addScaledVector(up, Math.min(...below) - this.grid.position.dot(up) - 0.02 * this.size);
    this.grid.visible = this.shown.grid;
    this.scene.add(this.grid);
    this.spacing = spacing;
  }
}

/** What is drawn of one run. */
class Figure {
  constructor(run, ghost, coarse, world) {
    Object.assign(this, { run, ghost, world, group: new Group(), point: new Float32Array(3) });
    this.materials = [];
    this.parts = [...run.solids.map((it) => new Part(this, it, coarse)), ...run.spans.map((it) => new Span(this, it, coarse))];
    this.seen = null; // how many bodies are drawn as what, where there are many
    if (world.crowded) {
      this.lines = new Lines();
      this.group.add(this.lines.mesh);
      for (const part of this.parts) part.crowd = new Crowd(part, instanced);
    }
    for (const part of this.parts) this.group.add(...part.meshes.map((it) => it.mesh));
    this.bodyColor = new Map();
    for (const part of this.parts.filter((it) => it.layer === "body")) {
      part.index.forEach((body, k) => this.bodyColor.set(body, part.colors.subarray(3 * k, 3 * k + 3)));
    }
    this.#paths();
    this.#dots();
    this.#axes();
    this.#arrows(coarse);
    this.#gaps();
    this.recolor();
  }

  material(color, coarse) {
    const Kind = coarse ? MeshLambertMaterial : MeshStandardMaterial;
    const material = new Kind({ color });
    if (!coarse) Object.assign(material, { roughness: 0.62, metalness: 0.05 });
    if (this.ghost) Object.assign(material, { transparent: true, opacity: 0.5, depthWrite: false, polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 2 });
    return material;
  }

  update() {
    const { shown, arrows } = this.world;
    this.group.visible = !this.ghost || shown.second;
    if (!this.group.visible) return;
    for (const part of this.parts) {
      part.mesh.visible = part.layer === "body" || (part.layer === "force" ? shown.forces : shown.joints);
      if (part.mesh.visible) part.update();
    }
    this.paths.visible = shown.paths;
    this.axes.visible = shown.axes;
    this.arrows.visible = arrows !== "none";
    if (this.dots) this.#moveDots();
    if (this.axes.visible) this.#moveAxes();
    if (this.arrows.visible) this.#moveArrows();
    this.#colorJoints();
  }

  choose(eye) {
    this.lines.begin();
    this.seen = null;
    for (const part of this.parts) {
      const seen = { shapes: 0, boxes: 0, lines: 0, smaller: 0, outside: 0 };
      part.crowd.choose(eye, this.lines, seen);
      if (part.layer === "body") this.seen = this.seen ? Object.fromEntries(Object.keys(seen).map((key) => [key, seen[key] + this.seen[key]])) : seen;
    }
    this.lines.end();
  }

  /** Colors of solids, after the theme has changed or what colors mean. */
  recolor() {
    for (const part of this.parts) part.recolor();
    this.gapsShown = null;
  }

  #colorJoints() {
    const { coloring } = this.world;
    const key = coloring === "gap" ? this.run.frame : -1;
    if (this.gapsShown === key) return;
    if (coloring === "gap") {
      for (const part of this.parts.filter((it) => it.layer === "joint")) part.colorByGap();
    } else if (this.gapsShown !== null) {
      for (const part of this.parts) part.recolor();
    }
    this.gapsShown = key;
  }

  #paths() {
    this.paths = new Group();
    const { run } = this;
    for (const body of run.movers(PATHS)) {
      const points = new Float32Array(3 * run.count);
      const width = run.track.length / run.count;
      const at = 7 * run.placeOfTrack(body);
      for (let k = 0; k < run.count; k++) {
        points.set(run.track.subarray(width * k + at, width * k + at + 3), 3 * k);
      }
      const geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(points, 3));
      const color = new Color(GHOST);
      if (!this.ghost && this.bodyColor.has(body)) setColor(color, this.bodyColor.get(body));
      this.paths.add(new Line(geometry, new LineBasicMaterial({ color, transparent: true, opacity: 0.55 })));
    }
    this.group.add(this.paths);
  }

  /** Where there are many bodies, each is a dot at least: seen from afar they are thinner than a pixel. */
  #dots() {
    const count = this.run.bodyCount;
    if (count < DOTS) return;
    const colors = new Float32Array(3 * count);
    const color = new Color(GHOST);
    for (let i = 0; i < count; i++) {
      if (!this.ghost && this.bodyColor.has(i)) setColor(color, this.bodyColor.get(i));
      color.toArray(colors, 3 * i);
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * count), 3).setUsage(DynamicDrawUsage));
    geometry.setAttribute("color", new BufferAttribute(colors, 3));
    this.dots = new Points(geometry, new PointsMaterial({ size: DOT.thick, sizeAttenuation: false, vertexColors: true }));
    this.dots.frustumCulled = false;
    this.thickness = this.#usualThickness;
    this.group.add(this.dots);
  }

  /** What would be a hairline is a line of dots. */
  sizeDots() {
    if (!this.dots) return;
    const pixels = this.thickness * this.world.pixelsOfMeter * window.devicePixelRatio;
    this.dots.material.size = Math.min(Math.max(DOT.thin - pixels, DOT.thick), DOT.thin) * Math.min(window.devicePixelRatio, 2);
  }

  /** Of most bodies, where they are thinnest [m]. */
  get #usualThickness() {
    const bodies = this.parts.filter((it) => it.layer === "body" && it.local);
    const all = bodies.flatMap((it) => Array.from(it.index, (_, k) => Math.min(...it.local.subarray(10 * k + 7, 10 * k + 10))));
    return all.sort((a, b) => a - b)[Math.floor(all.length / 2)] ?? 0;
  }

  #moveDots() {
    const { position } = this.dots.geometry.attributes;
    for (let i = 0; i < this.run.bodyCount; i++) {
      for (let c = 0; c < 3; c++) position.array[3 * i + c] = this.run.pose[7 * i + c];
    }
    position.needsUpdate = true;
  }

  /** From point to point of joints that the initial pose violates. */
  #gaps() {
    const joints = [...this.run.looseJoints.keys()];
    if (!joints.length) return;
    const points = joints.flatMap((joint) => [0, 1].flatMap((side) => [...this.run.jointPoint(joint, side, this.point)]));
    const geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
    const lines = new LineSegments(geometry, new LineBasicMaterial({ color: LOOSE, depthTest: false }));
    lines.renderOrder = 4;
    this.group.add(lines);
  }

  /** x, y, z of every body and of the inertial frame, in red, green, blue. */
  #axes() {
    const count = Math.min(this.run.bodyCount, FRAMES) + 1;
    const colors = new Float32Array(18 * count);
    const rgb = [[0.85, 0.25, 0.25], [0.25, 0.65, 0.3], [0.25, 0.45, 0.9]];
    for (let k = 0; k < 6 * count; k++) colors.set(rgb[(k >> 1) % 3], 3 * k);
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(18 * count), 3).setUsage(DynamicDrawUsage));
    geometry.setAttribute("color", new BufferAttribute(colors, 3));
    this.axes = new LineSegments(geometry, new LineBasicMaterial({ vertexColors: true, depthTest: false }));
    this.axes.frustumCulled = false;
    this.axes.renderOrder = 2;
    this.group.add(this.axes);
  }

  #moveAxes() {
    const { pose, bodyCount } = this.run;
    const { array } = this.axes.geometry.attributes.position;
    const count = array.length / 18;
    const length = 0.06 * this.world.size;
    for (let i = 0; i < count; i++) {
      const at = 7 * (i === count - 1 ? bodyCount : i);
      for (let axis = 0; axis < 3; axis++) {
        const u = [0, 0, 0];
        u[axis] = length;
        turned(pose, at + 3, u[0], u[1], u[2], this.point);
        for (let c = 0; c < 3; c++) {
          array[18 * i + 6 * axis + c] = pose[at + c];
          array[18 * i + 6 * axis + 3 + c] = pose[at + c] + this.point[c];
        }
      }
    }
    this.axes.geometry.attributes.position.needsUpdate = true;
  }

  /** The reactions of joints on their second bodies; those that are not unique in another color. */
  #arrows(coarse) {
    const count = Math.max(this.run.joints.plotted.length, 1);
    const sides = coarse ? 6 : 14;
    this.arrows = new Group();
    this.shafts = instanced(new CylinderGeometry(1, 1, 1, sides).rotateX(Math.PI / 2), this.material("#fff", coarse), count);
    this.heads = instanced(new ConeGeometry(1, 1, sides).rotateX(Math.PI / 2), this.material("#fff", coarse), count);
    const color = new Color();
    this.run.joints.plotted.forEach((joint, k) => {
      color.set(this.run.joints.unique[joint] ? UNIQUE : SHARED);
      this.shafts.setColorAt(k, color);
      this.heads.setColorAt(k, color);
    });
    for (const mesh of [this.shafts, this.heads]) {
      Object.assign(mesh.material, { depthTest: false, transparent: true }); // in front of the joints they belong to
      mesh.renderOrder = 3;
    }
    this.arrows.add(this.shafts, this.heads);
    this.group.add(this.arrows);
    this.largest = { force: largest(this.run.force), torque: largest(this.run.torque) };
  }

  #moveArrows() {
    const kind = this.world.arrows;
    const values = this.run[kind];
    const width = 3 * this.run.joints.plotted.length;
    // one scale for both runs
    const scale = (LONGEST * this.world.size) / (this.world.largest(kind) || 1);
    const radius = 0.0045 * this.world.size;
    this.run.joints.plotted.forEach((joint, k) => {
      const at = this.run.frame * width + 3 * k;
      const arrow = new Vector3(values[at], values[at + 1], values[at + 2]).multiplyScalar(scale);
      const start = new Vector3(...this.run.jointPoint(joint, 1, this.point));
      const length = arrow.length();
      const head = Math.min(6 * radius, 0.5 * length);
      const neck = start.clone().addScaledVector(arrow, length > 0 ? 1 - head / length : 0);
      const thin = Math.min(radius, 0.1 * length);
      stretch(this.shafts, k, start, neck, thin);
      stretch(this.heads, k, neck, start.clone().add(arrow), 2.6 * thin);
    });
    for (const mesh of [this.shafts, this.heads]) mesh.instanceMatrix.needsUpdate = true;
  }
}

/** The instances of one geometry in one layer. */
class Part {
  constructor(figure, { key, layer, geometry, form, clear }, coarse) {
    const { run } = figure;
    Object.assign(this, { figure, layer });
    this.index = run.array(`${key}.index`);
    this.place(run, key);
    this.colors = run.array(`${key}.color`);
    const shape = geometry === "mesh" ? meshGeometry(run.array(`${key}.vertices`), run.array(`${key}.triangles`)) : GEOMETRIES[form ?? geometry](coarse);
    this.mesh = instanced(shape, figure.material("#ffffff", coarse), this.index.length);
    if (clear) Object.assign(this.mesh.material, { transparent: true, opacity: 0.3, depthWrite: false });
    this.crowd = null;
  }

  /** Its meshes, each with the place of its instances in the part. */
  get meshes() {
    if (!this.crowd) return [{ part: this, mesh: this.mesh, place: (k) => k }];
    return this.crowd.levels.map(({ mesh, index }) => ({ part: this, mesh, place: (k) => index[k] }));
  }

  paint(k, color) {
    if (this.crowd) color.toArray(this.crowd.shades, 3 * k);
    else this.mesh.setColorAt(k, color);
  }

  isHidden(k) {
    return Boolean(this.figure.world.hidden[this.layer]?.has(this.index[k]));
  }

  place(run, key) {
    this.body = run.array(`${key}.body`);
    this.local = run.array(`${key}.place`); // position, Euler parameters, size
  }

  recolor() {
    const color = new Color();
    const { ghost, world, run } = this.figure;
    const { selected } = world;
    for (let k = 0; k < this.index.length; k++) {
      setColor(color, this.colors.subarray(3 * k, 3 * k + 3));
      if (ghost) color.set(GHOST);
      else if (this.layer === "joint" && run.looseJoints.has(this.index[k])) color.set(LOOSE);
      else if (this.layer === "joint" && world.dark) color.set("#d5dae1");
      if (!ghost && selected && selected.kind === this.layer && selected.index === this.index[k]) color.set(SELECTED);
      this.paint(k, color);
    }
    if (!this.crowd) this.mesh.instanceColor.needsUpdate = true;
  }

  colorByGap() {
    const { run } = this.figure;
    for (let k = 0; k < this.index.length; k++) {
      const place = run.placeOfJoint.get(this.index[k]);
      if (place !== undefined && run.joints.held[this.index[k]]) this.paint(k, gapColor(run.violationOf(place)));
    }
    if (!this.crowd) this.mesh.instanceColor.needsUpdate = true;
  }

  update() {
    if (this.crowd) return; // chosen for each picture
    const matrices = this.mesh.instanceMatrix.array;
    for (let k = 0; k < this.body.length; k++) {
      if (this.isHidden(k)) matrices.fill(0, 16 * k, 16 * k + 15);
      else this.put(k, matrices, 16 * k);
    }
    this.mesh.instanceMatrix.needsUpdate = true;
  }

  /** How far each reaches from the center of its body, where `box` is around the geometry [m]. */
  measure(box) {
    const corner = [0, 1, 2].map((c) => Math.max(-box.min.getComponent(c), box.max.getComponent(c)));
    const l = this.local;
    this.reach = new Float32Array(this.body.length);
    for (let k = 0, at = 0; k < this.reach.length; k++, at += 10) {
      this.reach[k] = Math.hypot(l[at], l[at + 1], l[at + 2]) + Math.hypot(corner[0] * l[at + 7], corner[1] * l[at + 8], corner[2] * l[at + 9]);
    }
  }

  /** A ball around instance k: its center, into `out`, and its radius [m]. */
  around(k, out) {
    const { pose, bodyCount } = this.figure.run;
    const at = 7 * (this.body[k] < 0 ? bodyCount : this.body[k]);
    for (let c = 0; c < 3; c++) out[c] = pose[at + c];
    return this.reach[k];
  }

  /** matrix = T(r + A(p) s) A(p) A(p_local) S of instance k, from `m` on. */
  put(k, matrices, m) {
    const { pose, bodyCount } = this.figure.run;
    const { point } = this.figure;
    const body = this.body[k] < 0 ? bodyCount : this.body[k];
    const at = 7 * body;
    const own = 10 * k;
    const l = this.local;
    turned(pose, at + 3, l[own], l[own + 1], l[own + 2], point);
    const [a0, a1, a2, a3] = [pose[at + 3], pose[at + 4], pose[at + 5], pose[at + 6]];
    const [b0, b1, b2, b3] = [l[own + 3], l[own + 4], l[own + 5], l[own + 6]];
    const e0 = a0 * b0 - a1 * b1 - a2 * b2 - a3 * b3;
    const e1 = a0 * b1 + a1 * b0 + a2 * b3 - a3 * b2;
    const e2 = a0 * b2 - a1 * b3 + a2 * b0 + a3 * b1;
    const e3 = a0 * b3 + a1 * b2 - a2 * b1 + a3 * b0;
    const [sx, sy, sz] = [l[own + 7], l[own + 8], l[own + 9]];
    matrices[m] = (1 - 2 * (e2 * e2 + e3 * e3)) * sx;
    matrices[m + 1] = 2 * (e1 * e2 + e0 * e3) * sx;
    matrices[m + 2] = 2 * (e1 * e3 - e0 * e2) * sx;
    matrices[m + 4] = 2 * (e1 * e2 - e0 * e3) * sy;
    matrices[m + 5] = (1 - 2 * (e1 * e1 + e3 * e3)) * sy;
    matrices[m + 6] = 2 * (e2 * e3 + e0 * e1) * sy;
    matrices[m + 8] = 2 * (e1 * e3 + e0 * e2) * sz;
    matrices[m + 9] = 2 * (e2 * e3 - e0 * e1) * sz;
    matrices[m + 10] = (1 - 2 * (e1 * e1 + e2 * e2)) * sz;
    matrices[m + 12] = pose[at] + point[0];
    matrices[m + 13] = pose[at + 1] + point[1];
    matrices[m + 14] = pose[at + 2] + point[2];
    matrices[m + 15] = 1;
  }
}

/** Bars, coils and dampers between points of two bodies. */
class Span extends Part {
  update() {
    if (this.crowd) return;
    for (let k = 0; k < this.index.length; k++) this.put(k, this.mesh.instanceMatrix.array, 16 * k, this.isHidden(k) ? 0 : this.radius[k]);
    this.mesh.instanceMatrix.needsUpdate = true;
  }

  put(k, matrices, m, radius = this.radius[k]) {
    const { run, point } = this.figure;
    const { from, to } = scratch;
    from.fromArray(run.point(this.bodies, this.ends, k, 0, point));
    to.fromArray(run.point(this.bodies, this.ends, k, 1, point));
    stretched(from, to, radius).toArray(matrices, m);
  }

  measure() {}

  around(k, out) {
    const { run, point } = this.figure;
    out.set(run.point(this.bodies, this.ends, k, 0, point));
    run.point(this.bodies, this.ends, k, 1, point);
    return Math.hypot(point[0] - out[0], point[1] - out[1], point[2] - out[2]) + this.radius[k];
  }

  place(run, key) {
    this.bodies = run.array(`${key}.bodies`);
    this.ends = run.array(`${key}.ends`);
    this.radius = run.array(`${key}.radius`);
  }
}

const COILS = 7;
const SLENDER = 12; // length of a spring over its radius at which its wire is round

class Helix extends Curve {
  /** From end to end along z, with a straight piece at each. */
  getPoint(s, out = new Vector3()) {
    const turn = Math.min(Math.max((s - 0.08) / 0.84, 0), 1);
    const radius = Math.min(1, 12 * Math.min(turn, 1 - turn));
    const angle = 2 * Math.PI * COILS * turn;
    return out.set(radius * Math.cos(angle), radius * Math.sin(angle), SLENDER * (s - 0.5));
  }
}

/** Edges and diameters of one; cylinders along z. Spans are of length one along z, and of radius one. */
const GEOMETRIES = {
  box: () => new BoxGeometry(1, 1, 1),
  sphere: (coarse) => (coarse ? new SphereGeometry(0.5, 8, 6) : new SphereGeometry(0.5, 28, 18)),
  cylinder: (coarse) => new CylinderGeometry(0.5, 0.5, 1, coarse ? 8 : 28).rotateX(Math.PI / 2),
  bar: (coarse) => new CylinderGeometry(1, 1, 1, coarse ? 6 : 10).rotateX(Math.PI / 2),
  coil: (coarse) => new TubeGeometry(new Helix(), COILS * (coarse ? 8 : 24), 0.17, coarse ? 3 : 7).scale(1, 1, 1 / SLENDER),
  damper: (coarse) => new LatheGeometry(DAMPER.map(([radius, z]) => new Vector2(radius, z)), coarse ? 6 : 16).rotateX(Math.PI / 2),
};

/** Half a section of a damper, along its length: an eye, the cylinder, the rod. */
const DAMPER = [[0, -0.5], [0.3, -0.5], [0.3, -0.36], [1, -0.36], [1, 0.14], [0.3, 0.14], [0.3, 0.5], [0, 0.5]];

function meshGeometry(vertices, triangles) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(vertices), 3));
  geometry.setIndex(new BufferAttribute(new Uint32Array(triangles), 1));
  const flat = geometry.toNonIndexed(); // flat faces: meshes of machine parts have sharp edges
  flat.computeVertexNormals();
  return flat;
}

function instanced(geometry, material, count) {
  const mesh = new InstancedMesh(geometry, material, count);
  mesh.instanceMatrix.setUsage(DynamicDrawUsage);
  mesh.frustumCulled = false;
  return mesh;
}

const Z = new Vector3(0, 0, 1);
const scratch = { matrix: new Matrix4(), from: new Vector3(), to: new Vector3(), turn: new Quaternion(), along: new Vector3(), size: new Vector3(), middle: new Vector3() };

/** Lay the instance k, of length one along z, between two points. */
function stretch(mesh, k, a, b, radius) {
  mesh.setMatrixAt(k, stretched(a, b, radius));
}

function stretched(a, b, radius) {
  const { matrix, turn, along, size, middle } = scratch;
  along.subVectors(b, a);
  const length = along.length();
  turn.setFromUnitVectors(Z, length > 0 ? along.divideScalar(length) : Z);
  middle.addVectors(a, b).multiplyScalar(0.5);
  return matrix.compose(middle, turn, size.set(radius, radius, Math.max(length, 1e-12)));
}

function largest(vectors) {
  let found = 0;
  for (let i = 0; i < vectors.length; i += 3) found = Math.max(found, Math.hypot(vectors[i], vectors[i + 1], vectors[i + 2]));
  return found;
}

function setColor(color, bytes) {
  color.setRGB(bytes[0] / 255, bytes[1] / 255, bytes[2] / 255, "srgb");
}

function gapColor(power) {
  const { low, high, colors } = GAP;
  const x = Math.min(Math.max((power - low) / (high - low), 0), 1) * (colors.length - 1);
  const k = Math.min(Math.floor(x), colors.length - 2);
  return new Color(colors[k]).lerp(new Color(colors[k + 1]), x - k);
}

/** 1, 2 or 5 times a power of ten, near x. */
function round(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  return power * [1, 2, 5, 10].find((step) => step * power >= 0.999 * x);
}
