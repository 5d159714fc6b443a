// A link that holds the chart: its text, deflated, as base64url in the fragment. A fragment is never
// sent to a server.

async function through(bytes, transform) {
  const stream = new Blob([bytes]).stream().pipeThrough(transform);
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function toBase64Url(bytes) {
  let binary = "";
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

function fromBase64Url(text) {
  const binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  return Uint8Array.from(binary, (character) => character.charCodeAt(0));
}

export async function fragmentOf(chart) {
  const bytes = new TextEncoder().encode(chart);
  return `#chart=${toBase64Url(await through(bytes, new CompressionStream("deflate-raw")))}`;
}

// The chart in a fragment; null where it holds none. Throws where it holds one that is damaged.
export async function chartOf(fragment) {
  const match = /^#chart=([\w-]+)$/.exec(fragment);
  if (!match) return fragment.startsWith("#chart=") ? Promise.reject(new Error("damaged")) : null;
  const bytes = await through(fromBase64Url(match[1]), new DecompressionStream("deflate-raw"));
  return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
}
