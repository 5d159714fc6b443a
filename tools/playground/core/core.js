// Loads the core and calls it: objects in, objects out.

const encoder = new TextEncoder();
const decoder = new TextDecoder();

class Core {
    #exports;
    #progress = null;

    constructor(module) {
        const imports = {
            page: {
                normalise: (text, size, result) => this.#normalise(text, size, result),
                progress: (situations, cases, unstable, waiting) =>
                    this.#progress?.({ situations, cases, unstable, waiting }) === false ? 0 : 1,
            },
            wasi_snapshot_preview1: systemOf(() => this.#exports.memory.buffer),
        };
        this.#exports = new WebAssembly.Instance(module, imports).exports;
        this.#exports._initialize();
    }

    /// The answer to a request. `progress` is shown how far a check is; where it returns false the
    /// check ends undecided.
    call(name, args = {}, { progress = null } = {}) {
        const request = encoder.encode(JSON.stringify({ name, args }));
        const place = this.#exports.playground_allocate(request.length);
        this.#bytes(place, request.length).set(request);
        this.#progress = progress;
        try {
            const size = this.#exports.playground_call(place, request.length);
            return JSON.parse(decoder.decode(this.#bytes(this.#exports.playground_answer(), size)));
        } finally {
            this.#progress = null;
            this.#exports.playground_free(place);
        }
    }

    #bytes(place, size) {
        return new Uint8Array(this.#exports.memory.buffer, place, size);
    }

    /// What utf8proc_map does in libraries/utf8proc.
    #normalise(text, size, result) {
        let given;
        try {
            given = new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(this.#bytes(text, size));
        } catch {
            return -1;
        }
        const composed = encoder.encode(given.normalize('NFC'));
        const place = this.#exports.playground_allocate(Math.max(composed.length, 1));
        this.#bytes(place, composed.length).set(composed);
        new DataView(this.#exports.memory.buffer).setUint32(result, place, true);
        return composed.length;
    }
}

/// What the C library asks of its system. There are no files, and the core prints nothing but what
/// it says before it breaks down.
function systemOf(memory) {
    const badFile = 8;
    const calls = {
        fd_write(file, texts, count, written) {
            const view = new DataView(memory());
            let size = 0;
            let text = '';
            for (let i = 0; i < count; i++) {
                const length = view.getUint32(texts + 8 * i + 4, true);
                text += decoder.decode(new Uint8Array(memory(), view.getUint32(texts + 8 * i, true), length));
                size += length;
            }
            view.setUint32(written, size, true);
            if (text) console.error(text);
            return 0;
        },
        proc_exit(status) {
            throw new Error(`the core ended with ${status}`);
        },
        environ_sizes_get(count, size) {
            const view = new DataView(memory());
            view.setUint32(count, 0, true);
            view.setUint32(size, 0, true);
            return 0;
        },
        environ_get: () => 0,
    };
    return new Proxy(calls, { get: (known, name) => known[name] ?? (() => badFile) });
}

/// The core in `source`: an address, an answer to fetch(), bytes, or a compiled module.
export async function load(source) {
    if (source instanceof WebAssembly.Module) return new Core(source);
    if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) {
        return new Core(await WebAssembly.compile(source));
    }
    const response = source instanceof Response ? source : await fetch(source);
    if (!response.ok) throw new Error(`${response.url}: ${response.status}`);
    // A host that calls the module something else than application/wasm serves as well.
    return new Core(await WebAssembly.compile(await response.arrayBuffer()));
}
