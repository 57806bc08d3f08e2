// The film of a run, of which one moment's picture is shown at a time.
class Film {
  constructor(pictures) {
    this.areas = pictures.areas;
    this.rate = pictures.framesPerSecond;
    this.works = false;
    this.video = document.createElement("video");
    Object.assign(this.video, { muted: true, playsInline: true, preload: "auto" });
    this.source = URL.createObjectURL(new Blob([bytesOf(pictures.film)], { type: "video/mp4" }));
  }

  // Resolves once the film can be shown, or the browser has refused it.
  open() {
    return new Promise((resolve) => {
      this.video.addEventListener("loadeddata", () => { this.works = true; resolve(); }, { once: true });
      this.video.addEventListener("error", () => resolve(), { once: true });
      this.video.src = this.source;
      this.video.load();
    });
  }

  // Resolves once the video holds the picture of a moment; the middle of its time is nobody else's.
  seek(moment) {
    const time = (moment + 0.5) / this.rate;
    if (!this.works || Math.abs(this.video.currentTime - time) < 1e-6) return Promise.resolve();
    return new Promise((resolve) => {
      this.video.addEventListener("seeked", resolve, { once: true });
      this.video.currentTime = time;
    });
  }

  draw(name, { context, width, height }) {
    const [left, top, w, h] = this.areas[name];
    context.imageSmoothingQuality = "high";
    if (this.works) context.drawImage(this.video, left, top, w, h, 0, 0, width, height);
    else this.apologise(context, width, height);
  }

  apologise(context, width, height) {
    context.clearRect(0, 0, width, height);
    context.fillStyle = colour("--soft");
    context.font = "13px system-ui, sans-serif";
    context.textAlign = "center";
    context.fillText("no H.264 in this browser", width / 2, height / 2, width - 10);
  }
}

// The names of the segments, written over the picture as sharp as the screen is.
class SegmentNames {
  static async of({ words, counts, places }) {
    const names = new SegmentNames();
    names.words = words;
    names.places = await unpacked(places);
    names.starts = startsOf(await unpacked(counts));
    return names;
  }

  // The foremost come last: they are written first, and what would cover them is left out.
  draw(moment, { context, width, height }) {
    const taken = [[4, 6, 84]]; // the caption
    context.font = "600 11px system-ui, sans-serif";
    context.textBaseline = "middle";
    context.textAlign = "left";
    for (let k = this.starts[moment + 1] - 1; k >= this.starts[moment]; k--) {
      const [number, u, v] = this.places.subarray(3 * k, 3 * k + 3);
      const [words, part] = this.words[number];
      const wide = context.measureText(words).width + 10;
      const left = Math.min(Math.max((u / 1000) * width - wide / 2, 2), Math.max(width - wide - 2, 2));
      const top = Math.min(Math.max((v / 1000) * height - 8, 2), height - 18);
      const covers = ([l, t, w]) => left < l + w && l < left + wide && Math.abs(top - t) < 17;
      if (taken.some(covers)) continue;
      taken.push([left, top, wide]);
      context.fillStyle = "rgb(14 17 20 / 78%)";
      context.beginPath();
      context.roundRect(left, top, wide, 16, 4);
      context.fill();
      context.fillStyle = { object: "#ff7ab4", start: "#ffc25a", goal: "#6fdc98", other: "#e9ecef" }[part];
      context.fillText(words, left + 5, top + 8.5);
    }
  }
}
