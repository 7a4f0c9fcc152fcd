// The poses of a run, frame by frame: 7 numbers a body. Of many bodies they stay in the page, deflated in pieces of some
// frames, and are taken out when the time comes to them.

const KEPT = 4; // pieces that are out at once

/** Numbers that are there at once. */
export class Poses {
  constructor(values, width) {
    Object.assign(this, { values, width });
  }

  async ready() {}

  /** {values, at}: the numbers of frame k begin at `at`. */
  frame(k) {
    return { values: this.values, at: k * this.width };
  }
}

export class PosePieces {
  /** `frames` in all, `each` a piece; `take(number)` promises the bytes of one; `low`, `step`: of each channel. */
  constructor({ frames, each, low, step, take }) {
    Object.assign(this, { frames, each, low, step, take, width: low.length, out: new Map(), coming: new Map() });
    this.arrived = () => {};
    this.error = null; // of a piece that could not be taken out
  }

  /** When the first frame is out. */
  ready() {
    return this.#fetch(0);
  }

  /** As of Poses, or null where the piece is still in the page; `arrived` is called when it is out. */
  frame(k) {
    const number = Math.floor(k / this.each);
    const values = this.out.get(number);
    if (!values) {
      this.#fetch(number);
      return null;
    }
    this.out.delete(number); // the last in the map is the last that was used
    this.out.set(number, values);
    return { values, at: (k - number * this.each) * this.width };
  }

  /** Have the piece after that of a frame taken out, too: a motion that plays comes to it next. */
  expect(k) {
    const next = Math.floor(k / this.each) + 1;
    if (next * this.each < this.frames && !this.out.has(next)) this.#fetch(next);
  }

  #fetch(number) {
    if (!this.coming.has(number)) this.coming.set(number, this.error ? Promise.resolve() : this.#taken(number));
    return this.coming.get(number);
  }

  async #taken(number) {
    try {
      const whole = new Uint16Array(await this.take(number), 0, this.width * Math.min(this.each, this.frames - number * this.each));
      while (this.out.size >= KEPT) this.out.delete(this.out.keys().next().value);
      this.out.set(number, this.#decoded(whole));
    } catch (error) {
      this.error = error;
    } finally {
      this.coming.delete(number);
    }
    this.arrived();
  }

  /** Channel by channel in differences, to numbers frame by frame. */
  #decoded(differences) {
    const { width, low, step } = this;
    const frames = differences.length / width;
    const values = new Float32Array(differences.length);
    for (let c = 0; c < width; c++) {
      let whole = 0;
      for (let k = 0; k < frames; k++) {
        whole = (whole + differences[c * frames + k]) & 0xffff;
        values[k * width + c] = low[c] + step[c] * whole;
      }
    }
    return values;
  }
}
