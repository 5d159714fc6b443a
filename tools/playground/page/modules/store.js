// What several parts of the page know together. A part that changes it calls set(); parts that
// depend on it are told, once for each change, which names have changed.

export function createStore(values) {
  const state = { ...values };
  const listeners = [];
  return {
    get: (name) => state[name],
    set(changes) {
      const changed = Object.keys(changes).filter((name) => state[name] !== changes[name]);
      Object.assign(state, changes);
      if (changed.length === 0) return;
      for (const { names, action } of listeners)
        if (names.some((name) => changed.includes(name))) action(state);
    },
    // Calls `action` whenever one of the names changes.
    on(names, action) {
      listeners.push({ names, action });
    },
  };
}
