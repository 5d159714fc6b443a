// The panel of a proof: which wiring, the verdict, and the witness step by step.
import { stopped } from "./core.js";
import { element, fillSelect, wordButton } from "./dom.js";
import { storyNodes, storyOf } from "./story.js";
import { relabel, say } from "./words.js";

export function createCheckPanel(root, { core, replay, wave, store, onMoment }) {
  const style = element("select", { id: "check-style" });
  const cdx = element("select", { id: "check-cdx" });
  const delay = element("select", { id: "check-delay" });
  const changes = element("select", { id: "check-changes" });
  const start = wordButton("check_now", () => check(), { class: "primary", id: "check" });
  const stop = wordButton("stop", () => core.stop(), { id: "stop" });
  const said = element("span", { role: "status", "aria-live": "polite" });
  const progress = element("div", { class: "progress", hidden: true }, element("progress", { "aria-hidden": "true" }), said);
  const verdict = element("div", { class: "verdict", id: "verdict", role: "status", "aria-live": "polite", hidden: true });
  const place = element("span", { class: "hint", id: "witness-place" });
  const sentence = element("div", { class: "story sentence", id: "sentence", role: "log", "aria-live": "polite" });
  const parting = element("p", { class: "summary bad" });
  const buttons = [
    wordButton("first", () => goTo(0)), wordButton("previous", () => goTo(at - 1)),
    wordButton("next", () => goTo(at + 1), { class: "primary", id: "witness-next" }),
    wordButton("last", () => goTo(moments.length - 1))];
  const witness = element("section", { class: "group", id: "witness", hidden: true },
    element("h2", { dataset: { word: "witness_group" } }),
    element("div", { class: "bar" }, buttons, place), parting, sentence);
  const report = element("pre", { class: "report", id: "report" });
  const reportGroup = element("details", { class: "group", hidden: true },
    element("summary", { dataset: { word: "report_group" } }), report);
  let moments = [];
  let at = 0;
  let checked = null;  // the request and its answer

  const row = (word, control) => [
    element("label", { for: control.id, dataset: { word } }), control];
  root.replaceChildren(
    element("section", { class: "group" }, element("h2", { dataset: { word: "check_group" } }),
      element("div", { class: "form" }, row("style_label", style), row("cdx_label", cdx),
        row("delays_label", delay), row("changes_label", changes))),
    element("div", { class: "bar" }, start, stop), progress, verdict, witness, wave.root, reportGroup);
  wave.root.hidden = true;
  stop.disabled = true;

  style.addEventListener("change", () => store.set({ style: style.value }));
  cdx.addEventListener("change", () => store.set({ cdx: cdx.value }));
  delay.addEventListener("change", () => store.set({ delay: delay.value }));

  function request() {
    return {
      text: store.get("acceptedText"), file: store.get("fileName"), lang: store.get("language"),
      style: style.value, cdx: cdx.value || undefined, delay: delay.value, changes: changes.value,
      with_files: true,
    };
  }

  async function check() {
    if (start.disabled) return;
    if (!store.get("isAccepted")) return tell("undecided", say("mend_first"), "");
    const asked = request();
    begin();
    const began = performance.now();
    const answer = await core.ask("check", asked, ({ situations, cases }) => {
      said.textContent = say("checking", { situations, cases });
    });
    end();
    if (answer === stopped) return tell("undecided", say("undecided"), say("stopped"));
    if (answer.error) return tell("undecided", say("undecided"), answer.error);
    checked = { asked, answer, seconds: (performance.now() - began) / 1000 };
    await showAnswer();
  }

  function begin() {
    checked = null;
    moments = [];
    start.disabled = true;
    stop.disabled = false;
    said.textContent = say("checking_starts");
    verdict.replaceChildren();
    progress.hidden = false;
    for (const part of [verdict, witness, wave.root, reportGroup]) part.hidden = true;
    store.set({ checked: null });
    onMoment(null);
  }

  function end() {
    start.disabled = false;
    stop.disabled = true;
    progress.hidden = true;
  }

  function tell(kind, title, ...lines) {
    verdict.className = `verdict ${kind}`;
    verdict.replaceChildren(element("strong", {}, title), ...lines.map((line) => element("p", {}, line)));
    verdict.hidden = false;
    verdict.scrollIntoView({ block: "nearest" });
  }

  async function showAnswer() {
    const { asked, answer, seconds } = checked;
    const basis = answer.text.split("\n").slice(1, 3).map((line) => line.trim()).filter(Boolean);
    tell(answer.verdict, `${say(answer.verdict)} — ${asked.style}`, say(`${answer.verdict}_says`),
      element("span", { class: "hint" }, [...basis, say("took", { seconds: seconds.toFixed(2) })].join(" · ")));
    report.textContent = answer.text;
    reportGroup.hidden = false;
    reportGroup.open = answer.verdict !== "equivalent";
    store.set({ checked });
    if (answer.witness) await showWitness();
  }

  async function showWitness() {
    const { asked, answer } = checked;
    const played = await replay.moments(asked, answer.witness);
    moments = played.moments ?? [];
    witness.hidden = wave.root.hidden = moments.length === 0;
    if (moments.length) goTo(0);
  }

  function goTo(index) {
    if (index < 0 || index >= moments.length) return;
    at = index;
    const { state, before } = moments[at];
    place.textContent = say("witness_place", { n: at + 1, all: moments.length });
    sentence.replaceChildren(...storyNodes(storyOf(state.instants)));
    const differs = state.gates?.differs ?? [];
    parting.textContent = differs.length ? partingText(state, differs) : "";
    parting.hidden = differs.length === 0;
    buttons[0].disabled = buttons[1].disabled = at === 0;
    buttons[2].disabled = buttons[3].disabled = at === moments.length - 1;
    onMoment({ state, before, svg: checked.answer.witness.svg, wave });
  }

  // What reference and wiring have where they part.
  function partingText(state, differs) {
    const values = differs.map((name) => {
      const { expected = {}, got = {} } = checked.answer.report.witness ?? {};
      const own = state.gates.values[name];
      return say("gives", { name, expected: expected[name] ?? "?", got: own ?? got[name] ?? "?" });
    });
    return say("they_part", { what: values.join(" ; ") });
  }

  function tellOptions() {
    const plain = (names) => names.map((name) => ({ value: name, text: name }));
    fillSelect(style, store.get("styles").map(({ name, description }) =>
      ({ value: name, text: say("named", { name, description }) })), store.get("style"));
    fillSelect(cdx, [{ value: "", text: say("cdx_own") }, ...plain(store.get("cdxForms"))], store.get("cdx"));
    fillSelect(delay, plain(store.get("delayModels")), store.get("delay"));
    fillSelect(changes, [{ value: "one", text: say("changes_one") }, { value: "many", text: say("changes_many") }]);
  }

  store.on(["style"], () => { style.value = store.get("style"); });
  store.on(["acceptedText"], () => {
    if (checked && checked.asked.text !== store.get("acceptedText"))
      verdict.append(element("p", { class: "hint" }, say("out_of_date")));
  });

  return {
    check,
    next: () => goTo(at + 1),
    previous: () => goTo(at - 1),
    // Shows again what it last showed, as when one comes back to it.
    showAgain: () => (moments.length ? goTo(at) : onMoment(null)),
    relabel() {
      tellOptions();
      relabel(root);
      wave.relabel();
      if (checked && checked.asked.lang !== store.get("language")) check();
    },
  };
}
