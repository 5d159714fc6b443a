// The pictures together: chart, equations, wiring, timing diagram, and the moment of a run that they
// show. Run and the replay of a witness both show their moments here.
import { createChartView } from "./chart-view.js";
import { createEquationsView } from "./equations-view.js";
import { createSchematicView } from "./schematic-view.js";
import { createTimingView } from "./timing-view.js";

export function createStage(panes) {
  const chart = createChartView(panes);
  const equations = createEquationsView(panes);
  const wiring = createSchematicView(panes);
  const timing = createTimingView(panes);
  let variables = new Map();  // of each step, as equations and nets call it

  return {
    chart, equations, wiring, timing,
    // The chart that the pictures show.
    setChart({ steps, macros = [] }) {
      chart.setMacros(macros);
      variables = new Map(steps.map(({ name, variable }) => [name, variable]));
    },
    stepOf(variable) {
      return [...variables].find(([, own]) => own === variable)?.[0];
    },
    // A state as the core tells it; none: nothing runs.
    showMoment(state, differing = []) {
      chart.mark(state ? { ...state, differing } : {});
      equations.mark((state?.situation ?? []).map((step) => variables.get(step)));
      if (!state?.gates) wiring.mark();
    },
  };
}
