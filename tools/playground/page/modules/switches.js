// Inputs as switches, control inputs as buttons that stay down.
import { element } from "./dom.js";
import { say } from "./words.js";

const tips = { Init: "init_title", AUdur: "audur_title", AUdoux: "audoux_title" };

// `onSet({name: value})` is called when one is switched.
export function createSwitches(onSet) {
  const inputs = element("div", { class: "switches" });
  const controls = element("div", { class: "bar" });
  let buttons = new Map();

  function make(name, rank) {
    return element("button", {
      type: "button", class: "switch", role: "switch", "aria-checked": "false", "aria-label": name,
      dataset: { input: name }, onclick: () => flip(name),
    },
    element("span", { class: "lever", "aria-hidden": "true" }),
    element("span", { class: "name" }, name),
    rank < 9 ? element("kbd", { "aria-hidden": "true" }, String(rank + 1)) : null);
  }

  function makeControl(name) {
    return element("button", {
      type: "button", "aria-pressed": "false", dataset: { input: name, tip: tips[name] },
      title: say(tips[name]), onclick: () => flip(name),
    }, name);
  }

  const isOn = (button) =>
    (button.getAttribute("aria-checked") ?? button.getAttribute("aria-pressed")) === "true";

  function flip(name) {
    onSet({ [name]: isOn(buttons.get(name)) ? 0 : 1 });
  }

  return {
    inputs, controls,
    rebuild(inputNames, controlNames) {
      const made = inputNames.map(make);
      const madeControls = controlNames.map(makeControl);
      buttons = new Map([...made, ...madeControls].map((button) => [button.dataset.input, button]));
      inputs.replaceChildren(...(made.length ? made : [element("p", { class: "hint", dataset: { word: "no_inputs" } }, say("no_inputs"))]));
      controls.replaceChildren(...madeControls);
    },
    // Lets them stand as the run has them.
    follow(values) {
      for (const [name, button] of buttons) {
        const attribute = button.hasAttribute("aria-checked") ? "aria-checked" : "aria-pressed";
        button.setAttribute(attribute, String(values[name] === 1));
      }
    },
    flipNumber(rank) {
      inputs.querySelectorAll("button")[rank]?.click();
    },
  };
}
