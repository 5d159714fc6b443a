// A drawing of the core, shown in the page. The drawing keeps its own style sheet, inside a shadow
// root where it reaches nothing else; the page adds what its states look like, and sets and takes
// classes of the groups that the owners' names find. Nothing is drawn here.
import { isDark, onTheme } from "./theme.js";

// Whether the page is light or dark is the reader's choice, so the drawing's own question to the
// system is answered here.
const darkQuestion = /@media\s*\(prefers-color-scheme:\s*dark\)/g;

const states = new CSSStyleSheet();
states.replaceSync(`
:host { display: block; height: 100%; }
.sheets { display: flex; flex-direction: column; gap: 8px; align-items: safe center; min-height: 100%; padding: 8px; box-sizing: border-box; }
.sheets.fit { height: 100%; }
svg { display: block; flex: none; height: auto; }
.sheets.fit svg { max-width: 100%; }
.sheets.fit.single svg { max-height: 100%; width: auto; }
.sheets.fit.wide { height: auto; align-items: start; }
.sheets.fit.wide svg { max-height: none; }
.paper { fill: transparent; }
.ground { fill: var(--pane); }
[data-step] .ground { transition: fill 0.15s; }
.token:not(.active, .enabled, .clearable) { display: none; }
.token.enabled .mark { fill: var(--pane); stroke: var(--accent); stroke-width: 1.5; }
.active .ground { fill: var(--active); stroke: var(--active-line); stroke-width: 3.2; }
.enabled { stroke: var(--accent); }
.enabled text { fill: var(--accent); }
.clearable { stroke: var(--one); }
.clearable text { fill: var(--one); font-weight: bold; }
.clearable .frame { stroke-width: 5; }
.one { stroke: var(--one); stroke-width: 2.6; }
.one .ground { stroke: var(--one); }
.one .mark, .one text:not(.remark) { fill: var(--one); }
.zero { stroke: var(--strong-line); }
.unknown { stroke: var(--unknown); stroke-dasharray: 5 3; }
.unknown text { fill: var(--unknown); }
.changing { stroke-width: 4; }
.changing .ground { fill: var(--active); }
.here { stroke: var(--accent); stroke-width: 2; }
.wrong { stroke: var(--one); }
.wrong .ground { stroke: var(--one); stroke-width: 4; stroke-dasharray: 7 3; }
@media (prefers-reduced-motion: reduce) { [data-step] .ground { transition: none; } }
`);

const zoomStep = 1.25;

const units = { us: 0.001, ms: 1, s: 1000, min: 60000, h: 3600000 };

// `1.5s` in milliseconds.
function millisecondsOf(time) {
  const [, value, unit] = /^([\d.]+)(\w+)$/.exec(time) ?? [];
  return Number(value) * (units[unit] ?? NaN);
}

export class Picture {
  #root;
  #sheets;
  #isWide;
  #scale = null;       // null: fitted
  #sources = [];
  #groups = new Map();  // by fact and name
  #marks = new Map();   // by fact and class: the names that have it

  // `isWide`: it is fitted to the width, however high it gets.
  constructor(host, isWide = false) {
    this.#isWide = isWide;
    this.#root = host.attachShadow({ mode: "open" });
    this.#root.adoptedStyleSheets = [states];
    this.#sheets = document.createElement("div");
    this.#root.append(this.#sheets);
    this.#size();
    onTheme(() => this.#apply());
  }

  // Shows these SVG texts, one a sheet.
  show(svgs) {
    if (svgs.length === this.#sources.length && svgs.every((svg, i) => svg === this.#sources[i]))
      return;
    this.#sources = svgs;
    this.#apply();
  }

  get isEmpty() {
    return this.#sources.length === 0;
  }

  #apply() {
    const answer = isDark() ? "@media screen" : "@media not all";
    const parser = new DOMParser();
    this.#sheets.replaceChildren(...this.#sources.map((source) =>
      document.importNode(
        parser.parseFromString(source.replace(darkQuestion, answer), "image/svg+xml").documentElement,
        true)));
    this.#size();
    this.#findGroups();
    const marks = [...this.#marks.values()];
    this.#marks.clear();
    for (const { fact, className, names } of marks) this.mark(fact, className, names);
  }

  #findGroups() {
    this.#groups.clear();
    for (const group of this.#sheets.querySelectorAll("g"))
      for (const [fact, name] of Object.entries(group.dataset)) {
        const key = `${fact} ${name}`;
        if (!this.#groups.has(key)) this.#groups.set(key, []);
        this.#groups.get(key).push(group);
      }
  }

  // The groups whose fact `step`, `net`, … is that name.
  groups(fact, name) {
    return this.#groups.get(`${fact} ${name}`) ?? [];
  }

  // Lets exactly the groups with these names have the class.
  mark(fact, className, names) {
    const key = `${fact} ${className}`;
    const toggle = (name, isSet) => {
      for (const group of this.groups(fact, name)) group.classList.toggle(className, isSet);
    };
    const before = this.#marks.get(key)?.names ?? [];
    const now = new Set(names);
    for (const name of before) if (!now.has(name)) toggle(name, false);
    for (const name of now) toggle(name, true);
    this.#marks.set(key, { fact, className, names });
  }

  // The group of that name, scrolled into sight.
  reveal(fact, name) {
    this.groups(fact, name)[0]?.scrollIntoView({ block: "nearest", inline: "nearest" });
  }

  // The moments of a timing diagram at that time, in milliseconds, set off.
  markTime(ms) {
    for (const moment of this.#root.querySelectorAll(".moment[data-time]"))
      moment.classList.toggle("here", Math.abs(millisecondsOf(moment.dataset.time) - ms) < 1e-6);
  }

  // Larger or smaller by so many steps; 0: fitted again.
  zoom(by) {
    const svg = this.#sheets.firstElementChild;
    if (!svg) return;
    const now = svg.getBoundingClientRect().width / svg.viewBox.baseVal.width;
    this.#scale = by === 0 ? null : now * zoomStep ** by;
    this.#size();
  }

  #size() {
    this.#sheets.className = this.#scale === null ? "sheets fit" : "sheets";
    this.#sheets.classList.toggle("single", this.#sources.length === 1);
    this.#sheets.classList.toggle("wide", this.#isWide);
    for (const svg of this.#sheets.children) {
      svg.setAttribute("width", `${svg.viewBox.baseVal.width * (this.#scale ?? 1)}`);
      svg.removeAttribute("height");
    }
  }
}
