// The page: fills the tables, and fills them again as the filters say.
let roomFor = AT_ONCE;
const showAttempts = () => {
  const chosen = chosenAttempts();
  find("#attempts tbody").replaceChildren(...chosen.slice(0, roomFor).map(attemptRow));
  find("#more").hidden = chosen.length <= roomFor;
  sayChosen(chosen);
};
const choose = () => { roomFor = AT_ONCE; showAttempts(); };

const fillHead = () => {
  const headings = ["episode", "asked", "agent", "outcome", "phases", "steps", "why it is no success"];
  if (hasCauses) headings.push("cause");
  if (hasReplays) headings.push("");
  const row = make("tr");
  row.append(...headings.map((words) => Object.assign(make("th", "", words), { scope: "col" })));
  find("#attempts thead").append(row);
};

find("#about").textContent = Object.entries(DATA.about).map(([name, value]) => `${name} ${value}`).join(" · ");
find("#unlike").hidden = DATA.unlike.length === 0;
find("#unlike").textContent = `Unlike runs, so that differences are not the agents' alone: ${DATA.unlike.join("; ")}.`;
fillAgents(find("#agents"), DATA.agents);
find("#shared-part").hidden = DATA.shared.length === 0;
if (DATA.shared.length) fillAgents(find("#shared"), DATA.shared);
fillTags();
fillHead();
find("#filters").append(...FILTERS.map((filter) => makeFilter(filter, choose)), searchField(choose));
find("#filters").addEventListener("submit", (event) => event.preventDefault());
find("#more").addEventListener("click", () => { roomFor += AT_ONCE; showAttempts(); });
showAttempts();
document.documentElement.dataset.ready = Math.round(performance.now());
