#!/usr/bin/env node
// compare.mjs ANSWERS [CORE]: puts questions to the core of build/playground, or to another, and compares
// the answers with those of this machine, which test_playground writes down where GRAFWIRE_ANSWERS
// names a file. Prints what differs; the exit status is 1 then.

import { readFileSync } from 'node:fs';
import { load } from './core/core.js';

const [answers, module = new URL('../../build/playground/core.wasm', import.meta.url)] = process.argv.slice(2);
const compiled = new WebAssembly.Module(readFileSync(module));
const cores = new Map();
let differences = 0;
let count = 0;

for (const line of readFileSync(answers, 'utf8').split('\n').filter(Boolean)) {
    const { core: number, request, answer } = JSON.parse(line);
    if (!cores.has(number)) cores.set(number, await load(compiled));
    const got = JSON.stringify(withoutSeconds(cores.get(number).call(request.name, request.args)));
    const expected = JSON.stringify(withoutSeconds(answer));
    count++;
    if (got === expected) continue;
    differences++;
    let at = 0;
    while (got[at] === expected[at]) at++;
    console.log(`${JSON.stringify(request).slice(0, 200)}\n  expected …${expected.slice(at - 40, at + 80)}\n  got      …${got.slice(at - 40, at + 80)}`);
}
console.log(`${count} questions, ${differences} answered otherwise`);
process.exit(differences === 0 ? 0 : 1);

/// JUnit reports say how long a check took.
function withoutSeconds(answer) {
    return JSON.parse(JSON.stringify(answer).replace(/ time=\\"[^"]*"/g, ''));
}
