// One player: a viewport, a bar of controls and two plots.

function make(tag, kind, into, words = "") {
  const element = document.createElement(tag);
  element.className = kind;
  element.textContent = words;
  into.append(element);
  return element;
}

const SPEEDS = [0.05, 0.1, 0.25, 0.5, 1, 2, 4];

class Player {
  constructor(root, film, ghost) {
    const parted = root.dataset.parted === undefined ? undefined : Number(root.dataset.parted);
    const names = JSON.parse(root.dataset.names || "[]");
    Object.assign(this, { root, film, ghost, parted, step: film.start, playing: false, moment: 0 });
    root.textContent = "";
    this.picture = make("div", "picture", root);
    this.canvas = make("canvas", "view", this.picture);
    this.label = make("div", "label", this.picture);
    this.legend = make("div", "legend", this.picture);
    this.viewport = new Viewport(this.canvas, film, ghost, { parted, names, endOnly: root.dataset.endOnly !== undefined });
    this.buildBar();
    this.buildPlots();
    this.listen();
    // A failure is shown from shortly before the runs part.
    this.seek(parted === undefined ? film.start : Math.max(film.start, parted - 1));
    root.dataset.ready = "1";
  }

  buildBar() {
    const bar = make("div", "bar", this.root);
    this.button = this.addButton(bar, "▶", "Play or pause (space)", () => this.toggle());
    this.addButton(bar, "‹", "One step back (←)", () => this.stepBy(-1));
    this.addButton(bar, "›", "One step on (→)", () => this.stepBy(1));
    const track = make("div", "track", bar);
    this.slider = make("input", "slider", track);
    Object.assign(this.slider, { type: "range", min: this.film.start, max: this.film.end, step: 1 });
    this.slider.setAttribute("aria-label", "step");
    this.slider.addEventListener("input", () => this.seek(Number(this.slider.value)));
    this.addTicks(track);
    this.count = make("output", "count", bar);
    this.speed = make("select", "speed", bar);
    SPEEDS.forEach((speed) => this.speed.add(new Option(`${speed}×`, speed, speed === 1, speed === 1)));
    this.speed.title = "Speed";
    if (this.parted !== undefined) this.addButton(bar, "⚑", "To where the runs part", () => this.seek(this.parted), "flag");
    if (this.ghost) this.ghostButton = this.addButton(bar, "ghost", "Show the expected run", () => this.flipGhost(), "on");
    this.addButton(bar, "fit", "The first view again (double click)", () => this.fit());
  }

  addButton(bar, words, title, act, kind = "") {
    const button = make("button", kind, bar, words);
    Object.assign(button, { type: "button", title });
    button.addEventListener("click", act);
    return button;
  }

  /** Marks on the track: commands, and in red where the runs part. */
  addTicks(track) {
    const { start, end, commands } = this.film, length = Math.max(end - start, 1);
    const tick = (kind, step, title) => {
      const mark = make("i", kind, track);
      mark.style.setProperty("--at", (step - start) / length);
      mark.title = title;
    };
    const steps = new Map();
    commands.filter(([step]) => step >= start && step <= end)
      .forEach(([step, words]) => steps.set(step, [...(steps.get(step) || []), words]));
    this.told = steps;
    [...steps].slice(0, 300).forEach(([step, words]) => tick("command", step, `step ${step}: ${words.join(", ")}`));
    if (this.parted !== undefined) tick("mark", this.parted, `the runs part at step ${this.parted}`);
  }

  buildPlots() {
    const runs = this.ghost && !this.viewport.options.endOnly ? [this.film, this.ghost] : [this.film];
    const grid = make("div", "plots", this.root);
    this.plots = [["energy", "energy", "J"], ["deepest", "deepest overlap", "m"]].map(([field, words, unit]) => {
      const figure = make("figure", "plot", grid), head = make("figcaption", "", figure);
      make("span", "", head, words);
      const value = make("b", "", head), canvas = make("canvas", "curve", figure);
      const seek = (event) => event.buttons && this.seek(this.film.start + Math.round(
        event.offsetX / canvas.clientWidth * (this.film.end - this.film.start)));
      canvas.addEventListener("pointerdown", seek);
      canvas.addEventListener("pointermove", seek);
      return { plot: new Plot(canvas, field, runs, this.parted), value, unit, field, runs };
    });
  }

  listen() {
    const { canvas, viewport } = this;
    const at = (event) => [event.offsetX * devicePixelRatio, event.offsetY * devicePixelRatio];
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      viewport.zoomAt(Math.exp(-event.deltaY * 0.0015), ...at(event));
      this.draw();
    }, { passive: false });
    canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener("pointermove", (event) => {
      if (event.buttons) viewport.pan(event.movementX * devicePixelRatio, event.movementY * devicePixelRatio);
      this.pointer = at(event);
      this.draw();
    });
    canvas.addEventListener("pointerleave", () => { this.pointer = undefined; this.draw(); });
    canvas.addEventListener("dblclick", () => this.fit());
    this.root.tabIndex = 0;
    this.root.addEventListener("keydown", (event) => this.key(event));
    new ResizeObserver(() => this.resize()).observe(this.root);
    this.resize();
  }

  key(event) {
    if (event.target.tagName === "SELECT" || event.ctrlKey || event.metaKey || event.altKey) return;
    const acts = {
      " ": () => this.toggle(), ArrowLeft: () => this.stepBy(event.shiftKey ? -10 : -1),
      ArrowRight: () => this.stepBy(event.shiftKey ? 10 : 1), Home: () => this.seek(this.film.start),
      End: () => this.seek(this.film.end), g: () => this.ghost && this.flipGhost(), f: () => this.fit(),
    };
    if (!acts[event.key]) return;
    event.preventDefault();
    acts[event.key]();
  }

  resize() {
    for (const canvas of this.root.querySelectorAll("canvas")) {
      canvas.width = Math.max(1, Math.round(canvas.clientWidth * devicePixelRatio));
      canvas.height = Math.max(1, Math.round(canvas.clientHeight * devicePixelRatio));
    }
    this.draw();
  }

  fit() {
    this.viewport.reset();
    this.draw();
  }

  flipGhost() {
    this.viewport.showGhost = !this.viewport.showGhost;
    this.ghostButton.classList.toggle("on", this.viewport.showGhost);
    this.draw();
  }

  stepBy(count) {
    this.pause();
    const { every, start } = this.film;
    this.seek(start + Math.round((this.step - start) / every + count) * every);
  }

  seek(step) {
    this.step = Math.min(Math.max(step, this.film.start), this.film.end);
    this.draw();
  }

  toggle() {
    if (this.playing) return this.pause();
    if (this.step >= this.film.end) this.step = this.film.start;
    this.playing = true;
    this.moment = performance.now();
    this.button.textContent = "❚❚";
    requestAnimationFrame((now) => this.play(now));
  }

  pause() {
    this.playing = false;
    this.button.textContent = "▶";
    this.step = Math.floor(this.step);
    this.draw();
  }

  play(now) {
    if (!this.playing) return;
    const seconds = Math.min(Math.max(now - this.moment, 0) / 1000, 0.25);
    this.moment = now;
    this.seek(this.step + seconds * this.film.rate * Number(this.speed.value));
    if (this.step >= this.film.end) return this.pause();
    requestAnimationFrame((later) => this.play(later));
  }

  draw() {
    if (!this.plots) return;
    const whole = Math.floor(this.step), sample = this.film.sampleAt(whole);
    // Where every step was kept, only those are shown; else what lies between two is made up.
    this.viewport.draw(this.film.every === 1 ? whole : this.step);
    this.slider.value = whole;
    this.root.dataset.step = whole;
    this.slider.style.setProperty("--at", (whole - this.film.start) / Math.max(this.film.end - this.film.start, 1));
    this.count.textContent = `step ${whole} / ${this.film.end}`;
    this.label.textContent = this.words(whole, sample);
    this.label.classList.toggle("parted", this.parted !== undefined && whole >= this.parted);
    this.drawLegend();
    for (const { plot, value, unit, field, runs } of this.plots) {
      plot.draw(whole);
      value.textContent = runs.map((run) => `${brief(run[field][run.sampleAt(whole)])} ${unit}`).join(" · expected ");
    }
  }

  words(step, sample) {
    const { film } = this, told = this.told.get(step);
    const parts = [`${(step / film.rate).toFixed(2)} s`, `${film.contacts[sample]} contact${film.contacts[sample] === 1 ? "" : "s"}`, `${film.awake[sample]} awake`];
    parts.push(...[film.scoreAt(step)].filter(Boolean));
    if (this.parted !== undefined && step >= this.parted) parts.push(`parted at step ${this.parted}`);
    if (told) parts.push(told.slice(0, 3).join(", ") + (told.length > 3 ? " …" : ""));
    if (step >= film.end && film.cut) parts.push(film.cut);
    return parts.join("  ·  ");
  }

  /** The body under the pointer. */
  drawLegend() {
    const row = this.pointer && this.viewport.bodyAt(...this.pointer, this.step);
    this.legend.hidden = row === undefined;
    if (row === undefined) return;
    const [x, y, angle] = this.film.pose(row, this.step);
    this.legend.textContent = `${this.film.bodies[row].id}   ${x.toFixed(3)}, ${y.toFixed(3)} m   ${(angle * 180 / Math.PI).toFixed(1)}°`;
  }
}
