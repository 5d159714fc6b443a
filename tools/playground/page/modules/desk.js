// From the text to what is known of it: messages while one types, and, once the text is accepted,
// chart, drawing, equations and wiring. What has mistakes leaves the last pictures as they were.
import { afterQuiet } from "./dom.js";
import { say } from "./words.js";

const quiet = 120;  // milliseconds without a key before the text is read

export function createDesk({ core, store, stage, views, editor, onFindings, onAccepted }) {
  let reading = 0;
  let began = 0;     // when the text was last read
  const drawn = {};  // by picture: what it was made of

  async function read() {
    const mine = ++reading;
    began = performance.now();
    const text = store.get("text");
    const lang = store.get("language");
    const answer = await core.ask("chart", { text, lang });
    if (mine !== reading) return;
    const findings = answer.diagnostics ?? [];
    editor().showFindings(findings);
    onFindings(findings, answer.chart);
    stage.chart.remark(answer.chart ? "" : say("last_valid"));
    store.set({ isAccepted: answer.chart !== undefined });
    if (!answer.chart) return;
    stage.setChart(answer.chart);
    store.set({ chart: answer.chart, names: answer.chart.names, acceptedText: text });
    await draw();
    onAccepted();
  }

  // Asks for a picture only where it is shown, and was made of something else.
  async function refresh(picture, made, ask, show) {
    const key = JSON.stringify(made);
    if (!views().isShown(picture) || drawn[picture] === key) return;
    drawn[picture] = key;
    const answer = await ask();
    if (drawn[picture] === key) show(answer);
  }

  async function draw() {
    if (!store.get("acceptedText")) return;
    const text = store.get("acceptedText");
    const lang = store.get("language");
    const wiring = { text, lang, style: store.get("shownStyle"), cdx: store.get("cdx") || undefined, delay: store.get("delay") };
    const forms = { text, lang, cdx: store.get("cdx") || undefined, to: "json" };
    await Promise.all([
      refresh("chart", { text, lang }, () => core.ask("draw", { text, lang, animated: true }),
        (answer) => {
          if (answer.svg) stage.chart.show(answer.svg);
          performance.measure("re-draw", { start: began, end: performance.now() });
        }),
      refresh("equations", forms, () => core.ask("equations", forms),
        (answer) => { if (answer.text) stage.equations.show(JSON.parse(answer.text)); }),
      refresh("wiring", wiring, () => core.ask("schematic", wiring), (answer) => {
        stage.wiring.show(answer.svg ? [answer.svg] : []);
        stage.wiring.remark(answer.svg ? wiring.style : "");
      }),
    ]);
  }

  const readSoon = afterQuiet(quiet, read);
  store.on(["text"], readSoon);
  store.on(["language"], read);
  store.on(["views", "shownStyle", "cdx", "delay"], draw);
  return { read, draw };
}
