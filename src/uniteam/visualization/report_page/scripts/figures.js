// Figures with their intervals, as words and as bars.
const agentColour = (number) => `hsl(${[176, 262, 30, 205, 330, 95, 0, 230][number % 8]} var(--agent-tone))`;
const digits = (value, count) => value.toLocaleString("en", { minimumFractionDigits: count, maximumFractionDigits: count });

const figureCell = (heading, [mean, low, high]) => {
  const cell = make("td", "figure number");
  const places = heading === "Steps" ? 0 : 1;
  cell.append(make("b", "", digits(mean, places)), make("span", "", `${digits(low, 0)}–${digits(high, 0)}`));
  return cell;
};

// A dot in its interval, on a scale from 0 to 100.
const intervalBar = ([mean, low, high], number, words) => {
  const bar = make("div", "bar");
  bar.setAttribute("role", "img");
  bar.setAttribute("aria-label", `${words}${digits(mean, 1)} percent, from ${digits(low, 0)} to ${digits(high, 0)}`);
  const interval = make("i"), dot = make("b");
  Object.assign(interval.style, { left: `${low}%`, width: `${high - low}%`, background: agentColour(number) });
  Object.assign(dot.style, { left: `${mean}%`, background: agentColour(number) });
  bar.append(interval, dot);
  return bar;
};

// Wilson's score interval (1927), as the terminal has it.
const wilson = (successes, trials) => {
  const z = 1.959963984540054, share = successes / trials, weight = (z * z) / trials;
  const centre = (share + weight / 2) / (1 + weight);
  const half = (z * Math.sqrt((share * (1 - share)) / trials + weight / (4 * trials))) / (1 + weight);
  return [share, successes ? centre - half : 0, successes < trials ? centre + half : 1].map((value) => 100 * value);
};

const agentName = (number) => {
  const name = make("span", "agent"), swatch = make("i");
  swatch.style.background = agentColour(number);
  name.append(swatch, DATA.agents[number].label);
  return name;
};

const fillAgents = (table, agents) => {
  const headings = Object.keys(agents[0].cells), row = make("tr");
  const head = (words) => Object.assign(make("th", "", words), { scope: "col" });
  row.append(head("agent"), head("overall"), ...headings.map(head), head("episodes"));
  find("thead", table).append(row);
  agents.forEach(({ cells, episodes, crashed, label }, number) => {
    const line = make("tr"), name = Object.assign(make("th"), { scope: "row" }), bar = make("td", "bar-cell");
    name.append(agentName(number));
    bar.append(intervalBar(cells.Overall, number, `${label}, overall success: `));
    const count = make("td", "figure number");
    count.append(make("b", "", String(episodes)), make("span", "bad", crashed ? `${crashed} crashed` : ""));
    line.append(name, bar, ...headings.map((heading) => figureCell(heading, cells[heading])), count);
    find("tbody", table).append(line);
  });
};

const fillTags = () => {
  find("#tags-section").hidden = DATA.tags.length === 0;
  for (const { title, groups } of DATA.tags) {
    const card = make("article", "card");
    card.append(make("h3", "", title));
    for (const { heading, agents } of groups) {
      const group = make("div", "group");
      group.append(make("p", "", heading));
      agents.forEach((figure, number) => {
        if (!figure) return;
        const line = make("div", "tag-line");
        line.append(intervalBar(figure.success, number, `${DATA.agents[number].label}, ${heading}: `),
          make("span", "number", digits(figure.success[0], 0)), make("small", "number", `of ${figure.count}`));
        group.append(line);
      });
      card.append(group);
    }
    find("#tags").append(card);
  }
};
