// The page: builds the runs, and leads buttons, keys and the address to the player.
const SPEEDS = [0.5, 1, 2, 4, 8, 16];
const runs = DATA.runs.map((data, number) => new Run(data, number));
const last = Math.max(...runs.map((run) => run.last));
const truth = find("#truth"), main = find("#runs");

const sayTask = () => {
  const { object, start, goal } = DATA.instruction;
  find("#task").append("Move ", make("b", "object", object), " from ", make("b", "start", start), " to ", make("b", "goal", goal));
};

const sayParting = () => {
  if (!DATA.parting) return;
  const { action, decision } = DATA.parting;
  const button = find("#parting");
  const doing = (run) => (action < run.last ? run.diary.action(action) : "nothing more");
  if (action === null) button.append("Both do the same to the end.");
  else button.append("First other action at ", make("b", "", `step ${action}`), `: ${runs.map(doing).join(" | ")}`);
  if (decision !== null && decision !== action) button.append(`; other words from step ${decision}`);
  button.hidden = false;
};
const parting = DATA.parting && (DATA.parting.action ?? DATA.parting.decision);

const fillSpeeds = () => {
  for (const speed of SPEEDS) {
    const label = make("label"), radio = make("input");
    Object.assign(radio, { type: "radio", name: "speed", value: speed, checked: speed === 1 });
    label.append(radio, make("span", "number", `${speed === 0.5 ? "½" : speed}×`));
    find("#speeds").append(label);
  }
};
const fillLegend = (legend) => {
  for (const [name, words] of LEGEND) {
    const line = make("li"), swatch = make("i");
    swatch.style.background = `var(${name})`;
    line.append(swatch, words);
    legend.append(line);
  }
};

const start = async () => {
  sayTask();
  fillSpeeds();
  main.classList.toggle("two", runs.length === 2);
  main.append(...runs.map((run) => run.root));
  for (const legend of document.querySelectorAll(".legend")) fillLegend(legend);
  await Promise.all(runs.map((run) => run.open()));
  sayParting();
  const maps = runs.flatMap((run) => run.map ?? []);
  for (const map of maps) map.view = viewOf(maps);
  for (const story of document.querySelectorAll(".story")) story.open = runs.length === 1 || innerWidth > 760;
  find("#last").textContent = last;

  const timeline = new Timeline(find("#timeline"), runs, last, parting);
  const show = (moment) => {
    for (const run of runs) run.show(moment, truth.checked);
    timeline.show(moment);
    find("#step").textContent = moment;
  };
  const showState = () => {
    const words = player.isPlaying ? "Pause" : "Play";
    find("#play").classList.toggle("playing", player.isPlaying);
    find("#play").setAttribute("aria-label", words);
    find("#play").title = `${words} (space)`;
    if (!player.isPlaying) keepAddress();
  };
  const player = new Player(runs, last, show, showState);
  // The address names the step, so that it can be sent to somebody.
  const keepAddress = () => {
    try { history.replaceState(null, "", `#step=${player.wanted}`); } catch { /* not for every file */ }
  };
  const jump = (moment) => {
    const before = player.isPlaying;
    player.goTo(moment);
    if (!before) keepAddress();
  };
  const drawAgain = () => {
    timeline.draw();
    if (player.shown >= 0) show(player.shown);
  };
  timeline.onScrub = jump;

  const news = [...new Set(runs.flatMap((run) => run.diary.story.map(({ step }) => step)))].sort((a, b) => a - b);
  const toNews = {
    before: () => jump(news.findLast((step) => step < player.wanted) ?? 0),
    after: () => jump(news.find((step) => step > player.wanted) ?? last),
  };
  const radios = [...document.querySelectorAll("#speeds input")];
  const setSpeed = (number) => {
    const radio = radios[Math.min(Math.max(number, 0), radios.length - 1)];
    radio.checked = true;
    player.speed = Number(radio.value);
  };
  const enlarge = (name) => {
    if (main.dataset.large === name) delete main.dataset.large;
    else main.dataset.large = name;
    drawAgain();
  };
  const toggleTruth = () => { truth.checked = !truth.checked; drawAgain(); };

  const clicks = {
    play: () => player.toggle(), back: () => jump(player.wanted - 1), on: () => jump(player.wanted + 1),
    before: toNews.before, after: toNews.after, help: () => find("#keys").showModal(), parting: () => jump(parting ?? last),
  };
  for (const [name, act] of Object.entries(clicks)) find(`#${name}`).addEventListener("click", act);
  for (const radio of radios) radio.addEventListener("change", () => setSpeed(radios.indexOf(radio)));
  truth.addEventListener("change", drawAgain);
  main.addEventListener("click", (event) => {
    const chapter = event.target.closest("[data-step]"), figure = event.target.closest("[data-picture]");
    if (chapter) jump(Number(chapter.dataset.step));
    if (figure) enlarge(figure.dataset.picture);
  });

  const speedNow = () => radios.findIndex((radio) => radio.checked);
  const keys = {
    " ": () => player.toggle(), Home: () => jump(0), End: () => jump(last),
    n: toNews.after, p: toNews.before, d: () => parting !== null && jump(parting), t: toggleTruth, l: switchTheme,
    "+": () => setSpeed(speedNow() + 1), "=": () => setSpeed(speedNow() + 1), "-": () => setSpeed(speedNow() - 1),
    "?": () => find("#keys").showModal(), Escape: () => { if (main.dataset.large) enlarge(main.dataset.large); },
  };
  PICTURES.forEach((name, k) => { keys[k + 1] = () => enlarge(name); });
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || find("#keys").open) return;
    const isTyping = event.target.matches("input[type=radio]") && event.key.startsWith("Arrow");
    const presses = event.target.matches("button, summary, input") && event.key === " ";
    if (isTyping || presses) return;
    const by = { ArrowLeft: -1, ArrowRight: 1, ArrowDown: -1, ArrowUp: 1, PageDown: -50, PageUp: 50 }[event.key];
    const isOnLine = event.target.id === "timeline";
    const act = by && (isOnLine || event.key.match(/Left|Right/)) ? () => jump(player.wanted + by * (event.shiftKey ? 10 : 1)) : keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!act) return;
    event.preventDefault();
    act();
  });

  whenThemed.push(() => { for (const run of runs) run.map?.paint(); drawAgain(); });
  new ResizeObserver(drawAgain).observe(main);
  new ResizeObserver(() => {
    main.style.setProperty("--controls-height", `${find(".controls").offsetHeight}px`);
    drawAgain();
  }).observe(find(".controls"));
  const fromAddress = () => Number(location.hash.match(/^#step=(\d+)$/)?.[1] ?? 0);
  addEventListener("hashchange", () => player.goTo(fromAddress()));
  timeline.draw();
  await player.goTo(fromAddress());
  main.removeAttribute("aria-busy");
  document.documentElement.dataset.ready = Math.round(performance.now());
};
start();
