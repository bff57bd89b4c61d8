// Joints as strokes over the bodies: a light stroke on a dark one, so that they show on any colour.

/** A point in a body's frame, in pixels; body -1 is the world. */
function placed(viewport, body, [x, y], step) {
  if (body < 0) return viewport.pixel(x, y);
  const [bx, by, angle] = viewport.film.pose(body, step), c = Math.cos(angle), s = Math.sin(angle);
  return viewport.pixel(bx + c * x - s * y, by + s * x + c * y);
}

function along([ax, ay], [bx, by], share, side) {
  const length = Math.hypot(bx - ax, by - ay) || 1;
  return [ax + share * (bx - ax) - side * (by - ay) / length, ay + share * (by - ay) + side * (bx - ax) / length];
}

function zigzag(a, b, side) {
  const inner = Array.from({ length: 14 }, (_, k) => along(a, b, 0.12 + 0.76 * (k + 0.5) / 14, k % 2 ? -side : side));
  return [a, along(a, b, 0.12, 0), ...inner, along(a, b, 0.88, 0), b];
}

/** A rope of a length in pixels: straight when taut, else a parabola. */
function rope(a, b, length) {
  const distance = Math.hypot(b[0] - a[0], b[1] - a[1]);
  if (length <= 1.001 * distance) return [a, b];
  const sag = Math.min(Math.sqrt(0.375 * Math.max(distance, 0.25 * length) * (length - distance)), 0.5 * length);
  return Array.from({ length: 15 }, (_, k) => {
    const [x, y] = along(a, b, k / 14, 0);
    return [x, y + 4 * sag * (k / 14) * (1 - k / 14)];
  });
}

/** Lines [points, width] and dots [point, radius] of one joint, in pixels. */
function strokes(viewport, joint, step, size) {
  const [bodyA, bodyB] = joint.bodies;
  const a = placed(viewport, bodyA, joint.a, step), b = placed(viewport, bodyB, joint.b, step);
  const ends = [[a, 0.7 * size], [b, 0.7 * size]];
  const looks = {
    pin: () => [[], [[b, size]]],
    weld: () => [[-1, 1].map((k) => [[[b[0] - size, b[1] - k * size], [b[0] + size, b[1] + k * size]], 0.55 * size]), []],
    rod: () => [[[[a, b], 0.75 * size]], ends],
    spring: () => [[[zigzag(a, b, 1.6 * size), 0.45 * size]], ends],
    rope: () => [[[rope(a, b, joint.length * viewport.scale), 0.5 * size]], ends],
    rail: () => {
      const at = (k) => placed(viewport, bodyA, [joint.a[0] + k * joint.axis[0], joint.a[1] + k * joint.axis[1]], step);
      return [[[joint.ends.map(at), 0.5 * size]], [[b, size]]];
    },
    pulley: () => {
      const [one, two] = joint.wheels.map((wheel) => viewport.pixel(...wheel));
      return [[[[a, one, two, b], 0.45 * size]], [[one, 1.6 * size], [two, 1.6 * size]]];
    },
    goal: () => {
      const to = joint.inside ? [joint.a[0] + joint.wheels[0][0], joint.a[1] + joint.wheels[0][1]] : joint.wheels[0];
      return [[[[placed(viewport, joint.inside ? bodyA : -1, to, step), b], 0.3 * size]], [[b, 0.6 * size]]];
    },
  };
  return looks[joint.look]();
}

function drawJoints(viewport, step) {
  const { context, film } = viewport, sample = film.sampleAt(step), pixel = devicePixelRatio;
  const size = Math.min(Math.max(0.09 * viewport.scale, 1.2 * pixel), 4.5 * pixel);
  const held = film.joints.filter((joint) => joint.look && isOn(joint.held, sample));
  const all = held.map((joint) => strokes(viewport, joint, step, size));
  viewport.leave();
  context.lineCap = context.lineJoin = "round";
  for (const [color, more] of [["ink", 1.6 * pixel], ["joint", 0]]) {
    context.strokeStyle = context.fillStyle = theme(color);
    for (const [lines, dots] of all) {
      for (const [points, width] of lines) {
        context.lineWidth = width + more;
        context.beginPath();
        points.forEach((point) => context.lineTo(...point));
        context.stroke();
      }
      for (const [point, radius] of dots) {
        context.beginPath();
        context.arc(...point, radius + more / 2, 0, 2 * Math.PI);
        context.fill();
      }
    }
  }
  context.lineJoin = "miter";
}
