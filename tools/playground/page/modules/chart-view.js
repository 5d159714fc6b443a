// The chart, and what is active, enabled and clearable in it.
import { makePicturePane } from "./pane.js";

export function createChartView(panes) {
  const { picture, remark } = makePicturePane(panes, "chart", "view_chart");
  let macros = [];
  return {
    picture,
    // The macro-steps of the chart, each active while one of its steps is.
    setMacros(all) {
      macros = all;
    },
    show: (svg) => picture.show([svg]),
    remark: (text) => { remark.textContent = text; },
    // The situation of a run; without one nothing is marked.
    mark({ situation = [], enabled = [], clearable = [], differing = [] } = {}) {
      picture.mark("step", "active", situation);
      picture.mark("macro", "active", macros.filter(({ steps = [] }) =>
        steps.some((step) => situation.includes(step))).map(({ name }) => name));
      picture.mark("transition", "enabled", enabled.filter((name) => !clearable.includes(name)));
      picture.mark("transition", "clearable", clearable);
      picture.mark("step", "wrong", differing);
    },
  };
}
