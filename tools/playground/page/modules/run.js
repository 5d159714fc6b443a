// A run of the chart: the session in the core, the clock, and what follows from each command. The
// store holds the last state (`run`).

const tick = 50;  // milliseconds of the clock while it plays

export function createRun(core, store, { onMoment }) {
  let handle = null;
  let state = null;
  let opening = 0;
  let timer = 0;
  let shownTime = 0;   // milliseconds of the run; while it plays, ahead of the last command
  let lastTick = 0;

  function options() {
    const style = store.get("runStyle");
    return {
      text: store.get("acceptedText"),
      lang: store.get("language"),
      period: store.get("period") ?? undefined,
      ...(style ? { style, cdx: store.get("cdx") || undefined, delay: store.get("delay") } : {}),
    };
  }

  // A state that came of a command: `before` are the values of nets that its changes start from.
  function take(answer, before) {
    state = answer;
    shownTime = state.now_ms;
    store.set({ run: state, runTime: shownTime, runError: "" });
    onMoment(state, before);
  }

  async function open() {
    pause();
    const mine = ++opening;
    if (handle !== null) core.ask("run.close", { run: handle });
    handle = state = null;
    let opened = await core.ask("run.open", options());
    let refusal = "";
    if (opened.error && store.get("runStyle")) {
      refusal = opened.error;
      opened = await core.ask("run.open", { ...options(), style: undefined });
    }
    if (mine !== opening) return;
    if (opened.error) {
      store.set({ run: null, runError: opened.error, runRefusal: "" });
      return;
    }
    handle = opened.run;
    store.set({ runRefusal: refusal });
    take(opened, opened.gates?.values);
    // Before its first instant every net is unknown; who wants to see that begins it himself.
    if (store.get("powerUp") !== "unknown") await command({ at_ms: 0 });
  }

  async function command(args) {
    if (handle === null) return;
    const mine = opening;
    const before = state?.gates?.values;
    const answer = await core.ask(args.back ? "run.back" : "run.do", { run: handle, ...args, back: undefined });
    if (mine !== opening) return;
    if (answer.error) return store.set({ runError: answer.error });
    const powerUp = answer.gates?.power_up;
    if (powerUp) answer.instants.unshift({ at_ms: answer.now_ms, gates: powerUp });
    take(answer, before);
  }

  const isPlaying = () => timer !== 0;

  function play() {
    if (isPlaying() || !state) return;
    lastTick = performance.now();
    timer = setInterval(onTick, tick);
    store.set({ playing: true });
  }

  function pause() {
    if (!isPlaying()) return;
    clearInterval(timer);
    timer = 0;
    store.set({ playing: false });
    if (!store.get("period") && state && Math.round(shownTime) > state.now_ms)
      command({ at_ms: Math.round(shownTime) });
  }

  let busy = false;
  async function onTick() {
    const now = performance.now();
    shownTime += (now - lastTick) * store.get("speed");
    lastTick = now;
    store.set({ runTime: shownTime });
    if (busy) return;
    busy = true;
    await catchUp();
    busy = false;
  }

  // Does what has become due meanwhile: scans, or the delays that end.
  async function catchUp() {
    const time = Math.floor(shownTime);
    const isDue = store.get("period") ? time - state.now_ms >= 1
                                      : state.next_ms !== null && state.next_ms <= time;
    if (!isDue) return;
    const ahead = shownTime;
    await command({ at_ms: store.get("period") ? time : state.next_ms });
    shownTime = Math.max(ahead, shownTime);
    if (!state.stable) pause();
  }

  return {
    open, play, pause, isPlaying,
    set(changes) {
      const time = Math.floor(shownTime);
      const isAhead = isPlaying() && !store.get("period") && state && time > state.now_ms;
      return command(isAhead ? { at_ms: time, set: changes } : { set: changes });
    },
    step: () => (store.get("period") ? command({ scan: true }) : command({ next: true })),
    scan: () => command({ scan: true }),
    back: () => command({ back: true }),
    timing: () => (handle === null ? Promise.resolve({}) : core.ask("run.timing", { run: handle, lang: store.get("language") })),
    stimuli: () => (handle === null ? Promise.resolve({}) : core.ask("run.stimuli", { run: handle })),
  };
}
