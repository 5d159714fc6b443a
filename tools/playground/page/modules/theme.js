// Light or dark: what the reader chose, else what the system says.
import { remembered, remember } from "./memory.js";

const system = matchMedia("(prefers-color-scheme: dark)");
const listeners = [];

export function isDark() {
  const chosen = remembered("theme");
  return chosen ? chosen === "dark" : system.matches;
}

function apply() {
  document.documentElement.dataset.shade = isDark() ? "dark" : "light";
  for (const action of listeners) action(isDark());
}

export function toggleTheme() {
  remember("theme", isDark() ? "light" : "dark");
  apply();
}

export function onTheme(action) {
  listeners.push(action);
}

system.addEventListener("change", apply);
apply();
