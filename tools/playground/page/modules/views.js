// Which panes are shown in which mode: a choice of the reader's, kept from visit to visit.
import { element } from "./dom.js";
import { remember, remembered } from "./memory.js";

const all = ["chart", "equations", "wiring", "timing"];
const atFirst = {
  text: ["chart", "equations"],
  run: ["chart", "wiring", "timing"],
  check: ["chart", "wiring", "timing"],
};
const phone = matchMedia("(max-width: 899px)");

export function createViews(buttons, panes, store) {
  const shown = {};
  for (const mode of Object.keys(atFirst))
    shown[mode] = remembered(`views.${mode}`)?.split(" ").filter((view) => all.includes(view)) ?? atFirst[mode];
  // On a phone there is room for one.
  let single = "chart";

  const now = () => (phone.matches ? [single] : shown[store.get("mode")]);

  function choose(view) {
    const mode = store.get("mode");
    if (phone.matches) {
      single = view;
    } else {
      const rest = shown[mode].filter((other) => other !== view);
      shown[mode] = shown[mode].includes(view) ? (rest.length ? rest : shown[mode]) : [...rest, view];
      remember(`views.${mode}`, shown[mode].join(" "));
    }
    apply();
  }

  function apply() {
    for (const button of buttons.children)
      button.setAttribute("aria-pressed", String(now().includes(button.dataset.view)));
    for (const pane of panes.children) pane.hidden = !now().includes(pane.dataset.view);
    const columns = now().filter((view) => view !== "timing").length;
    panes.style.setProperty("--columns", Math.max(columns, 1));
    panes.classList.toggle("with-timing", columns > 0 && now().includes("timing"));
    store.set({ views: now().join(" ") });
  }

  buttons.replaceChildren(...all.map((view) =>
    element("button", { type: "button", onclick: () => choose(view), dataset: { word: `view_${view}`, view } })));
  store.on(["mode"], apply);
  phone.addEventListener("change", apply);
  apply();
  return { isShown: (view) => now().includes(view) };
}
