// The line of time: a lane for each run with its states, and what happened above it.
const BAND = 18, NEWS = 22, NAME = 15, AXIS = 18, SIDE = 10;

class Timeline {
  constructor(root, runs, last, parting) {
    Object.assign(this, { root, runs, last, parting });
    this.canvas = find("canvas", root);
    this.head = find(".playhead", root);
    this.tip = find(".tip", root);
    this.lane = BAND + NEWS + (runs.length > 1 ? NAME : 4);
    this.canvas.style.height = `${runs.length * this.lane + AXIS}px`;
    root.setAttribute("aria-valuemax", last);
    for (const name of ["pointerdown", "pointermove", "pointerleave"]) root.addEventListener(name, (event) => this.follow(event));
  }

  x(step) {
    return SIDE + (step / this.last) * (this.width - 2 * SIDE);
  }

  stepAt(event) {
    const share = (event.clientX - this.root.getBoundingClientRect().left - SIDE) / (this.width - 2 * SIDE);
    return Math.round(Math.min(Math.max(share, 0), 1) * this.last);
  }

  follow(event) {
    if (event.type === "pointerleave") this.tip.hidden = true;
    if (event.type === "pointerdown") this.root.setPointerCapture(event.pointerId);
    if (event.type !== "pointerleave" && event.buttons & 1) this.onScrub(this.stepAt(event));
    if (event.type === "pointermove") this.tell(event);
  }

  // Says what is under the pointer.
  tell(event) {
    const step = this.stepAt(event);
    const lines = this.runs.map((run) => {
      const at = Math.min(step, run.last - 1), name = this.runs.length > 1 ? `${run.data.agent}: ` : "";
      return name + (step >= run.last ? "over" : plain(run.diary.state(at)));
    });
    const news = this.runs.flatMap((run) => run.diary.story.filter((n) => n.kind !== "state" && Math.abs(this.x(n.step) - this.x(step)) < 4));
    this.tip.replaceChildren(make("b", "number", `step ${step}`), ...lines.map((line) => make("span", "", line)),
      ...news.slice(0, 3).map(({ kind, words }) => make("span", kind, words)));
    this.tip.hidden = false;
    const half = this.tip.offsetWidth / 2;
    this.tip.style.left = `${Math.min(Math.max(this.x(step), half + 4), this.width - half - 4)}px`;
  }

  draw() {
    const screen = fitted(this.canvas);
    this.width = screen.width;
    screen.context.clearRect(0, 0, screen.width, screen.height);
    this.runs.forEach((run, lane) => this.drawLane(screen.context, run, lane * this.lane));
    this.drawAxis(screen.context, this.runs.length * this.lane);
    if (this.parting) this.drawParting(screen);
  }

  drawLane(context, run, top) {
    const band = top + this.lane - BAND - 4;
    context.font = "600 11px system-ui, sans-serif";
    context.textBaseline = "middle";
    context.textAlign = "left";
    context.fillStyle = colour(`--run-${run.number}`);
    if (this.runs.length > 1) context.fillText(run.data.agent, this.x(0), top + 9);
    for (const [first, past] of run.diary.stretches()) {
      const name = run.diary.state(first), { fill, text } = stateColours(name);
      const left = this.x(first), wide = Math.max(this.x(past) - left - 1, 1);
      context.fillStyle = fill;
      context.beginPath();
      context.roundRect(left, band, wide, BAND, Math.min(4, wide / 2));
      context.fill();
      const words = plain(name);
      if (context.measureText(words).width + 12 > wide) continue;
      context.fillStyle = text;
      context.fillText(words, left + 6, band + BAND / 2 + 0.5);
    }
    this.drawNews(context, run, band - 9);
  }

  // Trouble below, success above it: what matters more is not covered.
  drawNews(context, run, y) {
    const colours = { trouble: colour("--bad"), success: colour("--good"), action: colour("--soft") };
    for (const kind of ["action", "trouble", "success"]) {
      for (const { step } of run.diary.story.filter((news) => news.kind === kind)) {
        context.fillStyle = colours[kind];
        context.beginPath();
        if (kind === "trouble") context.rect(this.x(step) - 1, y - 3, 2, 8);
        else context.arc(this.x(step), y, kind === "success" ? 4 : 2.5, 0, 2 * Math.PI);
        context.fill();
      }
    }
  }

  drawAxis(context, top) {
    const apart = [10, 20, 50, 100, 200, 500].find((n) => (n / this.last) * this.width > 56) ?? 1000;
    context.font = "11px system-ui, sans-serif";
    context.textBaseline = "top";
    context.textAlign = "center";
    context.fillStyle = context.strokeStyle = colour("--soft");
    for (let step = 0; step <= this.last; step += apart) {
      context.fillRect(Math.round(this.x(step)), top - 1, 1, 4);
      const isLast = this.x(step) > this.width - 24;
      context.textAlign = step === 0 ? "left" : isLast ? "right" : "center";
      context.fillText(String(step), this.x(step) + (step === 0 ? -3 : isLast ? 3 : 0), top + 5);
    }
  }

  drawParting({ context, height }) {
    const x = Math.round(this.x(this.parting)) + 0.5;
    context.strokeStyle = colour("--accent");
    context.lineWidth = 1.5;
    context.setLineDash([4, 3]);
    context.beginPath();
    context.moveTo(x, 2); context.lineTo(x, height - AXIS);
    context.stroke();
    context.setLineDash([]);
  }

  show(moment) {
    this.head.style.transform = `translateX(${this.x(moment)}px)`;
    this.root.setAttribute("aria-valuenow", moment);
    const states = this.runs.map((run) => (moment >= run.last ? "over" : plain(run.diary.state(moment))));
    this.root.setAttribute("aria-valuetext", `step ${moment} of ${this.last}: ${states.join(", ")}`);
  }
}
