// The panel of a run: how it goes on, its inputs, its moment in words and lamps.
import { element, fillSelect, wordButton } from "./dom.js";
import { storyNodes, storyOf } from "./story.js";
import { createSwitches } from "./switches.js";
import { relabel, say } from "./words.js";

const speeds = [0.1, 0.5, 1, 2, 10];

const group = (word, ...children) =>
  element("section", { class: "group" }, element("h2", { dataset: { word } }), ...children);
const field = (word, control) =>
  element("label", { class: "field" }, element("span", { dataset: { word } }), control);

export const clock = (ms) =>
  ms < 60000 ? `${(ms / 1000).toFixed(3)} s`
             : `${Math.floor(ms / 60000)} min ${((ms % 60000) / 1000).toFixed(3)} s`;

const lamp = (name, value) =>
  element("span", { class: `lamp${value === 1 ? " on" : value === "x" ? " x" : ""}` }, name);

export function createRunPanel(root, { run, wave, store }) {
  const mode = element("select", { id: "run-mode" });
  const period = element("input", { type: "text", id: "run-period", value: "10ms", size: "6", dataset: { label: "period" } });
  const style = element("select", { id: "run-style" });
  const powerUp = element("select", { id: "run-power-up" });
  const speed = element("select", { id: "run-speed" });
  const time = element("output", { class: "clock", id: "clock" });
  const play = wordButton("play", () => (run.isPlaying() ? run.pause() : run.play()), { class: "primary", id: "play" });
  const step = wordButton("step_once", () => run.step(), { id: "step", dataset: { tip: "step_title" } });
  const scan = wordButton("one_scan", () => run.scan(), { id: "scan" });
  const back = wordButton("back", () => run.back(), { id: "back" });
  const switches = createSwitches((changes) => run.set(changes));
  const facts = element("dl", { class: "facts" });
  const story = element("div", { class: "story", id: "story", role: "log", "aria-live": "polite" });
  const trouble = element("p", { class: "summary bad", role: "alert" });

  root.replaceChildren(
    element("section", { class: "group bar settings" }, field("evolve", mode), period, field("style", style), field("power_up", powerUp)),
    trouble,
    element("section", { class: "group" },
      element("h2", { class: "with-clock" }, element("span", { dataset: { word: "time_group" } }), time, field("speed", speed)),
      element("div", { class: "bar" }, play, step, scan, back,
        wordButton("restart", () => run.open(), { id: "restart" }))),
    group("inputs_group", switches.inputs, switches.controls),
    group("now_group", facts),
    group("rules_group", story),
    wave.root);

  mode.addEventListener("change", choosePeriod);
  period.addEventListener("change", choosePeriod);
  style.addEventListener("change", () => store.set({ runStyle: style.value }));
  powerUp.addEventListener("change", () => store.set({ powerUp: powerUp.value }));
  speed.addEventListener("change", () => store.set({ speed: Number(speed.value) }));

  function choosePeriod() {
    store.set({ period: mode.value === "scans" ? period.value.trim() : null });
  }

  function tellOptions() {
    fillSelect(mode, [{ value: "stable", text: say("until_stable") }, { value: "scans", text: say("by_scans") }]);
    fillSelect(style, [{ value: "", text: say("without_gates") },
      ...store.get("styles").map(({ name }) => ({ value: name, text: name }))], store.get("runStyle"));
    fillSelect(powerUp, [{ value: "initial", text: say("power_up_known") },
      { value: "unknown", text: say("power_up_unknown") }], store.get("powerUp"));
    fillSelect(speed, speeds.map((value) => ({ value: String(value), text: `× ${value}` })), String(store.get("speed")));
  }

  function fact(word, ...content) {
    return [element("dt", {}, say(word)), element("dd", {}, ...content)];
  }

  function factsOf(state) {
    const listed = (names) => (names.length ? names.join(", ") : say("none"));
    const lamps = (values) => Object.entries(values).map(([name, value]) => lamp(name, value));
    return [
      ...fact("situation", state.situation.length ? state.situation.map((step) => lamp(step, 1)) : say("no_step")),
      ...(Object.keys(state.outputs).length ? fact("outputs", ...lamps(state.outputs)) : []),
      ...(Object.keys(state.vars).length ? fact("internal", ...lamps(state.vars)) : []),
      ...(Object.keys(state.counters).length
        ? fact("counters", Object.entries(state.counters).map(([name, value]) => `${name} = ${value}`).join(", ")) : []),
      ...fact("clearable_now", listed(state.clearable)),
      ...fact("waits", listed(state.enabled.filter((name) => !state.clearable.includes(name)))),
      ...(state.next_ms === null ? [] : fact("next_delay", clock(state.next_ms))),
    ];
  }

  function troubleOf(state) {
    const gates = state?.gates;
    return [
      store.get("runRefusal") && say("style_refused", { why: store.get("runRefusal") }),
      store.get("runError"),
      ...(state?.warnings ?? []),
      gates && !gates.settled && say("not_settled"),
      gates?.settled && !gates.agrees && say("gates_differ", { steps: gates.differs.join(", ") }),
    ].filter(Boolean).join("\n");
  }

  function showState() {
    const state = store.get("run");
    const isScanned = store.get("period") !== null;
    trouble.textContent = troubleOf(state);
    trouble.hidden = trouble.textContent === "";
    period.hidden = !isScanned;
    powerUp.parentElement.hidden = !store.get("runStyle");
    wave.root.hidden = !state?.gates;
    for (const button of [play, scan, back, step]) button.disabled = !state;
    if (!state) {
      facts.replaceChildren();
      story.replaceChildren();
      return;
    }
    scan.disabled = !isScanned;
    step.disabled = !isScanned && state.next_ms === null;
    back.disabled = !state.can_back;
    switches.follow(state.inputs);
    facts.replaceChildren(...factsOf(state));
    if (state.instants.length) story.replaceChildren(...storyNodes(storyOf(state.instants)));
  }

  function showClock() {
    time.textContent = store.get("run") ? clock(store.get("runTime")) : "";
    play.dataset.word = store.get("playing") ? "pause" : "play";
    play.textContent = say(play.dataset.word);
  }

  store.on(["run", "runError", "runRefusal", "period", "runStyle"], showState);
  store.on(["run", "runTime", "playing"], showClock);
  store.on(["runStyle"], () => { style.value = store.get("runStyle"); });
  return {
    switches,
    rebuild: (inputs, controls) => switches.rebuild(inputs, controls),
    relabel() {
      tellOptions();
      relabel(root);
      wave.relabel();
      showState();
      showClock();
    },
  };
}
