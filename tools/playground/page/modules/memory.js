// What the browser keeps from one visit to the next. Where it may not keep anything, nothing is kept.

export function remembered(name) {
  try {
    return localStorage.getItem(`grafwire.${name}`);
  } catch {
    return null;
  }
}

export function remember(name, value) {
  try {
    localStorage.setItem(`grafwire.${name}`, value);
  } catch {
    // a private window, or storage that is full
  }
}
