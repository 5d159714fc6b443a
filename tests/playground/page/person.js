// Somebody at the page: types, clicks on what is written on a button, and looks at what is shown.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const patience = 15000;

export class Person {
  figure = "";  // a measured value, shown beside the name of the case
  #complaints = [];
  #requests = [];

  static async visit(context, facts) {
    const person = new Person();
    Object.assign(person, facts, { context });
    person.page = await context.newPage();
    person.downloads = mkdtempSync(join(tmpdir(), "grafwire-page-"));
    person.#listen();
    await person.page.setViewport({ width: 1440, height: 900 });
    await person.page.bringToFront();
    const session = await person.page.createCDPSession();
    await session.send("Browser.setDownloadBehavior", {
      behavior: "allow", downloadPath: person.downloads, browserContextId: context.id,
    });
    await person.open();
    return person;
  }

  #listen() {
    this.page.on("pageerror", (error) => this.#complaints.push(`page: ${error.message}`));
    this.page.on("console", (message) => {
      if (message.type() === "error") this.#complaints.push(`console: ${message.text()}`);
    });
    this.page.on("request", (request) => this.#requests.push(request.url()));
  }

  complaints() {
    return this.#complaints;
  }

  requests() {
    return this.#requests;
  }

  async open(fragment = "") {
    await this.page.goto(this.url + fragment);
    await this.isReady();
  }

  isReady() {
    return this.page.waitForSelector("body[data-ready]", { timeout: patience });
  }

  // Waits until `question(...values)`, asked in the page, is true.
  async sees(what, question, ...values) {
    try {
      await this.page.waitForFunction(question, { timeout: patience, polling: 50 }, ...values);
    } catch (error) {
      throw new Error(`does not see: ${what} (${error.message})`);
    }
  }

  seesText(selector, part) {
    return this.sees(`"${part}" in ${selector}`, (where, text) =>
      [...document.querySelectorAll(where)].some((one) => one.textContent.replace(/[\u00a0\u202f]/g, " ").includes(text)), selector, part);
  }

  text(selector) {
    return this.page.$eval(selector, (one) => one.textContent);
  }

  // Whether the group of a drawing has the class: marked("chart", "step", "2", "active").
  seesMark(view, fact, name, className, isSet = true) {
    return this.sees(`${view}: ${fact} ${name} ${isSet ? "is" : "is not"} ${className}`, (pane, kind, which, mark, wanted) => {
      const root = document.querySelector(`.pane[data-view="${pane}"] .picture`).shadowRoot;
      const groups = [...root.querySelectorAll(`[data-${kind}="${CSS.escape(which)}"]`)];
      return groups.length > 0 && groups.some((group) => group.classList.contains(mark)) === wanted;
    }, view, fact, name, className, isSet);
  }

  countIn(view, selector) {
    return this.page.$eval(`.pane[data-view="${view}"] .picture`, (pane, what) =>
      pane.shadowRoot.querySelectorAll(what).length, selector);
  }

  async click(selector) {
    await this.page.waitForSelector(`${selector}:not(:disabled)`, { visible: true, timeout: patience });
    await this.page.click(selector);
  }

  press(...keys) {
    return keys.reduce((before, key) => before.then(() => this.page.keyboard.press(key)), Promise.resolve());
  }

  async chord(modifier, key) {
    await this.page.keyboard.down(modifier);
    await this.page.keyboard.press(key);
    await this.page.keyboard.up(modifier);
  }

  // Writes a text in the place of the whole one, as from the clipboard.
  async writeAll(text) {
    await this.page.click("#editor", { offset: { x: 150, y: 30 } });
    await this.chord("Control", "a");
    await this.page.keyboard.press("Delete");
    const session = await this.page.createCDPSession();
    await session.send("Input.insertText", { text });
    await session.detach();
  }

  type(text) {
    return this.page.keyboard.type(text);
  }

  choose(selector, value) {
    return this.page.select(selector, value);
  }

  // Without a network, until `connect`.
  disconnect() {
    return this.server.pause();
  }
  connect() {
    return this.server.resume();
  }

  async openExample(file) {
    await this.page.select("#examples", file);
    const text = readFileSync(join(this.folder, "examples", file), "utf8");
    const title = /^grafcet\s+\S+\s+"([^"]*)"/m.exec(text)[1];
    await this.seesText("#chart-title", title);
  }

  async goTo(mode) {
    await this.click(`#tab-${mode}`);
  }

  async download(exported, style = "") {
    await this.click("#open-export");
    if (style) await this.choose("#export-style", style);
    await this.click(`[data-export="${exported}"]`);
    const end = Date.now() + patience;
    while (Date.now() < end) {
      const files = readdirSync(this.downloads).filter((name) => !name.endsWith(".crdownload"));
      if (files.length) return { name: files[0], text: readFileSync(join(this.downloads, files[0]), "utf8") };
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
    throw new Error(`nothing was downloaded: ${await this.text("#notice")}`);
  }

  forgetDownloads() {
    for (const name of readdirSync(this.downloads)) rmSync(join(this.downloads, name));
  }

  // What the command line writes for a chart that stands in a file of that name.
  commandLine(name, text, ...options) {
    const folder = mkdtempSync(join(tmpdir(), "grafwire-line-"));
    writeFileSync(join(folder, name), text);
    return execFileSync(this.grafwire, options, { cwd: folder, encoding: "utf8" });
  }

  example(file) {
    return readFileSync(join(this.folder, "examples", file), "utf8");
  }
}
