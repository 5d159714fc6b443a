// A pane: a heading, a remark beside it, and a body; for drawings with the buttons that size them.
import { element, wordButton } from "./dom.js";
import { Picture } from "./picture.js";

export function makePane(parent, view, word) {
  const remark = element("span", { class: "remark" });
  const header = element("header", {}, element("h2", { dataset: { word } }), remark);
  const body = element("div", { class: "picture", tabindex: "0", dataset: { label: word }, role: "region" });
  const pane = element("section", { class: "pane", dataset: { view } }, header, body);
  parent.append(pane);
  return { pane, header, body, remark };
}

export function makePicturePane(parent, view, word, isWide) {
  const made = makePane(parent, view, word);
  const picture = new Picture(made.body, isWide);
  const zoom = (by, sign, label) =>
    element("button", { type: "button", onclick: () => picture.zoom(by), dataset: { label, tip: label } }, sign);
  made.header.append(zoom(-1, "−", "smaller"), zoom(1, "+", "larger"),
    wordButton("fit", () => picture.zoom(0)));
  return { ...made, picture };
}
