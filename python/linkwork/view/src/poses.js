// The poses of a run, frame by frame: 7 numbers a body. Of many bodies they are in pieces of some frames, which are taken
// when the time comes to them: out of the page, where they are deflated, or from the server that shows it.

const KEPT = 4; // pieces that are out at once
const MEMORY = 192e6; // for those from a server [bytes]
const MOST = 64; // of them, however small they are
const AHEAD = 8; // of them that are asked for before the time comes to them
const AT_ONCE = 2; // questions to a server

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
  /** `frames` in all, `each` a piece, `width` numbers a frame; `take(number, signal)` promises the numbers of a piece. */
  constructor({ frames, each, width, take, kept = KEPT, ahead = 1 }) {
    Object.assign(this, { frames, each, width, take, kept, ahead, out: new Map(), coming: new Map() });
    this.arrived = () => {};
    this.error = null; // of a piece that could not be taken
  }

  /** Deflated in the page, channel by channel in differences: `unpack(number)` promises the bytes; `low`, `step` of each. */
  static inPage({ frames, each, low, step, unpack }) {
    const width = low.length;
    const take = async (number) => {
      const size = width * Math.min(each, frames - number * each);
      return decoded(new Uint16Array(await unpack(number), 0, size), low, step);
    };
    return new PosePieces({ frames, each, width, take });
  }

  /** From a server: `fetched(number, signal)` promises the bytes of float32. */
  static served({ frames, each, width, fetched }) {
    const kept = Math.min(Math.max(Math.floor(MEMORY / (4 * width * each)), KEPT), MOST);
    const take = async (number, signal) => new Float32Array(await fetched(number, signal));
    return new PosePieces({ frames, each, width, take, kept, ahead: Math.min(AHEAD, kept - 3) });
  }

  /** When the first frame is out. */
  ready() {
    return this.#fetch(0);
  }

  /** As of Poses, or null where the piece is still to be taken; `arrived` is called when it is there. */
  frame(k) {
    const number = Math.floor(k / this.each);
    const values = this.out.get(number);
    if (!values) {
      this.#forgetAll((other) => other < number || other > number + this.ahead);
      this.#fetch(number);
      return null;
    }
    this.out.delete(number); // the last in the map is the last that was used
    this.out.set(number, values);
    return { values, at: (k - number * this.each) * this.width };
  }

  /** Have the pieces after that of a frame taken, too, nearest first: a motion that plays comes to them next. */
  expect(k) {
    const now = Math.floor(k / this.each);
    const last = Math.min(now + this.ahead, Math.ceil(this.frames / this.each) - 1);
    for (let next = now + 1; next <= last && this.coming.size < AT_ONCE; next++) if (!this.out.has(next)) this.#fetch(next);
  }

  #fetch(number) {
    if (!this.coming.has(number)) {
      const ender = new AbortController();
      this.coming.set(number, { ender, done: this.error ? Promise.resolve() : this.#taken(number, ender.signal) });
    }
    return this.coming.get(number).done;
  }

  /** What was asked for and is of no use any more: the time went elsewhere. */
  #forgetAll(useless) {
    for (const [number, { ender }] of this.coming) {
      if (!useless(number)) continue;
      ender.abort();
      this.coming.delete(number);
    }
  }

  async #taken(number, signal) {
    try {
      const values = await this.take(number, signal);
      if (signal.aborted) return;
      while (this.out.size >= this.kept) this.out.delete(this.out.keys().next().value);
      this.out.set(number, values);
    } catch (error) {
      if (signal.aborted) return;
      this.error = error;
    }
    this.coming.delete(number);
    this.arrived();
  }
}

/** Channel by channel in differences, to numbers frame by frame. */
function decoded(differences, low, step) {
  const width = low.length;
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
