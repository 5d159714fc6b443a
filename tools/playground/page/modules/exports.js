// Everything the command line writes, as downloads: the list is the core's own.
import { element, wordButton } from "./dom.js";
import { say } from "./words.js";

const sections = [
  ["export_chart", ["chart", "drawing"]],
  ["export_equations", ["equations"]],
  ["export_netlist", ["netlist"]],
  ["export_program", ["program"]],
  ["export_run", ["trace", "story", "waveform", "gates", "gate-story", "gate-waveform"]],
  ["export_check", ["report"]],
];
const ofRuns = new Set(sections.find(([word]) => word === "export_run")[1]);

export function download(name, text, mime = "text/plain") {
  const url = URL.createObjectURL(new Blob([text], { type: `${mime};charset=utf-8` }));
  const link = element("a", { href: url, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}

// `stimuli()` gives the .stim text of the run, or nothing.
export function createExports(dialog, { core, store, stimuli, notify }) {
  const style = element("select", { id: "export-style" });
  const body = element("div", { class: "body" });
  dialog.append(
    element("header", {}, element("h2", { id: "export-title", dataset: { word: "export_title" } }),
      wordButton("close", () => dialog.close())),
    body);

  const stem = () => store.get("fileName").replace(/\.grafcet$/, "");

  function request(entry, runStimuli) {
    return {
      kind: entry.kind, format: entry.format, text: store.get("acceptedText"),
      file: store.get("fileName"), lang: store.get("language"), style: style.value,
      cdx: store.get("cdx") || undefined, delay: store.get("delay"),
      ...(ofRuns.has(entry.kind)
        ? { stimuli: runStimuli, stimuli_file: `${stem()}.stim`, scan: store.get("period") ?? undefined } : {}),
    };
  }

  async function save(entry) {
    const runStimuli = ofRuns.has(entry.kind) ? await stimuli() : undefined;
    if (ofRuns.has(entry.kind) && !runStimuli) return notify(say("run_needed"));
    const answer = await core.ask("export", request(entry, runStimuli));
    if (answer.error) {
      const why = [answer.error, ...(answer.diagnostics ?? []).map(({ message }) => message)].join(" ");
      return notify(say("export_refused", { name: entry.format, why }));
    }
    for (const { name, text, mime } of answer.files) download(name, text, mime);
    notify(say("downloaded", { name: answer.files.map(({ name }) => name).join(", ") }));
  }

  async function saveStimuli() {
    const text = await stimuli();
    if (!text) return notify(say("run_needed"));
    download(`${stem()}.stim`, text);
  }

  const row = (code, words, action, facts = {}) =>
    element("button", { type: "button", class: "download", onclick: action, dataset: facts },
      element("code", {}, code), element("span", {}, words));

  const rowOf = (entry) =>
    row(entry.format || entry.kind, entry.description, () => save(entry), { export: `${entry.kind}/${entry.format}` });

  const extra = {
    export_chart: () => row(".grafcet", say("chart_text"), () => download(store.get("fileName"), store.get("text"))),
    export_run: () => row(".stim", say("run_stim"), saveStimuli),
  };

  function styleRow() {
    style.replaceChildren(...store.get("styles").map(({ name }) => element("option", { value: name }, name)));
    style.value = store.get("style");
    return element("label", { class: "field" }, element("span", {}, say("style_label")), style);
  }

  return {
    async open() {
      const { exports: all } = await core.ask("exports", { lang: store.get("language") });
      body.replaceChildren(
        element("p", { class: "hint" }, say("export_says")),
        store.get("isAccepted") ? element("p", { class: "bar" }, styleRow())
                                : element("p", { class: "summary bad" }, say("mend_first")),
        ...sections.flatMap(([word, kinds]) => [
          element("h3", {}, say(word)),
          element("div", { class: "downloads" }, extra[word]?.() ?? null,
            all.filter(({ kind }) => kinds.includes(kind)).map(rowOf))]));
      if (!dialog.open) dialog.showModal();
    },
  };
}
