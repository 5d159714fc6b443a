// What the core tells of an instant: its lines, each as far in as the core has it, with the rules of
// IEC 60848 that it names set off.
import { element } from "./dom.js";

const rules = /\((?:rule|règle)s?[\s\u00a0][^)]*\)/g;

function withRules(line) {
  const nodes = [];
  let end = 0;
  for (const match of line.matchAll(rules)) {
    nodes.push(line.slice(end, match.index), element("span", { class: "rule" }, match[0]));
    end = match.index + match[0].length;
  }
  return [...nodes, line.slice(end)];
}

export function storyNodes(text) {
  return text.split("\n").map((line) => {
    const depth = /^ */.exec(line)[0].length;
    return element("p", { style: `--depth: ${depth}` }, withRules(line.slice(depth)));
  });
}

// Instants of the gates alone tell nothing.
export function storyOf(instants) {
  return instants.filter(({ text }) => text).map(({ text }) => text.trimEnd()).join("\n");
}
