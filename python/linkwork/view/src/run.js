// One run: its arrays out of the page, its pose at any time, the series that can be plotted.

import { PosePieces, Poses } from "./poses.js";

const TYPES = { f8: Float64Array, f4: Float32Array, i4: Int32Array, u2: Uint16Array, u1: Uint8Array };

/** The bytes of a block of the page: base64, deflated. */
export async function unpacked(text) {
  const stream = new Blob([bytesOf(text)]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

function bytesOf(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** The bytes of an answer of the server that shows the page. */
export async function fetched(name, signal) {
  let answer, body;
  try {
    answer = await fetch(name, { signal });
    body = await (answer.ok ? answer.arrayBuffer() : answer.text()); // it may end in the middle of its answer
  } catch (error) {
    throw signal.aborted ? error : new Error("the server of this page has ended");
  }
  if (!answer.ok) throw new Error(body);
  return body;
}

export class Run {
  /** `piece(number, signal)` promises the bytes of a piece of the poses. */
  constructor(description, buffer, piece) {
    Object.assign(this, description);
    this.buffer = buffer;
    this.t = this.array("t");
    this.count = this.t.length;
    this.bodyCount = this.bodies.names.length;
    this.jointCount = this.joints.names.length;
    this.taken = new Map(); // series by name, since they were asked for
    this.poses = this.pieces ? this.#pieces(piece) : new Poses(this.series("q"), 7 * this.bodyCount);
    this.looseJoints = new Map(this.loose);
    this.energy = this.array("energy");
    this.violation = this.array("violation");
    this.jointBodies = this.array("joints.bodies");
    this.jointOrigin = this.array("joints.origin");
    this.pose = new Float32Array(7 * this.bodyCount + 7); // the ground comes last
    this.pose[7 * this.bodyCount + 3] = 1;
    this.frame = 0;
    this.placeOfBody = new Map(this.bodies.plotted.map((body, place) => [body, place]));
    this.placeOfJoint = new Map(this.joints.plotted.map((joint, place) => [joint, place]));
    this.behind = false; // the present time is of frames that are still to be taken out
    this.seek(this.t[0]);
  }

  // What can be plotted, frame by frame: few pages show all of it.
  /** 6 a plotted body. */
  get v() { return this.once("v"); }
  get vdot() { return this.once("vdot"); }
  /** 7 a body, position and Euler parameters (scalar first); where poses are in pieces a plotted body. */
  get track() { return this.pieces ? this.once("track") : this.poses.values; }
  /** One a coordinate of `coordinates`. */
  get coordinate() { return this.once("coordinate"); }
  get rate() { return this.once("rate"); }
  /** 3 a plotted joint, inertial axes. */
  get force() { return this.once("force"); }
  get torque() { return this.once("torque"); }
  /** log10 of meters, of radians, one a plotted joint. */
  get gap() { return this.once("gap"); }
  get askew() { return this.once("askew"); }

  once(name) {
    if (!this.taken.has(name)) this.taken.set(name, this.arrays[`${name}.step`] ? this.series(name) : this.singles(name));
    return this.taken.get(name);
  }

  #pieces(piece) {
    const { count: frames, pieces: { frames: each } } = this;
    if (this.pieces.streamed) return PosePieces.served({ frames, each, width: 7 * this.bodyCount, fetched: piece });
    return PosePieces.inPage({ frames, each, low: this.array("q.low"), step: this.array("q.step"), unpack: piece });
  }

  /** Place of a body in `track`; undefined where the page does not have its way. */
  placeOfTrack(body) {
    return this.pieces ? this.placeOfBody.get(body) : body;
  }

  get start() {
    return this.t[0];
  }

  get end() {
    return this.t[this.count - 1];
  }

  array(name) {
    const { type, shape, offset } = this.arrays[name];
    return new TYPES[type](this.buffer, offset, shape.reduce((a, b) => a * b, 1));
  }

  /** A quantized array, stored channel by channel in differences, as numbers frame by frame. */
  series(name) {
    const [channels, frames] = this.arrays[name].shape;
    const differences = this.array(name);
    const low = this.array(`${name}.low`);
    const step = this.array(`${name}.step`);
    const values = new Float32Array(channels * frames);
    for (let c = 0; c < channels; c++) {
      let whole = 0;
      for (let k = 0; k < frames; k++) {
        whole = (whole + differences[c * frames + k]) & 0xffff;
        values[k * channels + c] = low[c] + step[c] * whole;
      }
    }
    return values;
  }

  /** An array of single precision, stored by planes of bytes in differences of patterns, as numbers frame by frame. */
  singles(name) {
    const [planes, channels, frames] = this.arrays[name].shape;
    const bytes = this.array(name);
    const size = channels * frames;
    const patterns = new Uint32Array(size);
    for (let c = 0; c < channels; c++) {
      let whole = 0;
      for (let k = 0; k < frames; k++) {
        for (let plane = 0; plane < planes; plane++) whole += bytes[plane * size + c * frames + k] * 256 ** plane;
        patterns[k * channels + c] = whole >>>= 0;
      }
    }
    return new Float32Array(patterns.buffer);
  }

  /** The last frame at or before the time. */
  frameAt(time) {
    let low = 0;
    let high = this.count - 1;
    while (high > low) {
      const middle = (low + high + 1) >> 1;
      if (this.t[middle] <= time) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** The frame nearest to the time. */
  nearest(time) {
    const k = this.frameAt(time);
    return k + 1 < this.count && this.t[k + 1] - time < time - this.t[k] ? k + 1 : k;
  }

  /** Put `pose` to the time, between frames by interpolation; before the start and after the end it stands. */
  seek(time) {
    const k = this.frameAt(time);
    const next = Math.min(k + 1, this.count - 1);
    const span = this.t[next] - this.t[k];
    const f = span > 0 ? Math.min(Math.max((time - this.t[k]) / span, 0), 1) : 0;
    const width = 7 * this.bodyCount;
    const from = this.poses.frame(k);
    const to = f > 0 ? this.poses.frame(next) : from;
    this.poses.expect?.(k);
    this.behind = !from || !to;
    this.frame = this.nearest(time);
    if (this.behind) return; // what is shown stays until they are there
    this.#between(from, to, f, width);
  }

  #between(from, to, f, width) {
    const { pose } = this;
    const [a, b] = [from.values, to.values];
    for (let i = 0; i < width; i += 7) {
      const p = from.at + i;
      const q = to.at + i;
      for (let c = 0; c < 3; c++) pose[i + c] = a[p + c] + f * (b[q + c] - a[p + c]);
      const alike = a[p + 3] * b[q + 3] + a[p + 4] * b[q + 4] + a[p + 5] * b[q + 5] + a[p + 6] * b[q + 6];
      const sign = alike < 0 ? -f : f; // p and -p are the same pose
      for (let c = 3; c < 7; c++) pose[i + c] = (1 - f) * a[p + c] + sign * b[q + c];
      const norm = Math.hypot(pose[i + 3], pose[i + 4], pose[i + 5], pose[i + 6]) || 1;
      for (let c = 3; c < 7; c++) pose[i + c] /= norm;
    }
  }

  /** The joint's point on its first (0) or second (1) body, inertial, at the present pose. */
  jointPoint(joint, side, out) {
    return this.point(this.jointBodies, this.jointOrigin, joint, side, out);
  }

  /** The same of any element k: `bodies` two each, `origin` two points each, in the bodies. */
  point(bodies, origin, k, side, out) {
    const body = bodies[2 * k + side];
    const at = 7 * (body < 0 ? this.bodyCount : body);
    const s = 6 * k + 3 * side;
    turned(this.pose, at + 3, origin[s], origin[s + 1], origin[s + 2], out);
    out[0] += this.pose[at];
    out[1] += this.pose[at + 1];
    out[2] += this.pose[at + 2];
    return out;
  }

  /** What can be plotted of this run. */
  quantities() {
    const energies = ["kinetic", "potential", "total", "work of other forces"];
    const levels = ["position", "velocity", "acceleration"];
    const found = [
      { id: "energy", label: "Energy", unit: "J", series: energies.map((name, i) => [name, this.row(this.energy, i)]) },
      { id: "energy error", label: "Energy error", unit: "J", log: true, series: [["|error|", this.row(this.energy, 4)]] },
      { id: "violation", label: "Violation of constraints", unit: "m or 1; m/s or 1/s; m/s² or 1/s²", log: true,
        series: levels.map((name, i) => [name, this.row(this.violation, i)]) },
    ];
    const xyz = ["x", "y", "z"];
    if (this.bodyCount) {
      found.push(
        { id: "position", label: "Position", unit: "m", of: "body", every: !this.pieces, parts: xyz, source: "track", width: 7, first: 0, from: this.origin },
        { id: "velocity", label: "Velocity", unit: "m/s", of: "body", parts: xyz, source: "v", width: 6, first: 0, norm: true },
        { id: "omega", label: "Angular velocity, body axes", unit: "rad/s", of: "body", parts: xyz, source: "v", width: 6, first: 3 },
        { id: "acceleration", label: "Acceleration", unit: "m/s²", of: "body", parts: xyz, source: "vdot", width: 6, first: 0, norm: true },
        { id: "alpha", label: "Angular acceleration, body axes", unit: "rad/s²", of: "body", parts: xyz, source: "vdot", width: 6, first: 3 },
        { id: "orientation", label: "Euler parameters", unit: "1", of: "body", every: !this.pieces, parts: ["e0", "e1", "e2", "e3"], source: "track", width: 7, first: 3 },
      );
    }
    if (this.coordinates.length) {
      found.push(
        { id: "coordinate", label: "Joint coordinate", unit: "rad or m", of: "coordinate", parts: ["value"], source: "coordinate", width: 1, first: 0 },
        { id: "rate", label: "Rate of a joint coordinate", unit: "rad/s or m/s", of: "coordinate", parts: ["rate"], source: "rate", width: 1, first: 0 },
      );
    }
    if (this.jointCount) {
      found.push(
        { id: "force", label: "Reaction force", unit: "N", of: "joint", parts: xyz, source: "force", width: 3, first: 0, norm: true },
        { id: "torque", label: "Reaction torque", unit: "N m", of: "joint", parts: xyz, source: "torque", width: 3, first: 0, norm: true },
        { id: "gap", label: "Violation of a joint", unit: "m; rad", of: "joint", log: true, parts: ["points apart"], source: "gap", width: 1, first: 0, power: true },
      );
    }
    return found;
  }

  names(kind) {
    return { body: this.bodies.names, joint: this.joints.names, coordinate: this.coordinates }[kind];
  }

  /** The largest value of a quantity of any object: below 1e-9 of it there is roundoff. */
  largestOf(quantity) {
    const own = this.quantities().find((it) => it.id === quantity.id);
    if (!own?.of || own.power) return 0;
    const { width, first } = own;
    const source = this[own.source];
    this.largest ??= new Map();
    if (!this.largest.has(own.id)) {
      let most = 0;
      for (let i = 0; i < source.length; i += width) {
        for (let c = 0; c < own.parts.length; c++) most = Math.max(most, Math.abs(source[i + first + c]));
      }
      this.largest.set(own.id, most);
    }
    return this.largest.get(own.id);
  }

  /** [name, values] of the lines of a quantity; of `object` where it belongs to bodies or joints. */
  lines(quantity, object) {
    const own = this.quantities().find((it) => it.id === quantity.id);
    if (!own) return [];
    if (!own.of) return own.series;
    const index = this.names(own.of).indexOf(object);
    const place = own.every || own.of === "coordinate" ? index : (own.of === "body" ? this.placeOfBody : this.placeOfJoint).get(index);
    if (index < 0 || place === undefined) return [];
    if (own.id === "gap" && !this.joints.held[index]) return []; // nothing that could be told from poses
    const { width, first } = own;
    const source = this[own.source];
    const channels = source.length / this.count;
    const lines = own.parts.map((part, c) => {
      const values = new Float64Array(this.count);
      const from = own.from?.[c] ?? 0;
      for (let k = 0; k < this.count; k++) values[k] = from + source[k * channels + width * place + first + c];
      return [part, own.power ? values.map((x) => 10 ** x) : values];
    });
    if (own.id === "gap") lines.push(["axes askew", Float64Array.from({ length: this.count }, (_, k) => 10 ** this.askew[k * channels + place])]);
    if (own.norm) lines.push(["magnitude", lines[0][1].map((_, k) => Math.hypot(...lines.map((l) => l[1][k])))]);
    return lines;
  }

  /** log10 of the violation of a plotted joint in the present frame [m]: angles count by the lever. */
  violationOf(place) {
    const at = this.frame * this.joints.plotted.length + place;
    return Math.max(this.gap[at], this.askew[at] + Math.log10(this.lever));
  }

  row(matrix, i) {
    return matrix.subarray(i * this.count, (i + 1) * this.count);
  }

  /** Bodies that move the most, most first; of those of which the page has the way. */
  movers(most) {
    const travel = this.#travel();
    const known = this.pieces ? this.bodies.plotted : [...this.bodies.names.keys()];
    const all = known.filter((i) => travel(i) > 0);
    return all.sort((a, b) => travel(b) - travel(a)).slice(0, most);
  }

  /** How far a body goes, or what grows with it. */
  #travel() {
    if (this.pieces?.streamed) {
      const travel = this.array("travel");
      return (i) => travel[i];
    }
    const step = this.array("q.step");
    return (i) => Math.max(step[7 * i], step[7 * i + 1], step[7 * i + 2]);
  }
}

/** out = A(p) u, p four numbers of `array` from `at` on, scalar first. */
export function turned(array, at, x, y, z, out) {
  const e0 = array[at];
  const e1 = array[at + 1];
  const e2 = array[at + 2];
  const e3 = array[at + 3];
  const a = e2 * z - e3 * y + e0 * x;
  const b = e3 * x - e1 * z + e0 * y;
  const c = e1 * y - e2 * x + e0 * z;
  out[0] = x + 2 * (e2 * c - e3 * b);
  out[1] = y + 2 * (e3 * a - e1 * c);
  out[2] = z + 2 * (e1 * b - e2 * a);
  return out;
}
