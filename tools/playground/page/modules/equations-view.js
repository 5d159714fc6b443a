// The equations of the chart as tables; the rows of active steps are lit while it runs.
import { element } from "./dom.js";
import { makePane } from "./pane.js";
import { relabel } from "./words.js";

function table(title, heads, rows) {
  if (rows.length === 0) return [];
  return [
    element("h3", { dataset: { word: title } }),
    element("table", {},
      element("thead", {}, element("tr", {}, heads.map((word) => element("th", { scope: "col", dataset: { word } })))),
      element("tbody", {}, rows.map(({ cells, ...facts }) =>
        element("tr", { dataset: facts }, cells.map((cell) => element("td", {}, cell)))))),
  ];
}

export function createEquationsView(panes) {
  const { body } = makePane(panes, "equations", "view_equations");
  body.classList.add("equations");
  let active = new Set();

  function light() {
    for (const row of body.querySelectorAll("tr[data-variable]"))
      row.classList.toggle("active", active.has(row.dataset.variable));
  }

  return {
    // What `equations --to json` writes.
    show(equations) {
      body.replaceChildren(
        ...table("eq_steps", ["eq_step", "eq_equation"],
          equations.steps.map(({ name, x }) => ({ variable: name, cells: [name, x] }))),
        ...table("eq_cax", ["eq_step", "eq_cax_head", "eq_cdx_head"],
          equations.steps.map(({ name, cax, cdx }) => ({ variable: name, cells: [name, cax, cdx] }))),
        ...table("eq_transitions", ["eq_transition", "eq_steps_head", "eq_clearing"],
          equations.transitions.map(({ name, from, to, clearing }) =>
            ({ cells: [`(${name})`, `${from.join(".")} → ${to.join(".")}`, clearing] }))),
        ...table("eq_outputs", ["eq_output", "eq_equation"],
          equations.outputs.map(({ name, equation }) => ({ cells: [name, equation] }))));
      relabel(body);
      light();
    },
    // The variables of the active steps.
    mark(variables = []) {
      active = new Set(variables);
      light();
    },
  };
}
