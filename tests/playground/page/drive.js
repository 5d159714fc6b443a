// Runs the cases in Chromium and says which passed. Arguments: the module puppeteer-core, the folder
// of the page, and either the program grafwire and a part of the names of cases, or --figures.
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { cases } from "./cases.js";
import { figures } from "./figures.js";
import { Person } from "./person.js";
import { serveFolder } from "./serve_folder.js";

const [module, ...places] = process.argv.slice(2);
const [folder, grafwire] = places.map((place) => resolve(place));
const wanted = places[2] ?? "";
const all = places[1] === "--figures" ? figures : { ...figures, ...cases };
const { default: puppeteer } = await import(pathToFileURL(resolve(module)));

const server = await serveFolder(folder);
const browser = await puppeteer.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--lang=en", "--disable-gpu"],
});

let passed = 0;
let failed = 0;
for (const [name, run] of Object.entries(all)) {
  if (!name.includes(wanted)) continue;
  const began = performance.now();
  // Each case is a visitor of its own: nothing is remembered from the one before.
  const context = await browser.createBrowserContext();
  const person = await Person.visit(context, { url: server.url, folder, grafwire, server });
  let trouble = "";
  try {
    await run(person);
    const complaints = person.complaints();
    if (complaints.length) throw new Error(complaints.join("\n"));
  } catch (error) {
    trouble = error.stack;
    if (process.env.PICTURES) await person.page.screenshot({ path: `${process.env.PICTURES}/${name}.png` });
  }
  await context.close();
  const seconds = ((performance.now() - began) / 1000).toFixed(1);
  console.log(`${trouble ? "FAILED" : "passed"}  ${name} (${seconds} s)${person.figure ? `: ${person.figure}` : ""}`);
  if (trouble) console.log(trouble.replace(/^/gm, "    "));
  trouble ? failed++ : passed++;
}
await browser.close();
await server.close();
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed || !passed ? 1 : 0);
