// What the core tells of an instant, with the rules of IEC 60848 that it names set off.
import { element } from "./dom.js";

const rules = /\((?:rule|règle)s?[\s\u00a0][^)]*\)/g;

export function storyNodes(text) {
  const nodes = [];
  let end = 0;
  for (const match of text.matchAll(rules)) {
    nodes.push(text.slice(end, match.index), element("span", { class: "rule" }, match[0]));
    end = match.index + match[0].length;
  }
  nodes.push(text.slice(end));
  return nodes;
}

// Instants of the gates alone tell nothing.
export function storyOf(instants) {
  return instants.filter(({ text }) => text).map(({ text }) => text.trimEnd()).join("\n");
}
