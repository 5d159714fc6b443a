#!/usr/bin/env node
// bench.mjs [CORE]: how long the core takes for what a user waits for, in milliseconds: the first call, when
// the engine still translates the module, and the best of some more.

import { readFileSync } from 'node:fs';
import { gzipSync, brotliCompressSync } from 'node:zlib';
import { load } from './core/core.js';

const [path = new URL('../../build/playground/core.wasm', import.meta.url)] = process.argv.slice(2);
const bytes = readFileSync(path);
const example = (name) => readFileSync(new URL(`../../examples/${name}`, import.meta.url), 'utf8');

/// A chart of `count` steps in a ring, with an output each.
function ring(count) {
    const lines = ['grafcet ring', 'input a', `output ${[...Array(count).keys()].map((i) => `K${i}`).join(', ')}`, 'graph G {'];
    for (let i = 0; i < count; i++) lines.push(`  ${i ? 'step' : 'initial'} ${i} : K${i}`);
    for (let i = 0; i < count; i++) lines.push(`  ${i} -> ${(i + 1) % count} : ${i % 2 ? '/a' : 'a'}`);
    return [...lines, '}', ''].join('\n');
}

const nine = example('nine-steps.grafcet');
const fifty = ring(50);
const tasks = {
    'read nine steps': (core) => core.call('chart', { text: nine }),
    'read fifty steps': (core) => core.call('chart', { text: fifty }),
    'draw nine steps': (core) => core.call('draw', { text: nine }),
    'draw fifty steps': (core) => core.call('draw', { text: fifty }),
    'verdict of nine steps, nand': (core) => core.call('check', { text: nine, style: 'nand' }),
    'verdict of nine steps, gates': (core) => core.call('check', { text: nine, style: 'gates' }),
    'a step of a run with its gates': (core) => {
        const { run } = core.call('run.open', { text: nine, style: 'nand' });
        core.call('run.do', { run });
        core.call('run.do', { run, set: { m: 1 } });
    },
};

console.log(`core.wasm: ${bytes.length} bytes, gzip ${gzipSync(bytes, { level: 9 }).length}, brotli ${brotliCompressSync(bytes).length}`);
let began = performance.now();
const first = await load(bytes);
console.log(`${'compile and start'.padEnd(34)} ${(performance.now() - began).toFixed(1).padStart(8)}`);
for (const [name, task] of Object.entries(tasks)) {
    const times = [...Array(10)].map(() => {
        began = performance.now();
        const answer = task(first);
        if (answer?.error) throw new Error(answer.error);
        return performance.now() - began;
    });
    console.log(`${name.padEnd(34)} ${times[0].toFixed(1).padStart(8)} ${Math.min(...times).toFixed(1).padStart(8)}`);
}
