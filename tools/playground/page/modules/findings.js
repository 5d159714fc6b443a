// The messages about the text as a list: each goes to its place when it is chosen.
import { element } from "./dom.js";
import { count, say } from "./words.js";

function summaryOf(findings, chart) {
  const errors = findings.filter(({ severity }) => severity === "error").length;
  const warnings = findings.length - errors;
  const parts = [];
  if (errors) parts.push(count("errors", errors));
  if (chart)
    parts.push(say("accepted", {
      steps: count("steps", chart.steps.length),
      transitions: count("transitions", chart.transitions.length),
    }));
  if (warnings) parts.push(count("warnings", warnings));
  return parts.join(" ");
}

export function createFindings({ summary, list, goTo }) {
  const itemOf = ({ severity, line, column, from, message, notes = [] }) =>
    element("li", {}, element("button", { type: "button", class: `finding ${severity}`, onclick: () => goTo(from) },
      line ? element("span", { class: "place" }, `${line}:${column}`) : null,
      element("span", { class: "kind" }, say(severity === "error" ? "error" : "warning")), ` ${message}`,
      ...notes.map((note) => element("span", { class: "note" }, note.line ? `${note.line}:${note.column} ` : "", note.message))));
  return {
    show(findings, chart) {
      const isGood = chart !== undefined;
      summary.className = `summary ${isGood ? "good" : "bad"}`;
      summary.textContent = summaryOf(findings, chart);
      list.replaceChildren(...findings.map(itemOf));
    },
  };
}
