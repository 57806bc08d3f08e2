// One run: its pictures, its words and its story, all of the same moment.
const PICTURES = ["camera", "segmentation", "third_person", "map"];

class Run {
  constructor(data, number) {
    this.data = data;
    this.number = number;
    this.last = data.steps;
    this.moment = 0;
    this.root = find("#run").content.cloneNode(true).firstElementChild;
    this.root.style.setProperty("--run", `var(--run-${number})`);
    this.canvases = Object.fromEntries(PICTURES.map((name) => [name, find(`[data-picture="${name}"] canvas`, this.root)]));
    this.fillHead();
  }

  fillHead() {
    const { agent, success, failure, about } = this.data;
    find("h2", this.root).textContent = agent;
    const chip = find(".chip", this.root);
    chip.textContent = success ? "success" : "failed";
    chip.classList.toggle("good", success);
    find(".failure", this.root).textContent = find(".failure", this.root).title = failure;
    find(".about", this.root).textContent =
      `${about.split} · ${about.episode} · perception ${about.perception} · ${about.camera}-size camera · uniteam ${about.uniteam}`;
  }

  async open() {
    this.film = new Film(this.data.pictures);
    const parts = await Promise.all([
      this.film.open(), Diary.of(this.data), SegmentNames.of(this.data.pictures.names),
      this.data.map && RobotMap.of(this.data),
    ]);
    [, this.diary, this.names, this.map] = parts;
    this.fillMeasures();
    this.fillStory();
    this.data.pictures.film = "";
  }

  fillMeasures() {
    const { reached, touched } = this.diary;
    this.lamps = reached.map(({ words }) => make("li", "", words));
    find(".measures", this.root).append(...this.lamps);
    this.touches = touched.map(() => make("li"));
    find(".touches", this.root).append(...this.touches);
  }

  fillStory() {
    this.chapters = this.diary.story.map(({ step, kind, words }) => {
      const line = make("li"), button = make("button", `news ${kind}`);
      button.type = "button";
      button.dataset.step = step;
      button.append(make("span", "at number", String(step)), make("span", "", kind === "state" ? storyState(words) : words));
      line.append(button);
      return line;
    });
    find(".story ol", this.root).append(...this.chapters);
  }

  seek(moment) {
    return this.film.seek(Math.min(moment, this.last));
  }

  // Draws everything as it is at a moment, whose picture the film already holds.
  show(moment, withTruth) {
    this.moment = Math.min(moment, this.last);
    this.withTruth = withTruth;
    this.drawPictures();
    this.writeNow();
    this.markChapter();
    this.root.classList.toggle("over", moment >= this.last);
  }

  drawPictures() {
    for (const name of ["camera", "segmentation", "third_person"]) {
      const screen = fitted(this.canvases[name]);
      this.film.draw(name, screen);
      if (name === "segmentation") this.names.draw(this.moment, screen);
    }
    if (this.map) this.map.draw(this.moment, this.withTruth, fitted(this.canvases.map));
    this.nameCanvases();
  }

  nameCanvases() {
    const { agent } = this.data, at = `of ${agent} at step ${this.moment}`;
    const names = { camera: "Head camera", segmentation: "Perception", third_person: "Third person", map: "Map" };
    for (const [name, words] of Object.entries(names)) this.canvases[name].setAttribute("aria-label", `${words} ${at}`);
  }

  writeNow() {
    const { diary, moment, last } = this, step = Math.min(moment, last - 1), isOver = moment === last;
    const say = (selector, words) => { find(selector, this.root).textContent = words; };
    const state = find(".state", this.root), { fill, text } = stateColours(diary.state(step));
    Object.assign(state.style, { background: fill, color: text });
    say(".state", plain(diary.state(step)));
    say(".action", isOver ? "the episode is over" : diary.action(step));
    say(".reason", isOver ? this.data.failure || "The object lies where it was asked for." : diary.reason(step));
    const done = moment - 1;
    this.lamps.forEach((lamp, k) => {
      const at = diary.reached[k].step;
      lamp.classList.toggle("lit", at !== null && at <= done);
    });
    diary.touched.forEach(({ words, counts }, k) => {
      const count = done < 0 ? 0 : counts[done];
      this.touches[k].textContent = `${words}: ${count} ${count === 1 ? "step" : "steps"}`;
      this.touches[k].hidden = count === 0;
    });
  }

  markChapter() {
    const now = this.diary.story.findLastIndex(({ step }) => step <= this.moment);
    if (now === this.chapter) return;
    this.chapters[this.chapter]?.firstChild.removeAttribute("aria-current");
    this.chapter = now;
    const line = this.chapters[now];
    if (!line) return;
    line.firstChild.setAttribute("aria-current", "step");
    const list = line.parentElement;
    list.scrollTop = line.offsetTop - list.offsetTop - list.clientHeight / 3;
  }
}

// "NAV_TO_OBJECT: why" as "Nav to object: why".
const storyState = (words) => {
  const end = words.indexOf(": ");
  return end < 0 ? words : plain(words.slice(0, end)) + words.slice(end);
};
