// Names as people read them.
const plain = (name) => {
  const words = name.replaceAll("_", " ").toLowerCase();
  return words.charAt(0).toUpperCase() + words.slice(1);
};
// A state has one colour in all runs and both themes.
const HUES = [204, 38, 168, 322, 262, 92, 190, 288, 58, 230, 130, 345];
const stateNames = [];
const stateColours = (name) => {
  if (!stateNames.includes(name)) stateNames.push(name);
  const hue = HUES[stateNames.indexOf(name) % HUES.length];
  return { fill: `hsl(${hue} ${colour("--state-fill")})`, text: `hsl(${hue} ${colour("--state-text")})` };
};

// What a run did and said at a step.
class Diary {
  static async of(run) {
    const diary = new Diary();
    const fields = ["state", "reason", "action"];
    const arrays = await Promise.all(fields.map((field) => unpacked(run.decisions[field].steps)));
    fields.forEach((field, k) => {
      const { words } = run.decisions[field];
      diary[field] = (step) => words[arrays[k][step]];
    });
    diary.touched = await Promise.all(
      run.measures.touched.map(async ({ words, counts }) => ({ words, counts: await unpacked(counts) })),
    );
    diary.blocked = await unpacked(run.measures.blocked);
    diary.steps = run.steps;
    diary.held = run.measures.held;
    diary.reached = run.measures.reached;
    diary.story = run.story;
    return diary;
  }

  // Stretches of one state: [first step, past the last].
  stretches() {
    const found = [];
    for (let step = 0, first = 0; step < this.steps; step++) {
      if (step + 1 < this.steps && this.state(step + 1) === this.state(first)) continue;
      found.push([first, step + 1]);
      first = step + 1;
    }
    return found;
  }
}
