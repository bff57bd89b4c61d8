// Films: unpacking, and what is where at a step.

/** The bytes of base64 of deflated ones. */
async function inflate(text) {
  const packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Places and angles of all samples, body by body, from base64 of a deflated text of byte planes (see pack.py). */
async function unpack(data) {
  const bodies = data.bodies, samples = data.energy.length, size = bodies.length * samples;
  const columns = [new Float64Array(size), new Float64Array(size), new Float64Array(size)];
  if (!size) return columns;
  const bytes = await inflate(data.poses);
  columns.forEach((column, number) => {
    const low = number * 4 * size;
    bodies.forEach((body, row) => {
      const quantum = body.quantum[number < 2 ? 0 : 1];
      let speed = 0, place = 0;
      for (let i = row * samples; i < (row + 1) * samples; i++) {
        const at = low + i;
        const code = bytes[at] | bytes[at + size] << 8 | bytes[at + 2 * size] << 16 | bytes[at + 3 * size] << 24;
        speed = (speed + (code >>> 1 ^ -(code & 1))) | 0;
        place = (place + speed) | 0;
        column[i] = body.from[number] + place * quantum;
      }
    });
  });
  return columns;
}

/** Whether something is on at a sample, given the samples at which it changes. */
function isOn(changes, sample) {
  let on = false;
  for (const change of changes) {
    if (change > sample) break;
    on = !on;
  }
  return on;
}

/** A film that can be asked for any step, from what `packed` in film_data.py wrote. */
class Film {
  static async open(name) {
    const [facts, poses] = document.getElementById(name).textContent.trim().split("\n");
    const data = JSON.parse(new TextDecoder().decode(await inflate(facts)));
    data.poses = poses || "";
    return new Film(data, await unpack(data));
  }

  constructor(data, columns) {
    Object.assign(this, data);
    this.columns = columns;
    this.samples = data.energy.length;
    this.shapes = data.bodies.map((body) => new BodyShape(body));
    this.rows = new Map(data.bodies.map((body, row) => [body.id, row]));
    this.order = data.bodies.map((_, row) => row).sort((a, b) => this.shapes[a].rank - this.shapes[b].rank);
  }

  /** The last sample that is not after a step. */
  sampleAt(step) {
    if (step >= this.end) return this.samples - 1;
    return Math.max(0, Math.min(Math.floor((step - this.start) / this.every), this.samples - 2));
  }

  stepOf(sample) {
    return Math.min(this.start + sample * this.every, this.end);
  }

  /** Place and angle of a body; between samples, on the straight way from one to the next. */
  pose(row, step) {
    const sample = this.sampleAt(step), i = row * this.samples + sample, before = this.stepOf(sample);
    const share = sample + 1 < this.samples ? (step - before) / (this.stepOf(sample + 1) - before) : 0;
    return this.columns.map((column) => column[i] + (share > 0 ? share * (column[i + 1] - column[i]) : 0));
  }

  isThere(row, step) {
    return isOn(this.bodies[row].there, this.sampleAt(step));
  }

  fieldsAt(step) {
    return this.lastOf(this.fields, step, [[], []]);
  }

  /** The counters of a game and how it ended, in words. */
  scoreAt(step) {
    return this.lastOf(this.score, step, "");
  }

  /** What was last noted, of pairs of a sample and what is so from then on. */
  lastOf(notes, step, before) {
    const sample = this.sampleAt(step);
    return notes.reduce((found, [first, now]) => (first <= sample ? now : found), before);
  }
}
