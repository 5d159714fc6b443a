// Slow motion: the changes of nets at an instant, one after the other. A wave knows the values
// before and after it; its place is how many changes have happened.
import { element, wordButton } from "./dom.js";
import { relabel, say } from "./words.js";

const pace = 350;  // milliseconds from change to change

// [[ns, net, value], …] of several instants as one wave.
export function changesOf(instants) {
  return instants.flatMap(({ at_ms, gates }) =>
    (gates?.changes ?? []).map(([ns, net, value]) => ({ at_ms, ns, net, value })));
}

// `show(values, changing)` is told what the nets have at the place.
export function createWave(show) {
  let before = {};
  let after = {};
  let changes = [];
  let place = 0;
  let timer = 0;
  const slider = element("input", { type: "range", min: "0", value: "0", dataset: { label: "wave_label" } });
  const slow = element("input", { type: "checkbox" });
  const now = element("p", { class: "gate-now" });
  const root = element("section", { class: "group" },
    element("h2", { dataset: { word: "wave_group" } }),
    element("div", { class: "wave" },
      wordButton("one_gate", () => oneGate(), { dataset: { tip: "one_gate_title" } }),
      slider,
      element("label", { class: "field" }, slow, element("span", { dataset: { word: "wave_slow" } }))),
    now);

  function tell() {
    if (changes.length === 0) return say("wave_none");
    if (place === 0) return say("wave_before", { all: changes.length });
    const { ns, net, value } = changes[place - 1];
    return say("wave_place", { n: place, all: changes.length, ns, net, value });
  }

  function goTo(where) {
    place = where;
    slider.max = String(changes.length);
    slider.value = String(place);
    slider.disabled = changes.length === 0;
    now.textContent = tell();
    const done = changes.slice(0, place).map(({ net, value }) => [net, value]);
    const values = place < changes.length ? { ...before, ...Object.fromEntries(done) } : after;
    show(values, place > 0 && place < changes.length ? [changes[place - 1].net] : []);
  }

  function oneGate() {
    clearTimeout(timer);
    if (changes.length) goTo(place < changes.length ? place + 1 : 1);
  }

  function play() {
    clearTimeout(timer);
    if (place >= changes.length) return;
    timer = setTimeout(() => {
      goTo(place + 1);
      play();
    }, pace);
  }

  slider.addEventListener("input", () => {
    clearTimeout(timer);
    goTo(Number(slider.value));
  });
  slow.addEventListener("change", () => (slow.checked ? begin() : end()));

  function begin() {
    goTo(0);
    play();
  }
  function end() {
    clearTimeout(timer);
    goTo(changes.length);
  }

  return {
    root,
    oneGate,
    relabel() {
      relabel(root);
      now.textContent = tell();
    },
    // A new wave: in slow motion from its beginning, else at its end.
    start(newBefore, newChanges, newAfter) {
      before = newBefore;
      after = newAfter;
      changes = newChanges;
      if (slow.checked) begin();
      else end();
    },
  };
}
