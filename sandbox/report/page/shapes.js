// Bodies as paths in their own frames, and their colours.

const css = getComputedStyle(document.documentElement);
const theme = (name) => css.getPropertyValue(`--${name}`).trim();

/** `#rrggbb` moved towards another colour by 0..1. */
function mixed(color, other, amount) {
  const parts = (text) => [1, 3, 5].map((i) => parseInt(text.slice(i, i + 2), 16));
  const [a, b] = [parts(color), parts(other)];
  return "#" + a.map((part, i) => Math.round(part + (b[i] - part) * amount).toString(16).padStart(2, "0")).join("");
}

/** The outline of a convex core [x, y, x, y, ...], counter-clockwise, with a radius about it. */
function traceCore(path, core, radius) {
  const count = core.length / 2;
  if (count === 1) {
    path.moveTo(core[0] + radius, core[1]);
    path.arc(core[0], core[1], radius, 0, 2 * Math.PI);
    return;
  }
  for (let k = 0; k < count; k++) {
    const [x, y] = [core[2 * k], core[2 * k + 1]];
    const next = (2 * k + 2) % core.length, before = (2 * k - 2 + core.length) % core.length;
    if (!radius) {
      k ? path.lineTo(x, y) : path.moveTo(x, y);
      continue;
    }
    const into = Math.atan2(y - core[before + 1], x - core[before]) - Math.PI / 2;
    const out = Math.atan2(core[next + 1] - y, core[next] - x) - Math.PI / 2;
    if (!k) path.moveTo(x + radius * Math.cos(into), y + radius * Math.sin(into));
    path.arc(x, y, radius, into, out);
  }
  path.closePath();
}

function traceRing(path, ring) {
  for (let i = 0; i < ring.length; i += 2) i ? path.lineTo(ring[i], ring[i + 1]) : path.moveTo(ring[i], ring[i + 1]);
  path.closePath();
}

/** What a body looks like. */
class BodyShape {
  constructor(body) {
    this.parts = body.shapes.map(({ sensor, line }) => ({ path: new Path2D(), sensor, line }));
    this.marks = new Path2D();
    const sensor = body.shapes.length > 0 && body.shapes.every((shape) => shape.sensor);
    this.moves = !body.static;
    this.half = body.half;
    this.reach = body.reach;
    this.rank = sensor ? 0 : body.static ? 1 : 2;
    body.shapes.forEach((shape, number) => {
      const { path } = this.parts[number];
      if (shape.rings) shape.rings.forEach((ring) => traceRing(path, ring));
      else traceCore(path, shape.core, shape.radius);
      if (body.marked && !shape.sensor) {
        this.marks.moveTo(shape.mark[0], shape.mark[1]);
        this.marks.lineTo(shape.mark[2], shape.mark[3]);
      }
    });
    this.awake = this.colors(body.fill, body.static);
    this.asleep = body.marked ? this.colors(mixed(body.fill, theme("background"), 0.26), false) : this.awake;
    this.frozen = this.colors(theme("frozen"), false);
  }

  colors(fill, still) {
    return { fill, edge: mixed(fill, theme("light"), still ? 0.22 : 0.32), mark: mixed(fill, theme("ink"), 0.55) };
  }

  looks(body, sample) {
    if (body.frozen && isOn(body.frozen, sample)) return this.frozen;
    return isOn(body.awake, sample) ? this.awake : this.asleep;
  }
}
