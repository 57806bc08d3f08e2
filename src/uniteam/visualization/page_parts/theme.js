// Light or dark: as the system has it, until the button is pressed; then as it was left.
const make = (tag, name = "", words = "") => {
  const made = document.createElement(tag);
  if (name) made.className = name;
  made.textContent = words;
  return made;
};
const find = (selector, within = document) => within.querySelector(selector);
const remembered = (name) => {
  try { return localStorage.getItem(name); } catch { return null; }
};
const remember = (name, value) => {
  try { localStorage.setItem(name, value); } catch { /* some browsers keep nothing for files */ }
};

const systemIsDark = matchMedia("(prefers-color-scheme: dark)");
let chosenTheme = remembered("uniteam-theme");
const whenThemed = [];

const applyTheme = () => {
  const theme = chosenTheme ?? (systemIsDark.matches ? "dark" : "light");
  document.documentElement.dataset.theme = theme;
  const other = theme === "dark" ? "light" : "dark";
  find("#theme").setAttribute("aria-label", `Switch to ${other} colours`);
  find("#theme").title = `Switch to ${other} colours`;
  for (const listener of whenThemed) listener();
};
const switchTheme = () => {
  chosenTheme = document.documentElement.dataset.theme === "dark" ? "light" : "dark";
  remember("uniteam-theme", chosenTheme);
  applyTheme();
};
const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

find("#theme").addEventListener("click", switchTheme);
systemIsDark.addEventListener("change", applyTheme);
applyTheme();
