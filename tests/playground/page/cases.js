// What a person does with the page, case by case. Each case starts at a page just opened.
import assert from "node:assert/strict";
import { sequenceOf } from "./charts.js";

const pump = `grafcet pump "Pump"
input start, stop
output motor
graph G1 {
  initial 0
  step 1 : motor
  step 2
  (0) 0 -> 1 : start
  (1) 1 -> 2 : 1s/X1
  (2) 2 -> 0 : stop
}
`;
const mistaken = pump.replace("0 -> 1 : start", "0 -> 1 : strat");

const input = (name) => `#panel-run [data-input="${name}"]`;

// Asked in the page: whether nets are marked so, in the schematic or, without one, in the list.
function wiringHas(marks, wanted) {
  const pane = document.querySelector('.pane[data-view="wiring"]');
  const roots = [pane, pane.querySelector(".picture").shadowRoot];
  return roots.some((root) => root.querySelector(marks) !== null) === wanted;
}

async function runPump(person) {
  await person.writeAll(pump);
  await person.seesText("#findings-summary", "3 steps");
  await person.goTo("run");
  await person.seesMark("chart", "step", "0", "active");
}

export const cases = {
  async "a mistake is shown at its place, and goes when it is mended"(person) {
    await person.writeAll(mistaken);
    await person.seesText("#findings", "8:16");
    await person.seesText("#findings", "strat");
    await person.seesText("#findings-summary", "1 mistake");
    await person.sees("the underlined word", () =>
      document.querySelector(".cm-lintRange-error")?.textContent === "strat");
    await person.click("#findings button");
    await person.press(...Array(5).fill("Delete"));
    await person.type("start");
    await person.seesText("#findings-summary", "No mistakes. 3 steps, 3 transitions.");
    await person.sees("the mended chart", () =>
      [...document.querySelector('.pane[data-view="chart"] .picture').shadowRoot
        .querySelectorAll("[data-transition] text")].some((text) => text.textContent === "start"));
  },

  async "names and both spellings of operators are completed"(person) {
    await person.writeAll(pump);
    await person.seesText("#findings-summary", "3 steps");
    await person.click("#findings-summary");
    await person.writeAll(`${pump}# end\n`);
    await person.type("mot");
    await person.seesText(".cm-tooltip-autocomplete", "motor");
    await person.press("Escape", "Enter");
    await person.type("ris");
    await person.seesText(".cm-tooltip-autocomplete", "↑");
    await person.press("Escape", "Enter");
    await person.type("et");
    await person.seesText(".cm-tooltip-autocomplete", "AND");
    await person.seesText(".cm-tooltip-autocomplete", "étape");
  },

  async "switching an input lights the step up and names the rules"(person) {
    await runPump(person);
    await person.seesMark("chart", "transition", "(0)", "enabled");
    await person.click(input("start"));
    await person.seesMark("chart", "step", "1", "active");
    await person.seesMark("chart", "step", "0", "active", false);
    await person.seesText("#story", "(rule 2)");
    await person.seesText("#story", "(rule 3)");
    await person.sees("the lamp of the output", () =>
      [...document.querySelectorAll("#panel-run .lamp.on")].some((lamp) => lamp.textContent === "motor"));
    await person.click("#back");
    await person.seesMark("chart", "step", "0", "active");
  },

  async "time is stepped and played, and the diagram grows along"(person) {
    await runPump(person);
    await person.click(input("start"));
    await person.seesMark("chart", "step", "1", "active");
    const moments = await person.countIn("timing", ".moment");
    await person.click("#step");
    await person.seesMark("chart", "step", "2", "active");
    await person.seesText("#clock", "1.001 s");
    await person.sees("a longer diagram", (before) =>
      document.querySelector('.pane[data-view="timing"] .picture').shadowRoot.querySelectorAll(".moment").length > before, moments);
    await person.click("#restart");
    await person.seesMark("chart", "step", "0", "active");
    await person.click(input("start"));
    await person.choose("#run-speed", "10");
    await person.click("#play");
    await person.seesMark("chart", "step", "2", "active");
    await person.click("#play");
  },

  async "scan by scan, a transition is clearable before it is cleared"(person) {
    await runPump(person);
    await person.choose("#run-mode", "scans");
    await person.click("#scan");
    await person.seesMark("chart", "step", "0", "active");
    await person.click(input("start"));
    await person.click("#scan");
    await person.seesMark("chart", "step", "1", "active");
  },

  async "a clearable transition is marked"(person) {
    await person.openExample("rule-5.grafcet");
    await person.goTo("run");
    await person.click(input("s"));
    await person.seesMark("chart", "transition", "(0)", "clearable");
    await person.seesText("#story", "(rule 5)");
  },

  async "power-up is unknown until Init, and the wave goes gate by gate"(person) {
    await runPump(person);
    await person.choose("#run-power-up", "unknown");
    await person.sees("unknown nets", wiringHas, ".unknown, .lamp.x", true);
    await person.click(input("Init"));
    await person.sees("no unknown nets", wiringHas, ".unknown, .lamp.x", false);
    await person.click(input("Init"));
    await person.seesText("#clock", "0.001");
    await person.click(input("start"));
    await person.seesText("#clock", "0.002");
    await person.press("g");
    await person.seesText("#panel-run .gate-now", "Change 1 of");
    const first = await person.text("#panel-run .gate-now");
    await person.press("g");
    await person.seesText("#panel-run .gate-now", "Change 2 of");
    assert.notEqual(await person.text("#panel-run .gate-now"), first);
    await person.sees("the net that changes", wiringHas, ".changing", true);
  },

  async "Init, AUdur and AUdoux are buttons"(person) {
    await runPump(person);
    await person.click(input("start"));
    await person.seesMark("chart", "step", "1", "active");
    await person.click(input("AUdoux"));
    await person.sees("motor off, step 1 active", () =>
      [...document.querySelectorAll("#panel-run .lamp")].some((lamp) => lamp.textContent === "motor" && !lamp.classList.contains("on")));
    await person.seesMark("chart", "step", "1", "active");
    await person.click(input("AUdur"));
    await person.seesMark("chart", "step", "1", "active", false);
    await person.click(input("AUdur"));
    await person.click(input("Init"));
    await person.seesMark("chart", "step", "0", "active");
  },

  async "a witness is replayed step by step with its sentence"(person) {
    await person.openExample("rule-5.grafcet");
    await person.goTo("check");
    await person.choose("#check-style", "nor");
    await person.click("#check");
    await person.seesText("#verdict", "Different");
    await person.seesText("#report", "By rule 5 of GRAFCET the step stays active.");
    await person.seesText("#witness-place", "Step 1 of");
    await person.seesText("#sentence", "(rule 5)");
    await person.seesText("#witness", "X1: GRAFCET 1, wiring 0");
    await person.seesMark("chart", "step", "1", "wrong");
    assert(await person.countIn("timing", ".moment.here") > 0);
  },

  async "a long check tells how far it is, and is stopped"(person) {
    await person.writeAll(sequenceOf(60));
    await person.seesText("#findings-summary", "60 steps");
    await person.goTo("check");
    await person.choose("#check-changes", "many");
    await person.click("#check");
    await person.seesText(".progress", "cases compared");
    await person.click("#stop");
    await person.seesText("#verdict", "Stopped before a verdict.");
  },

  async "downloaded Verilog is that of the command line, byte for byte"(person) {
    const { name, text } = await person.download("netlist/verilog", "nor");
    const expected = person.commandLine("nine-steps.grafcet", person.example("nine-steps.grafcet"),
      "netlist", "nine-steps.grafcet", "--style", "nor", "--to", "verilog");
    assert.equal(name, "nine-steps.v");
    assert.equal(text, expected);
  },

  async "downloaded drawing, equations and program are those of the command line"(person) {
    const file = "nine-steps.grafcet";
    const chart = person.example(file);
    for (const [exported, ...options] of [
      ["drawing/svg", "draw", file, "--to", "svg"],
      ["equations/latex", "equations", file, "--to", "latex"],
      ["program/st", "plc", file, "--to", "st"]]) {
      const { text } = await person.download(exported);
      assert.equal(text, person.commandLine(file, chart, ...options), exported);
      person.forgetDownloads();
      await person.press("Escape");
    }
  },

  async "a link holds the chart, and nothing leaves the machine"(person) {
    await person.writeAll(pump);
    await person.seesText("#findings-summary", "3 steps");
    await person.click("#share");
    await person.sees("the fragment", () => location.hash.startsWith("#chart="));
    const link = await person.page.evaluate(() => location.href);
    await person.page.goto("about:blank");
    await person.page.goto(link);
    await person.isReady();
    await person.seesText("#chart-title", "Pump");
    const elsewhere = person.requests().filter((url) =>
      !url.startsWith(person.url) && !/^(blob|data|about):/.test(url));
    assert.deepEqual(elsewhere, []);
    assert(person.requests().every((url) => !url.replace(/#.*/, "").includes("chart=")));
  },

  async "the page works offline"(person) {
    await person.sees("the service worker", () => navigator.serviceWorker.controller !== null);
    await person.disconnect();
    try {
      await person.page.reload();
      await person.isReady();
      await person.openExample("rule-5.grafcet");
    } finally {
      await person.connect();
    }
  },

  async "everything is reached by keyboard"(person) {
    await person.press("F4");
    await person.seesMark("chart", "step", "1", "active");
    await person.press("1");
    await person.seesMark("chart", "step", "2", "active");
    await person.seesMark("chart", "step", "5", "active");
    await person.press("b");
    await person.seesMark("chart", "step", "1", "active");
    await person.press("F9");
    await person.chord("Control", "Enter");
    await person.seesText("#verdict", "Equivalent");
    await person.press("?");
    await person.seesText("#help-dialog", "Keyboard");
    await person.press("Escape");
    const nameless = await person.page.evaluate(() =>
      [...document.querySelectorAll("button, select, input")].filter((one) =>
        !(one.textContent.trim() || one.getAttribute("aria-label") || one.labels?.length)).map((one) => one.outerHTML));
    assert.deepEqual(nameless, []);
  },

  async "a phone has tabs, and nothing is wider than its screen"(person) {
    await person.page.setViewport({ width: 360, height: 640, isMobile: true, hasTouch: true });
    const fits = () => person.page.evaluate(() => document.scrollingElement.scrollWidth <= innerWidth);
    assert(await fits());
    await person.goTo("picture");
    await person.seesMark("chart", "step", "1", "initial");
    assert(await fits());
    await person.goTo("run");
    await person.click(input("m"));
    await person.seesMark("chart", "step", "2", "active");
    assert(await fits());
    await person.goTo("check");
    await person.click("#check");
    await person.seesText("#verdict", "Equivalent");
    assert(await fits());
  },

  async "in French, everything is French"(person) {
    await person.click("#language");
    await person.seesText("#tab-check", "Vérifier");
    await person.writeAll(mistaken);
    await person.seesText("#findings-summary", "1 erreur");
    await person.seesText("#findings", "inconnu");
    await person.writeAll(pump);
    await person.seesText("#findings-summary", "3 étapes");
    await person.goTo("run");
    await person.click(input("start"));
    await person.seesText("#story", "règle 2");
    await person.goTo("check");
    await person.click("#check");
    await person.seesText("#verdict", "Équivalent");
    await person.page.reload();
    await person.isReady();
    await person.seesText("#tab-run", "Exécuter");
  },

  async "light and dark are a choice, and follow the system without one"(person) {
    const ground = () => person.page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor);
    await person.page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: "light" }]);
    const light = await ground();
    await person.page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: "dark" }]);
    await person.sees("another ground", (before) =>
      getComputedStyle(document.documentElement).backgroundColor !== before, light);
    await person.click("#theme");
    assert.equal(await ground(), light);
  },
};
