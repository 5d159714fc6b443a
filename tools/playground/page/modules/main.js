// The page: makes its parts and tells them of each other.
import { Core } from "./core.js";
import { createCheckPanel } from "./check-panel.js";
import { createDesk } from "./desk.js";
import { byId, element } from "./dom.js";
import { createEditor } from "./editor.js";
import { createExamples } from "./examples.js";
import { createExports } from "./exports.js";
import { createFindings } from "./findings.js";
import { createHelp } from "./help.js";
import { remember, remembered } from "./memory.js";
import { Replay } from "./replay.js";
import { createRun } from "./run.js";
import { createRunPanel } from "./run-panel.js";
import { chartOf, fragmentOf } from "./share-link.js";
import { listenForKeys } from "./shortcuts.js";
import { createStage } from "./stage.js";
import { createStore } from "./store.js";
import { createSymbols } from "./symbols.js";
import { isDark, onTheme, toggleTheme } from "./theme.js";
import { createViews } from "./views.js";
import { changesOf, createWave } from "./wave.js";
import { currentLanguage, relabel, say, setLanguage } from "./words.js";

const firstExample = "nine-steps.grafcet";

setLanguage(remembered("language") ?? (navigator.language.startsWith("fr") ? "fr" : "en"));

const store = createStore({
  language: currentLanguage(), mode: "text", views: "",
  text: "", fileName: "chart.grafcet", isAccepted: false, acceptedText: "", chart: null, names: [],
  styles: [], cdxForms: [], delayModels: [],
  style: "nand", runStyle: "nand", shownStyle: "nand", cdx: "", delay: "unit", powerUp: "initial",
  period: null, speed: 1, playing: false,
  run: null, runTime: 0, runError: "", runRefusal: "", checked: null,
});

// One core for what answers at once, one for checks, which may take long and be stopped.
const core = new Core();
const checker = new Core();

const stage = createStage(byId("panes"));
const views = createViews(byId("views"), byId("panes"), store);
const showValues = (values, changing) => stage.wiring.mark(values, changing);
const runWave = createWave(showValues);
const checkWave = createWave(showValues);
let editor = null;

let noticeTimer = 0;
function notify(text) {
  byId("notice").textContent = text;
  clearTimeout(noticeTimer);
  noticeTimer = setTimeout(() => { byId("notice").textContent = ""; }, 4000);
}

// Moments: of the run, and of a witness that is replayed. Shown is that of the mode.
let runMoment = null;
const run = createRun(core, store, {
  onMoment(state, before) {
    runMoment = { state, before };
    if (store.get("mode") === "run") showRunMoment(before, changesOf(state.instants));
    showTiming();
  },
});

function showRunMoment(before, changes) {
  const state = runMoment?.state;
  stage.showMoment(state);
  if (state?.gates) runWave.start(before ?? state.gates.values, changes, state.gates.values);
}

async function showTiming() {
  if (store.get("mode") !== "run" || !views.isShown("timing")) return;
  const { svg } = await run.timing();
  if (store.get("mode") === "run") stage.timing.show(svg);
}

function showWitnessMoment(moment) {
  if (store.get("mode") !== "check") return;
  stage.timing.show(moment?.svg);
  if (!moment) return stage.showMoment(null);
  const { state, before } = moment;
  const differing = (state.gates?.differs ?? []).map(stage.stepOf).filter(Boolean);
  stage.showMoment(state, differing);
  if (state.gates) checkWave.start(before ?? state.gates.values, changesOf(state.instants), state.gates.values);
  stage.timing.markTime(state.now_ms);
}

const runPanel = createRunPanel(byId("panel-run"), { run, wave: runWave, store });
const checkPanel = createCheckPanel(byId("panel-check"), {
  core: checker, replay: new Replay(core), wave: checkWave, store, onMoment: showWitnessMoment,
});
const findings = createFindings({
  summary: byId("findings-summary"), list: byId("findings"), goTo: (from) => editor.goTo(from),
});
const desk = createDesk({
  core, store, stage, views: () => views, editor: () => editor,
  onFindings: (list, chart) => findings.show(list, chart),
  onAccepted() {
    const { title, name, inputs, controls } = store.get("chart");
    byId("chart-title").textContent = title || name;
    runPanel.rebuild(inputs.map((input) => input.name), controls);
    if (store.get("mode") === "run") run.open();
    else runIsOld = true;
  },
});
let runIsOld = true;

const exports = createExports(byId("export-dialog"), {
  core, store, notify, stimuli: async () => (await run.stimuli()).text,
});
const help = createHelp(byId("help-dialog"));
const examples = createExamples(byId("examples"), { language: currentLanguage, open: openText, notify });

async function openText(text, fileName = "chart.grafcet") {
  editor.setText(text);
  store.set({ text, fileName });
  await desk.read();
}

function setMode(mode) {
  document.body.dataset.phone = mode;
  for (const tab of document.querySelectorAll("[role=tab]")) {
    const isChosen = tab.id === `tab-${mode}`;
    tab.setAttribute("aria-selected", String(isChosen));
    tab.tabIndex = isChosen ? 0 : -1;
  }
  if (mode === "picture") return;
  document.body.dataset.mode = mode;
  if (mode !== "run") run.pause();
  store.set({ mode });
  if (mode === "text") stage.showMoment(null);
  if (mode === "check") {
    checker.ask("version");  // loads its core meanwhile
    checkPanel.showAgain();
  }
  if (mode === "run") enterRun();
}

async function enterRun() {
  if (runIsOld && store.get("acceptedText")) {
    runIsOld = false;
    await run.open();
  } else {
    showRunMoment(runMoment?.state?.gates?.values, []);
    await showTiming();
  }
}

async function share() {
  const fragment = await fragmentOf(store.get("text"));
  history.replaceState(null, "", fragment);
  try {
    await navigator.clipboard.writeText(location.href);
    notify(say("link_copied"));
  } catch {
    notify(say("link_in_address"));
  }
}

async function openLink() {
  try {
    const text = await chartOf(location.hash);
    if (text === null) return false;
    await openText(text);
    return true;
  } catch {
    notify(say("link_unreadable"));
    return false;
  }
}

function relabelAll() {
  relabel(document);
  const other = currentLanguage() === "fr" ? "en" : "fr";
  Object.assign(byId("language"), { textContent: other.toUpperCase(), title: say("language"), lang: other });
  byId("language").setAttribute("aria-label", say("language"));
  labelTheme();
  examples.tell();
  editor?.relabel();
  runPanel.relabel();
  checkPanel.relabel();
}

function labelTheme() {
  const label = say(isDark() ? "theme_light" : "theme_dark");
  Object.assign(byId("theme"), { title: label, textContent: isDark() ? "☀" : "☾" });
  byId("theme").setAttribute("aria-label", label);
}

async function changeLanguage() {
  setLanguage(currentLanguage() === "fr" ? "en" : "fr");
  remember("language", currentLanguage());
  const { styles } = await core.ask("words", { lang: currentLanguage() });
  store.set({ styles, language: currentLanguage() });
  relabelAll();
}

function listen() {
  byId("open-export").addEventListener("click", () => exports.open());
  byId("open-help").addEventListener("click", () => help.open());
  byId("share").addEventListener("click", share);
  byId("language").addEventListener("click", changeLanguage);
  byId("theme").addEventListener("click", toggleTheme);
  onTheme(labelTheme);
  addEventListener("hashchange", openLink);
  const tabs = [...document.querySelectorAll("[role=tab]")];
  for (const tab of tabs) {
    tab.addEventListener("click", () => setMode(tab.id.slice("tab-".length)));
    tab.addEventListener("keydown", ({ key }) => {
      const by = { ArrowRight: 1, ArrowLeft: -1 }[key];
      if (!by) return;
      const shown = tabs.filter((other) => other.offsetParent !== null);
      const next = shown[(shown.indexOf(tab) + by + shown.length) % shown.length];
      next.click();
      next.focus();
    });
  }
  // Run and Check speak of one wiring; the schematic shows that of the mode.
  store.on(["runStyle"], () => { if (store.get("runStyle")) store.set({ style: store.get("runStyle") }); });
  store.on(["style"], () => store.set({ shownStyle: store.get("style") }));
  store.on(["runStyle", "cdx", "delay", "powerUp", "period", "language"], () => {
    if (store.get("mode") === "run") run.open();
    else runIsOld = true;
  });
  store.on(["views"], () => { if (store.get("run")) showTiming(); });
  listenForKeys({
    mode: () => store.get("mode"), modes: setMode,
    export_: () => exports.open(), help: () => help.open(),
    check: () => { setMode("check"); checkPanel.check(); },
    run: { toggle: () => (run.isPlaying() ? run.pause() : run.play()), step: run.step, scan: run.scan, back: run.back },
    wave: runWave.oneGate, witness: checkPanel, flip: runPanel.switches.flipNumber,
  });
}

async function begin() {
  relabelAll();
  setMode("text");
  byId("findings-summary").textContent = say("loading");
  const words = await core.ask("words", { lang: currentLanguage() });
  if (words.error) {
    byId("findings-summary").textContent = say("core_failed", { why: words.error });
    return;
  }
  store.set({ styles: words.styles, cdxForms: words.cdx, delayModels: words.delays });
  editor = createEditor(byId("editor"), {
    words, names: () => store.get("names"), onChange: (text) => store.set({ text }),
  });
  createSymbols(byId("symbols"), editor.insert);
  relabelAll();
  listen();
  await Promise.all([examples.load(), openLink().then((done) => done || examples.choose(firstExample))]);
  document.body.dataset.ready = "";
  if ("serviceWorker" in navigator) navigator.serviceWorker.register("service-worker.js").catch(() => {});
}

begin();
