// The time of the page: it plays, is moved, and tells everyone who listens.

export class Player {
  constructor(runs) {
    this.runs = runs;
    this.start = Math.min(...runs.map((run) => run.start));
    this.end = Math.max(...runs.map((run) => run.end));
    this.time = this.start;
    this.playing = false;
    this.listeners = [];
    this.zooms = []; // listeners to `zoom`
    this.part = null; // of the time that plots show; null: all
    this.speeds = speeds(this.end - this.start);
    this.speed = usualSpeed(this.end - this.start, this.speeds);
    this.secondShown = true;
    for (const { poses } of runs) poses.arrived = () => this.seek(this.time);
  }

  /** Frames of the present time are still being taken out of the page. */
  get behind() {
    return this.runs.some((run) => run.behind && !run.poses.error);
  }

  /** Whether a run takes part. */
  visible(run) {
    return run === this.runs[0] || this.secondShown;
  }

  listen(listener) {
    this.listeners.push(listener);
  }

  /** Plots show this part of the time. */
  zoom(from, to) {
    this.part = [from, to];
    for (const listener of this.zooms) listener(this.part);
  }

  seek(time) {
    this.time = Math.min(Math.max(time, this.start), this.end);
    for (const run of this.runs) run.seek(this.time);
    for (const listener of this.listeners) listener();
  }

  /** To the next (1) or last (-1) frame of the first run, or further. */
  step(frames) {
    this.pause();
    const run = this.runs[0];
    this.seek(run.t[Math.min(Math.max(run.nearest(this.time) + frames, 0), run.count - 1)]);
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  pause() {
    this.playing = false;
    for (const listener of this.listeners) listener();
  }

  play() {
    if (this.end <= this.start) return;
    if (this.time >= this.end) this.seek(this.start);
    this.playing = true;
    let before = performance.now();
    const tick = (now) => {
      if (!this.playing) return;
      const time = this.time + (this.behind ? 0 : (this.speed * (now - before)) / 1000); // it waits for frames
      before = now;
      if (time >= this.end) this.playing = false;
      this.seek(time);
      if (this.playing) requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  }
}

/** Speeds from which a run takes two minutes to those at which it takes a second, and 1. */
function speeds(duration) {
  const found = [];
  for (let power = -9; power <= 9; power++) {
    for (const step of [1, 2, 5]) {
      const speed = step * 10 ** power;
      if (speed === 1 || (duration / speed <= 120 && duration / speed >= 1)) found.push(Number(speed.toPrecision(1)));
    }
  }
  return found;
}

/** As it is, unless that is too short or too long to watch. */
function usualSpeed(duration, known) {
  if (duration >= 1 && duration <= 30) return 1;
  const wanted = duration / 8;
  return known.reduce((best, it) => (Math.abs(Math.log(it / wanted)) < Math.abs(Math.log(best / wanted)) ? it : best), known[0]);
}
