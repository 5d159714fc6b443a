// The core in a worker: {id, name, args} in; {id, progress} any number of times, then {id, result} out.

import { load } from './core.js';

const core = load(new URL('core.wasm', import.meta.url));
const leastPause = 100;  // ms between two reports of progress

self.onmessage = async ({ data: { id, name, args } }) => {
    try {
        let reported = performance.now();
        const progress = (coverage) => {
            const now = performance.now();
            if (now - reported < leastPause) return;
            reported = now;
            self.postMessage({ id, progress: coverage });
        };
        self.postMessage({ id, result: (await core).call(name, args, { progress }) });
    } catch (error) {
        self.postMessage({ id, result: { error: String(error) } });
    }
};
