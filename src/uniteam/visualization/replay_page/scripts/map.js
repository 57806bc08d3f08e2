// The robot's map at any step: the changes of a step are XORed, so that they lead on and back.
const ROBOT_RADIUS = 0.17, SMALLEST_VIEW = 5, MARGIN = 0.5;

class RobotMap {
  static async of(run) {
    const map = new RobotMap();
    const [fields, robot] = await Promise.all([unpackedFields(run.map), unpackedFields(run.robot)]);
    Object.assign(map, fields, robot);
    map.truth = run.truth;
    map.starts = startsOf(map.counts);
    map.pointStarts = startsOf(map.lengths);
    map.labels = new Uint8Array(map.rows * map.columns);
    map.next = 0;
    map.picture = document.createElement("canvas");
    Object.assign(map.picture, { width: map.columns, height: map.rows });
    map.pixels = new ImageData(map.columns, map.rows);
    map.box = map.wholeBox();
    map.view = viewOf([map]);
    map.paint();
    return map;
  }

  // What is ever known, and wherever the robot ever is: the map does not jump while it grows.
  wholeBox() {
    let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
    const take = (x, y) => {
      [left, right] = [Math.min(left, x), Math.max(right, x)];
      [low, high] = [Math.min(low, y), Math.max(high, y)];
    };
    const [x0, y0] = this.origin;
    this.eachChange(0, this.counts.length, (cell) => {
      take(x0 + (cell % this.columns) * this.cellSize, y0 + Math.floor(cell / this.columns) * this.cellSize);
    });
    for (let k = 0; k < this.poses.length; k += 4) take(this.poses[k], this.poses[k + 1]);
    return [left, right, low, high];
  }

  eachChange(first, past, change) {
    for (let step = first; step < past; step++) {
      let cell = 0;
      for (let k = this.starts[step]; k < this.starts[step + 1]; k++) change((cell += this.ways[k]), this.changes[k]);
    }
  }

  // Has the labels be those behind the decision of a step.
  goTo(step) {
    const past = step + 1;
    if (past === this.next) return;
    this.eachChange(Math.min(past, this.next), Math.max(past, this.next), (cell, change) => {
      this.labels[cell] ^= change;
      this.paintCell(cell);
    });
    this.next = past;
    this.picture.getContext("2d").putImageData(this.pixels, 0, 0);
  }

  paint() {
    const probe = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
    this.palette = Array.from({ length: 9 }, (_, label) => {
      probe.fillStyle = colour(`--map-${label}`);
      probe.fillRect(0, 0, 1, 1);
      return probe.getImageData(0, 0, 1, 1).data;
    });
    for (let cell = 0; cell < this.labels.length; cell++) this.paintCell(cell);
    this.picture.getContext("2d").putImageData(this.pixels, 0, 0);
  }

  paintCell(cell) {
    const row = this.rows - 1 - Math.floor(cell / this.columns);
    this.pixels.data.set(this.palette[this.labels[cell]] ?? this.palette[0], 4 * (row * this.columns + (cell % this.columns)));
  }

  draw(moment, withTruth, { context, width, height }) {
    const step = Math.min(moment, this.counts.length - 1);
    this.goTo(step);
    const { x, y, size } = this.view;
    const scale = Math.min(width, height) / size;
    const at = (px, py) => [width / 2 + (px - x) * scale, height / 2 - (py - y) * scale];
    const pen = { context, at, scale };
    context.fillStyle = colour("--map-0");
    context.fillRect(0, 0, width, height);
    context.imageSmoothingEnabled = false;
    const [left, top] = at(this.origin[0], this.origin[1] + this.rows * this.cellSize);
    context.drawImage(this.picture, left, top, this.columns * this.cellSize * scale, this.rows * this.cellSize * scale);
    this.drawTrail(pen, moment);
    this.drawPlan(pen, step);
    if (withTruth) this.drawTruth(pen, moment);
    this.drawRobot(pen, moment);
    drawScale(pen, width, height);
  }

  list(number) {
    return this.points.subarray(2 * this.pointStarts[number], 2 * this.pointStarts[number + 1]);
  }

  drawTrail({ context, at }, moment) {
    context.lineJoin = "round";
    context.lineWidth = 1.5;
    context.strokeStyle = colour("--map-robot");
    context.globalAlpha = 0.55;
    context.beginPath();
    for (let k = 0; k <= moment; k++) context.lineTo(...at(this.poses[4 * k], this.poses[4 * k + 1]));
    context.stroke();
    context.globalAlpha = 1;
  }

  drawPlan({ context, at }, step) {
    const goal = this.list(this.goal[step]), path = this.list(this.path[step]);
    context.fillStyle = colour("--map-goal");
    for (let k = 0; k < goal.length; k += 2) {
      const [u, v] = at(goal[k] / 100, goal[k + 1] / 100);
      context.fillRect(u - 1.25, v - 1.25, 2.5, 2.5);
    }
    context.strokeStyle = colour("--map-path");
    context.lineWidth = 2.5;
    context.beginPath();
    for (let k = 0; k < path.length; k += 2) context.lineTo(...at(path[k] / 100, path[k + 1] / 100));
    context.stroke();
    const [x, y] = this.shortTerm.subarray(2 * step, 2 * step + 2);
    if (Number.isNaN(x)) return;
    context.beginPath();
    context.arc(...at(x, y), 4.5, 0, 2 * Math.PI);
    context.stroke();
  }

  drawRobot({ context, at, scale }, moment) {
    const [x, y, heading, looking] = this.poses.subarray(4 * moment, 4 * moment + 4);
    const [u, v] = at(x, y), radius = Math.max(ROBOT_RADIUS * scale, 4.5);
    const cone = context.createRadialGradient(u, v, 0, u, v, 1.6 * scale);
    cone.addColorStop(0, "rgb(31 111 224 / 45%)");
    cone.addColorStop(1, "rgb(31 111 224 / 0%)");
    context.fillStyle = cone;
    context.beginPath();
    context.moveTo(u, v);
    context.arc(u, v, 1.6 * scale, -looking - 0.37, -looking + 0.37);
    context.fill();
    context.beginPath();
    context.arc(u, v, radius, 0, 2 * Math.PI);
    context.fillStyle = colour("--map-robot");
    context.strokeStyle = "#fff";
    context.lineWidth = 1.5;
    context.fill();
    context.stroke();
    context.beginPath();
    context.moveTo(u, v);
    context.lineTo(u + Math.cos(heading) * radius, v - Math.sin(heading) * radius);
    context.stroke();
  }

  drawTruth(pen, moment) {
    for (const moves of this.truth.objects) {
      const [, x, y] = moves.findLast(([from]) => from <= moment);
      drawRing(pen, x, y, colour("--map-8"));
    }
    for (const [x, y] of this.truth.goals) drawRing(pen, x, y, colour("--map-7"));
  }
}

// The square that shows all of some maps.
const viewOf = (maps) => {
  const extreme = (k, choose) => choose(...maps.map(({ box }) => box[k]));
  const [left, right] = [extreme(0, Math.min), extreme(1, Math.max)];
  const [low, high] = [extreme(2, Math.min), extreme(3, Math.max)];
  const size = Math.max(right - left, high - low, SMALLEST_VIEW - 2 * MARGIN) + 2 * MARGIN;
  return { x: (left + right) / 2, y: (low + high) / 2, size };
};

const drawRing = ({ context, at }, x, y, fill) => {
  const [u, v] = at(x, y);
  context.beginPath();
  context.moveTo(u, v - 7); context.lineTo(u + 7, v); context.lineTo(u, v + 7); context.lineTo(u - 7, v);
  context.closePath();
  context.fillStyle = fill;
  context.strokeStyle = colour("--map-truth");
  context.lineWidth = 2;
  context.fill();
  context.stroke();
};

const drawScale = ({ context, scale }, width, height) => {
  const metres = [1, 2, 5, 10].find((m) => m * scale > 36) ?? 20;
  const right = width - 12, bottom = height - 12, left = right - metres * scale;
  context.strokeStyle = context.fillStyle = colour("--soft");
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(left, bottom - 4); context.lineTo(left, bottom); context.lineTo(right, bottom); context.lineTo(right, bottom - 4);
  context.stroke();
  context.font = "11px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "bottom";
  context.fillText(`${metres} m`, (left + right) / 2, bottom - 3);
};

const LEGEND = [
  ["--map-0", "unknown"], ["--map-1", "free"], ["--map-2", "visited"], ["--map-3", "obstacle"], ["--map-4", "collision"],
  ["--map-5", "frontier"], ["--map-6", "start receptacle"], ["--map-7", "goal receptacle"], ["--map-8", "object"],
  ["--map-path", "path"], ["--map-goal", "goal"], ["--map-robot", "robot, its view"],
];
