// Keys of the whole page. While one types, only the function keys and those with Ctrl count.

const modeKeys = { F2: "text", F4: "run", F9: "check" };

const isTyping = (target) =>
  target.closest("input[type=text], select, textarea, [contenteditable=true]") !== null;

export function listenForKeys({ modes, export_, help, check, run, wave, witness, flip, mode }) {
  const inRun = { " ": run.toggle, s: run.step, c: run.scan, b: run.back, g: wave };
  const inCheck = { ArrowLeft: witness.previous, ArrowRight: witness.next };

  function actionOf(event) {
    const { key, target } = event;
    if (key in modeKeys) return () => modes(modeKeys[key]);
    if ((event.ctrlKey || event.metaKey) && key === "s") return export_;
    if ((event.ctrlKey || event.metaKey) && key === "Enter") return check;
    if (event.ctrlKey || event.metaKey || event.altKey || isTyping(target)) return null;
    if (document.querySelector("dialog[open]")) return null;
    if (key === "?") return help;
    // A button that has the focus keeps the space bar, a slider its arrows.
    if (key === " " && target.closest("button, summary, [tabindex]:not(main):not(.panel)")) return null;
    if (key.startsWith("Arrow") && target.closest("input, [role=tab], .picture")) return null;
    if (mode() === "run" && /^[1-9]$/.test(key)) return () => flip(Number(key) - 1);
    if (mode() === "run") return inRun[key.toLowerCase()] ?? null;
    return mode() === "check" ? inCheck[key] ?? null : null;
  }

  document.addEventListener("keydown", (event) => {
    const action = actionOf(event);
    if (!action) return;
    event.preventDefault();
    action();
  });
}
