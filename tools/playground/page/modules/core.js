// The core of grafwire in a worker of its own: asked by name, answers come as promises. A worker
// that is busy can be stopped; what it was asked then is answered by `stopped`.

export const stopped = Symbol("stopped");

const workerUrl = new URL("../core_worker.js", import.meta.url);

export class Core {
  #worker = null;
  #waiting = new Map();
  #last = 0;

  // ask("chart", {text}) → the answer. `onProgress` is told how far a check is.
  ask(name, args = {}, onProgress) {
    this.#worker ??= this.#start();
    const id = ++this.#last;
    return new Promise((resolve) => {
      this.#waiting.set(id, { resolve, onProgress });
      this.#worker.postMessage({ id, name, args });
    });
  }

  stop() {
    this.#worker?.terminate();
    this.#worker = null;
    this.#answerAll(stopped);
  }

  #start() {
    const worker = new Worker(workerUrl, { type: "module" });
    worker.addEventListener("message", ({ data: { id, progress, result } }) => {
      const asked = this.#waiting.get(id);
      if (!asked) return;
      if (progress) asked.onProgress?.(progress);
      if (result === undefined) return;
      this.#waiting.delete(id);
      asked.resolve(result);
    });
    worker.addEventListener("error", (event) => this.#answerAll({ error: event.message || "worker" }));
    return worker;
  }

  #answerAll(result) {
    for (const { resolve } of this.#waiting.values()) resolve(result);
    this.#waiting.clear();
  }
}
