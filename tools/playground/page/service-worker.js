// Lets the page work without a network: all its files are kept at the first visit. The build puts
// the list of files in, and a version that changes with any of them.
const version = "VERSION";
const files = FILES;

const isOld = (name) => name.startsWith("grafwire-") && name !== `grafwire-${version}`;

async function keep() {
  const cache = await caches.open(`grafwire-${version}`);
  await cache.addAll(files.map((file) => new Request(file, { cache: "reload" })));
  await self.skipWaiting();
}

async function forgetOld() {
  for (const name of await caches.keys()) if (isOld(name)) await caches.delete(name);
  await self.clients.claim();
}

async function answer(request) {
  const cache = await caches.open(`grafwire-${version}`);
  return (await cache.match(request, { ignoreSearch: true })) ?? fetch(request);
}

self.addEventListener("install", (event) => event.waitUntil(keep()));
self.addEventListener("activate", (event) => event.waitUntil(forgetOld()));
self.addEventListener("fetch", (event) => {
  const isOurs = event.request.method === "GET" && event.request.url.startsWith(self.registration.scope);
  if (isOurs) event.respondWith(answer(event.request));
});
