// The picture: a camera over the plane, and everything that is drawn through it.

/**
 * Device pixels: an outline that is thinner is left out. Of thousands of bodies each is a few pixels large, and most of
 * what their picture took was cutting off at their edges what nobody sees.
 */
const UNSEEN = 1;

class Viewport {
  constructor(canvas, film, ghost, options) {
    Object.assign(this, { canvas, film, ghost, options });
    this.context = canvas.getContext("2d");
    this.showGhost = true;
    this.reset();
  }

  reset() {
    const [x, y, height] = this.film.view;
    Object.assign(this, { x, y, height, zoom: 1 });
  }

  /** Device pixels a metre. */
  get scale() {
    const { width, height } = this.canvas;
    return this.zoom * Math.min(height / this.height, width / (this.height * 16 / 9));
  }

  /** A point of the plane in device pixels. */
  pixel(x, y) {
    return [(x - this.x) * this.scale + this.canvas.width / 2, (this.y - y) * this.scale + this.canvas.height / 2];
  }

  metres(px, py) {
    return [(px - this.canvas.width / 2) / this.scale + this.x, this.y - (py - this.canvas.height / 2) / this.scale];
  }

  zoomAt(factor, px, py) {
    const [x, y] = this.metres(px, py);
    this.zoom = Math.min(Math.max(this.zoom * factor, 1e-4), 1e6);
    const [nx, ny] = this.metres(px, py);
    this.x += x - nx;
    this.y += y - ny;
  }

  pan(dx, dy) {
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
  }

  /** From here on, coordinates are those of a body. */
  enter([x, y, angle]) {
    const [px, py] = this.pixel(x, y), c = Math.cos(angle) * this.scale, s = Math.sin(angle) * this.scale;
    this.context.setTransform(c, -s, -s, -c, px, py);
  }

  leave() {
    this.context.setTransform(1, 0, 0, 1, 0, 0);
  }

  inSight(pose, reach) {
    const [px, py] = this.pixel(pose[0], pose[1]), far = reach * this.scale + 4;
    return px > -far && py > -far && px < this.canvas.width + far && py < this.canvas.height + far;
  }

  draw(step) {
    const { context, film } = this;
    this.leave();
    context.globalAlpha = 1;
    context.fillStyle = theme("background");
    context.fillRect(0, 0, this.canvas.width, this.canvas.height);
    this.drawGrid();
    const [regions, flames] = film.fieldsAt(step);
    film.order.forEach((row) => this.drawBody(row, step));
    regions.forEach((region) => this.drawRegion(region));
    flames.forEach((flame) => this.drawFlame(flame, step));
    drawJoints(this, step);
    if (this.options.parted !== undefined && step >= this.options.parted) this.drawSuspects(step);
    if (this.ghost && this.showGhost) this.drawGhosts(step);
    this.leave();
  }

  drawGrid() {
    const { context, scale, canvas } = this;
    const unit = 10 ** Math.ceil(Math.log10(14 * devicePixelRatio / scale));
    const [left, top] = this.metres(0, 0), [right, bottom] = this.metres(canvas.width, canvas.height);
    const rank = (k) => (k === 0 ? 2 : k % 10 === 0 ? 1 : 0);
    for (const level of [0, 1, 2]) {
      context.fillStyle = theme(["grid-minor", "grid-major", "grid-axis"][level]);
      for (let k = Math.ceil(left / unit); k <= right / unit; k++)
        if (rank(k) === level) context.fillRect(Math.floor(this.pixel(k * unit, 0)[0]), 0, 1, canvas.height);
      for (let k = Math.ceil(bottom / unit); k <= top / unit; k++)
        if (rank(k) === level) context.fillRect(0, Math.floor(this.pixel(0, k * unit)[1]), canvas.width, 1);
    }
  }

  drawBody(row, step) {
    const { context, film, scale } = this, shape = film.shapes[row];
    const pose = film.pose(row, step);
    if (!film.isThere(row, step) || !this.inSight(pose, shape.reach)) return;
    const looks = shape.looks(film.bodies[row], film.sampleAt(step)), half = shape.half * scale;
    this.enter(pose);
    context.fillStyle = looks.fill;
    context.strokeStyle = looks.edge;
    shape.parts.forEach((part) => this.drawPart(part, half));
    const shown = Math.min(Math.max((half / devicePixelRatio - 3) / 5, 0), 1);
    if (shown > 0) {
      context.globalAlpha = shown;
      context.strokeStyle = looks.mark;
      context.lineCap = "round";
      context.lineWidth = Math.min(0.16 * half, 2 * devicePixelRatio) / scale;
      context.stroke(shape.marks);
    }
    context.globalAlpha = 1;
  }

  drawPart({ path, sensor, line }, half) {
    const { context, scale } = this;
    context.globalAlpha = sensor ? 0.15 : 1;
    if (!line) context.fill(path, "evenodd");
    const widest = (sensor ? 1 : 2.8) * devicePixelRatio;
    const edge = line ? Math.max(2 * half, 2 * devicePixelRatio) : Math.min(0.32 * half, widest);
    const inside = !line && !sensor; // the outline lies inside, as in the window
    if (inside && edge < UNSEEN) return;
    context.save();
    if (inside) context.clip(path, "evenodd");
    context.lineWidth = Math.max(edge, 0.6) / scale;
    context.globalAlpha = sensor ? 0.6 : 1;
    context.stroke(path);
    context.restore();
  }

  /** The other run, where it is visibly elsewhere. */
  drawGhosts(step) {
    const { context, ghost, film, scale } = this;
    if (this.options.endOnly && step < this.options.parted) return;
    context.strokeStyle = context.fillStyle = theme("ghost");
    ghost.order.forEach((row) => {
      const shape = ghost.shapes[row], pose = ghost.pose(row, step), own = film.rows.get(ghost.bodies[row].id);
      if (!shape.moves || !ghost.isThere(row, step) || !this.inSight(pose, shape.reach)) return;
      if (own !== undefined && film.isThere(own, step) && this.looksLike(pose, film.pose(own, step), shape)) return;
      this.enter(pose);
      const solid = shape.parts.filter((part) => !part.sensor);
      context.globalAlpha = 0.13;
      solid.forEach((part) => context.fill(part.path, "evenodd"));
      context.globalAlpha = 0.9;
      context.setLineDash([5 * devicePixelRatio / scale, 3.5 * devicePixelRatio / scale]);
      context.lineWidth = 1.4 * devicePixelRatio / scale;
      solid.forEach((part) => context.stroke(part.path));
    });
    context.setLineDash([]);
    context.globalAlpha = 1;
  }

  looksLike(a, b, shape) {
    const away = Math.hypot(a[0] - b[0], a[1] - b[1]) + Math.abs(a[2] - b[2]) * shape.reach;
    return away * this.scale < 0.7 * devicePixelRatio;
  }

  /** A red outline about the bodies where the runs part. */
  drawSuspects(step) {
    const { context, film } = this;
    context.strokeStyle = theme("frozen");
    context.lineJoin = "round";
    context.lineWidth = 3 * devicePixelRatio / this.scale;
    for (const name of this.options.names || []) {
      const row = film.rows.get(name);
      if (row === undefined || !film.isThere(row, step) || !film.shapes[row].moves) continue;
      this.enter(film.pose(row, step));
      film.shapes[row].parts.forEach((part) => context.stroke(part.path));
    }
    context.lineJoin = "miter";
  }

  drawRegion(region) {
    const { context } = this, points = region.area;
    this.leave();
    context.beginPath();
    for (let i = 0; i < points.length; i += 2) context.lineTo(...this.pixel(points[i], points[i + 1]));
    context.closePath();
    context.globalAlpha = 0.13;
    context.fillStyle = region.color;
    context.fill();
    if (region.level !== undefined) {
      const xs = points.filter((_, i) => i % 2 === 0);
      context.globalAlpha = 0.8;
      context.strokeStyle = region.color;
      context.lineWidth = 2 * devicePixelRatio;
      context.beginPath();
      context.moveTo(...this.pixel(Math.min(...xs), region.level));
      context.lineTo(...this.pixel(Math.max(...xs), region.level));
      context.stroke();
    }
    context.globalAlpha = 1;
  }

  drawFlame([row, x, y, jetX, jetY], step) {
    const { context, film, scale } = this;
    const length = Math.min(Math.max(0.6 * scale, 6 * devicePixelRatio), 60 * devicePixelRatio) / scale;
    this.enter(film.pose(row, step));
    context.lineCap = "round";
    for (const [part, width, color, alpha] of [[1, 0.35, "flame", 0.45], [0.6, 0.16, "light", 0.8]]) {
      context.globalAlpha = alpha;
      context.strokeStyle = theme(color);
      context.lineWidth = width * length;
      context.beginPath();
      context.moveTo(x, y);
      context.lineTo(x + part * length * jetX, y + part * length * jetY);
      context.stroke();
    }
    context.globalAlpha = 1;
  }

  /** The id of the body under a pixel, the one drawn last first. */
  bodyAt(px, py, step) {
    const { film, context } = this;
    const found = [...film.order].reverse().find((row) => {
      if (!film.isThere(row, step)) return false;
      this.enter(film.pose(row, step));
      return film.shapes[row].parts.some((part) => context.isPointInPath(part.path, px, py, "evenodd"));
    });
    this.leave();
    return found;
  }
}
