// Signs of the language that keyboards do not have, or that a phone hides, one touch away.
import { element } from "./dom.js";

const signs = [
  ["↑", "operator_rise"], ["↓", "operator_fall"], [" . ", "operator_and"], [" + ", "operator_or"],
  ["/", "operator_not"], [" ⊕ ", "operator_xor"], [" -> ", "symbol_arrow"], [" : ", "symbol_colon"],
];

export function createSymbols(parent, insert) {
  parent.replaceChildren(...signs.map(([sign, word]) =>
    element("button", { type: "button", dataset: { label: word, tip: word }, onclick: () => insert(sign) }, sign.trim())));
}
