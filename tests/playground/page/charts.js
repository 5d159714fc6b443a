// A sequence of so many steps, each with a condition of its own.
export function sequenceOf(steps) {
  const numbers = [...Array(steps).keys()];
  return [
    `grafcet long "Long"`, `input ${numbers.map((i) => `a${i}`).join(", ")}`, "graph G1 {", "  initial 0",
    ...numbers.slice(1).map((i) => `  step ${i}`),
    ...numbers.map((i) => `  ${i} -> ${(i + 1) % steps} : a${i}`), "}", ""].join("\n");
}
