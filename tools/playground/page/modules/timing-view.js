// The timing diagram of a run; its end stays in sight as it grows.
import { makePicturePane } from "./pane.js";
import { say } from "./words.js";

export function createTimingView(panes) {
  const { picture, remark, body } = makePicturePane(panes, "timing", "view_timing", true);
  return {
    picture,
    show(svg) {
      picture.show(svg ? [svg] : []);
      remark.textContent = svg ? "" : say("no_timing");
      body.scrollTop = body.scrollHeight;
    },
    // The moment of that time, set off.
    markTime: (ms) => picture.markTime(ms),
  };
}
