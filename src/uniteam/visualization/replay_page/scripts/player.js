// Where in time the page is. Films are sought, not played: so all pictures, of both runs, are always of one moment.
const STEPS_PER_SECOND = 10;

class Player {
  constructor(runs, last, onShow, onState) {
    Object.assign(this, { runs, last, onShow, onState });
    this.wanted = 0;
    this.shown = -1;
    this.speed = 1;
    this.isPlaying = false;
    this.isBusy = false;
  }

  goTo(moment) {
    this.wanted = Math.min(Math.max(Math.round(moment), 0), this.last);
    this.position = this.wanted;
    return this.pump();
  }

  // Shows the moment that is wanted, and on until none is; those that came too fast to be shown are passed over.
  async pump() {
    if (this.isBusy) return;
    this.isBusy = true;
    while (this.shown !== this.wanted) {
      const moment = this.wanted;
      await Promise.all(this.runs.map((run) => run.seek(moment)));
      this.shown = moment;
      this.onShow(moment);
    }
    this.isBusy = false;
  }

  toggle() {
    if (this.isPlaying) return this.pause();
    if (this.wanted === this.last) this.goTo(0);
    this.isPlaying = true;
    this.position = this.wanted;
    this.time = performance.now();
    this.onState();
    requestAnimationFrame((now) => this.tick(now));
  }

  pause() {
    this.isPlaying = false;
    this.onState();
  }

  tick(now) {
    if (!this.isPlaying) return;
    this.position += (Math.max(now - this.time, 0) / 1000) * STEPS_PER_SECOND * this.speed;
    this.time = now;
    this.wanted = Math.min(Math.floor(this.position), this.last);
    this.pump();
    if (this.wanted === this.last) this.pause();
    else requestAnimationFrame((next) => this.tick(next));
  }
}
