// Every attempt, and the filters that choose among them.
const AT_ONCE = 200;
const hasCauses = DATA.attempts.some(({ cause }) => cause);
const hasReplays = DATA.attempts.some(({ replay }) => replay);

const FILTERS = [
  { name: "agent", all: "all agents", of: ({ agent }) => DATA.agents[agent].label },
  { name: "outcome", all: "any outcome", of: ({ success }) => (success ? "success" : "failed") },
  { name: "missed", all: "any phase missed", of: ({ reached }) => DATA.phases[reached.indexOf(false)] ?? "" },
  { name: "cause", all: "any cause", of: ({ cause }) => cause?.cause ?? "" },
  { name: "style", all: "any style", of: ({ style }) => style },
  { name: "category", all: "seen and unseen", of: ({ unseen }) => (unseen ? "unseen" : "seen") },
  { name: "home", all: "all homes", of: ({ home }) => home },
];

const makeFilter = ({ name, all, of }, onChange) => {
  const values = [...new Set(DATA.attempts.map(of))].filter(Boolean).sort();
  const label = make("label", "", ""), select = make("select");
  label.append(make("span", "hidden-words", name), select);
  select.name = name;
  select.append(new Option(all, ""), ...values.map((value) => new Option(value, value)));
  select.addEventListener("change", onChange);
  label.hidden = values.length < 2;
  return label;
};

const searchField = (onInput) => {
  const label = make("label"), field = make("input");
  Object.assign(field, { type: "search", name: "words", placeholder: "words, such as cup or CRASHED" });
  field.addEventListener("input", onInput);
  label.append(make("span", "hidden-words", "words"), field);
  return label;
};

const chosenAttempts = () => {
  const form = find("#filters"), words = form.elements.words.value.toLowerCase();
  const wanted = FILTERS.filter(({ name }) => form.elements[name].value);
  return DATA.attempts.filter((attempt) =>
    wanted.every(({ name, of }) => of(attempt) === form.elements[name].value) &&
    `${attempt.episode} ${attempt.asked} ${attempt.failure} ${attempt.home}`.toLowerCase().includes(words));
};

const lamps = ({ reached }) => {
  const cell = make("td", "lamps");
  const told = DATA.phases.filter((_, k) => reached[k]);
  cell.setAttribute("aria-label", told.length ? `reached: ${told.join(", ")}` : "reached nothing");
  cell.title = told.join(", ") || "nothing";
  cell.append(...reached.map((is) => make("i", is ? "lit" : "")));
  return cell;
};

const replayCell = ({ replay, episode, agent, cause }) => {
  const cell = make("td", "replay");
  if (!replay) return cell;
  const link = make("a", "", "replay");
  link.href = replay + (cause?.step != null ? `#step=${cause.step}` : "");
  link.setAttribute("aria-label", `Replay of ${episode} by ${DATA.agents[agent].label}`);
  cell.append(link);
  return cell;
};

const attemptRow = (attempt) => {
  const row = make("tr"), name = Object.assign(make("th"), { scope: "row" }), asked = make("td"), agent = make("td");
  name.append(make("span", "", attempt.episode), make("small", "", attempt.home));
  asked.append(make("span", "", attempt.asked), make("small", "", attempt.unseen ? "unseen" : ""));
  agent.append(agentName(attempt.agent));
  const outcome = make("td"), why = make("td", "why");
  outcome.append(make("span", attempt.success ? "chip good" : "chip", attempt.success ? "success" : attempt.crashed ? "crashed" : "failed"));
  why.textContent = attempt.failure;
  const cause = make("td", "cause");
  if (attempt.cause) cause.append(make("b", "", attempt.cause.cause), make("small", "", attempt.cause.words));
  row.append(name, asked, agent, outcome, lamps(attempt), make("td", "figure number", String(attempt.steps)), why);
  if (hasCauses) row.append(cause);
  if (hasReplays) row.append(replayCell(attempt));
  return row;
};

const sayChosen = (chosen) => {
  const parts = DATA.agents.map(({ label }, number) => {
    const own = chosen.filter(({ agent }) => agent === number), good = own.filter(({ success }) => success).length;
    if (!own.length) return "";
    const [mean, low, high] = wilson(good, own.length);
    return `${label} ${digits(mean, 1)} % (${digits(low, 0)}–${digits(high, 0)}) of ${own.length}`;
  });
  const what = parts.filter(Boolean).join(" · ");
  find("#shown").textContent = chosen.length ? `Overall success of what is chosen: ${what}` : "No episode is so.";
};
