// The witness of a check, replayed instant by instant: a run of the same chart with the same wiring,
// which takes the stimuli of the witness one after the other.

export class Replay {
  #core;
  #run = null;
  #moments = [];

  constructor(core) {
    this.#core = core;
  }

  // The moments of the witness, one for each of its instants: {state, before, text}. `options` are
  // those of the check.
  async moments(options, witness) {
    await this.close();
    const { text, lang, style, cdx, delay } = options;
    const opened = await this.#core.ask("run.open", { text, lang, style, cdx, delay, period: witness.period });
    if (opened.error) return { error: opened.error };
    this.#run = opened.run;
    this.#moments = [];
    let before = opened.gates?.values;
    for (const command of commandsOf(witness)) {
      const state = await this.#core.ask("run.do", { run: this.#run, ...command });
      if (state.error) return { error: state.error };
      this.#moments.push({ state, before });
      before = state.gates?.values;
      if (!state.stable) break;
    }
    return { moments: this.#moments };
  }

  async close() {
    if (this.#run !== null) await this.#core.ask("run.close", { run: this.#run });
    this.#run = null;
  }
}

// An instant after the other; time that passes after the last one ends delays, or does scans.
function commandsOf({ instants, end_ms, period }) {
  if (period) return [...instants.flatMap(({ at_ms, set }) => [{ at_ms, set }, { scan: true }])];
  const last = instants.length ? instants[instants.length - 1].at_ms : -1;
  const commands = instants.map(({ at_ms, set }) => ({ at_ms, set }));
  return end_ms > last ? [...commands, { at_ms: end_ms }] : commands;
}
