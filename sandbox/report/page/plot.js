// A figure over time, of one run or of both.

/** Three digits, without an exponent where that can be. */
function brief(value) {
  if (value === null || value === undefined) return "–";
  const size = Math.abs(value);
  if (value === 0) return "0";
  return size >= 1e6 || size < 1e-3 ? value.toExponential(2) : String(Number(value.toPrecision(size >= 100 ? 4 : 3)));
}

class Plot {
  constructor(canvas, field, runs, parted) {
    Object.assign(this, { canvas, field, runs, parted });
    this.dots = runs[0].checkpoints || [];
    const values = [...runs.flatMap((run) => run[field]), ...this.dots.map((dot) => dot[field])]
      .filter((value) => value !== null);
    const low = Math.min(...values), high = Math.max(...values);
    // What swings by rounding alone is a line: it would fill the picture, and look like a drift.
    const least = Math.max(1e-6 * Math.abs(high), 1e-6 * Math.abs(low), 1e-9);
    const room = high - low > least ? 0.08 * (high - low) : Math.max(Math.abs(high), 1);
    this.low = field === "deepest" ? 0 : low - room;
    this.high = high + room;
  }

  x(step) {
    const { start, end } = this.runs[0];
    return (step - start) / Math.max(end - start, 1) * this.canvas.width;
  }

  y(value) {
    return this.canvas.height - (value - this.low) / (this.high - this.low || 1) * this.canvas.height;
  }

  draw(step) {
    const context = this.canvas.getContext("2d"), pixel = devicePixelRatio, { width, height } = this.canvas;
    context.clearRect(0, 0, width, height);
    this.upright(context, 0.25, "grid-major", width, 0.25 * height);
    if (this.parted !== undefined) {
      context.fillStyle = theme("frozen");
      context.globalAlpha = 0.9;
      context.fillRect(this.x(this.parted) - pixel / 2, 0, 1.5 * pixel, height);
      context.globalAlpha = 1;
    }
    [...this.runs.entries()].reverse().forEach(([number, run]) => {
      context.strokeStyle = number ? theme("ghost") : theme(this.field === "energy" ? "drag" : "gravity");
      context.lineWidth = 1.5 * pixel;
      context.setLineDash([]);
      context.globalAlpha = number ? 0.75 : 1;
      context.beginPath();
      run[this.field].forEach((value, k) => value !== null && context.lineTo(this.x(run.stepOf(k)), this.y(value)));
      context.stroke();
    });
    context.globalAlpha = 1;
    context.fillStyle = theme("ghost");
    for (const dot of this.dots) {
      context.beginPath();
      context.arc(this.x(dot.step), this.y(dot[this.field]), 2.5 * pixel, 0, 2 * Math.PI);
      context.fill();
    }
    context.fillStyle = theme("light");
    context.globalAlpha = 0.75;
    context.fillRect(this.x(step) - pixel / 2, 0, pixel, height);
    context.globalAlpha = 1;
  }

  upright(context, share, color, width, each) {
    context.fillStyle = theme(color);
    for (let y = each; y < this.canvas.height; y += each) context.fillRect(0, Math.round(y), width, 1);
  }
}
