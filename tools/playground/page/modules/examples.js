// What can be opened: the examples that come with grafwire, fetched when one is chosen, a file of
// this machine, and a chart to begin with.
import { element } from "./dom.js";
import { say } from "./words.js";

const folder = new URL("../examples/", import.meta.url);

async function fetched(name) {
  const answer = await fetch(new URL(name, folder));
  if (!answer.ok) throw new Error(`${name}: ${answer.status}`);
  return answer;
}

const blank = {
  en: 'grafcet machine\n\ninput start, done\noutput motor\n\ngraph G1 {\n  initial 0\n  step 1 : motor\n\n  0 -> 1 : ↑start\n  1 -> 0 : done\n}\n',
  fr: 'grafcet machine\n\nentrée marche, fin\nsortie moteur\n\ngraphe G1 {\n  initiale 0\n  étape 1 : moteur\n\n  0 -> 1 : ↑marche\n  1 -> 0 : fin\n}\n',
};

// `open(text, file)` is called with the one that was chosen.
export function createExamples(select, { language, open, notify }) {
  let list = [];

  function tell() {
    select.replaceChildren(
      element("option", { value: "" }, say("choose_example")),
      element("option", { value: "new" }, say("new_chart")),
      element("option", { value: "file" }, say("open_file")),
      ...list.map(({ file, title, name }) => element("option", { value: file }, title || name)));
    select.value = "";
  }

  const picker = element("input", { type: "file", accept: ".grafcet,.txt,text/plain" });
  picker.addEventListener("change", async () => {
    const [chosen] = picker.files;
    if (chosen) await open(await chosen.text(), chosen.name);
    picker.value = "";
  });

  async function choose(file) {
    if (file === "file") return picker.click();
    if (file === "new") return open(blank[language()], "machine.grafcet");
    try {
      await open(await (await fetched(file)).text(), file);
    } catch (failure) {
      notify(failure.message);
    }
  }

  select.addEventListener("change", async () => {
    const file = select.value;
    select.value = "";
    if (file) await choose(file);
  });

  return {
    tell,
    async load() {
      list = await (await fetched("index.json")).json();
      tell();
    },
    choose,
  };
}
