// The schematic, with the value of every net: 0, 1 or unknown. In slow motion the values are those
// in the middle of a wave of changes. Without a schematic the nets are a list of lamps.
import { element } from "./dom.js";
import { makePicturePane } from "./pane.js";
import { say } from "./words.js";

const classes = { 1: "one", 0: "zero", x: "unknown" };

export function createSchematicView(panes) {
  const { picture, remark, pane, body } = makePicturePane(panes, "wiring", "view_wiring", true);
  const list = element("div", { class: "nets", hidden: true });
  pane.append(list);
  let values = {};
  let changing = [];

  function markPicture() {
    for (const [value, name] of Object.entries(classes))
      picture.mark("net", name, Object.keys(values).filter((net) => values[net] === value));
    picture.mark("net", "changing", changing);
    picture.mark("cell", "changing", changing);  // a cell is called by the net that it drives
    if (changing.length) picture.reveal("net", changing[0]);
  }

  const lampOf = (net) =>
    element("span", { class: `lamp ${{ 1: "on", x: "x" }[values[net]] ?? ""}${changing.includes(net) ? " changing" : ""}` },
      `${net} ${values[net]}`);

  function apply() {
    body.hidden = picture.isEmpty;
    list.hidden = !picture.isEmpty;
    const nets = Object.keys(values);
    if (!picture.isEmpty) markPicture();
    else list.replaceChildren(...(nets.length ? nets.map(lampOf) : [element("p", { class: "hint" }, say("no_wiring"))]));
  }

  return {
    picture,
    show(svgs) {
      picture.show(svgs);
      apply();
    },
    remark: (text) => { remark.textContent = text; },
    mark(newValues = {}, newChanging = []) {
      values = newValues;
      changing = newChanging;
      apply();
    },
  };
}
