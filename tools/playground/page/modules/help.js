// The page of help: keys, what the pictures mark, the language in a few words.
import { element, wordButton } from "./dom.js";
import { relabel, say } from "./words.js";

const keys = [
  [["F2", "F4", "F9"], "key_modes"],
  [["Ctrl+Space"], "key_complete"],
  [["F8"], "key_next_error"],
  [["Tab"], "key_leave"],
  [["1", "…", "9"], "key_switch"],
  [["Space"], "key_play"],
  [["S"], "key_step"],
  [["C"], "key_scan"],
  [["G"], "key_gate"],
  [["B"], "key_back"],
  [["←", "→"], "key_witness"],
  [["Ctrl+Enter"], "key_check"],
  [["Ctrl+S"], "key_export"],
  [["?"], "key_help"],
];

// `Ctrl+Space` as it stands on the keys of that language.
const keyName = (name) => name.replace(/Space|Enter/, (key) => say(`key_name_${key}`));

const marks = [
  ["active", "legend_active"], ["enabled", "legend_enabled"], ["clearable", "legend_clearable"],
  ["one", "legend_one"], ["zero", "legend_zero"], ["unknown", "legend_unknown"],
];

function withCode(text) {
  return text.split("`").map((part, i) => (i % 2 ? element("code", {}, part) : part));
}

export function createHelp(dialog) {
  const body = element("div", { class: "body" });
  dialog.append(
    element("header", {}, element("h2", { id: "help-title", dataset: { word: "help" } }),
      wordButton("close", () => dialog.close())),
    body);
  return {
    open() {
      body.replaceChildren(
        element("h3", {}, say("help_title")),
        element("dl", { class: "keys" }, keys.flatMap(([names, word]) => [
          element("dt", {}, names.flatMap((name) => (name === "…" ? [" … "] : [element("kbd", {}, keyName(name)), " "]))),
          element("dd", {}, say(word))])),
        element("h3", {}, say("legend_title")),
        element("ul", { class: "legend" }, marks.map(([kind, word]) =>
          element("li", {}, element("span", { class: `swatch ${kind}`, "aria-hidden": "true" }), say(word)))),
        element("h3", {}, say("legend_language")),
        element("p", {}, ...withCode(say("language_says"))));
      relabel(dialog);
      if (!dialog.open) dialog.showModal();
    },
  };
}
