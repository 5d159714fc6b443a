// Elements made from code.

// element("button", {type: "button", onclick: f, dataset: {word: "play"}}, "text", child …)
export function element(tag, properties = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (value === undefined || value === null || value === false) continue;
    if (name === "dataset") Object.assign(made.dataset, value);
    else if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (name === "class") made.className = value;
    else made.setAttribute(name, value === true ? "" : value);
  }
  made.append(...children.flat().filter((child) => child !== undefined && child !== null));
  return made;
}

// A button whose text is a word of the catalogue.
export function wordButton(word, onclick, more = {}) {
  const { dataset, ...rest } = more;
  return element("button", { type: "button", onclick, dataset: { word, ...dataset }, ...rest });
}

export const byId = (id) => document.getElementById(id);

// Calls `action` once things have been quiet for that long.
export function afterQuiet(milliseconds, action) {
  let timer = 0;
  return (...values) => {
    clearTimeout(timer);
    timer = setTimeout(() => action(...values), milliseconds);
  };
}

// A choice among options [{value, text}]; keeps what was chosen where it is still there.
export function fillSelect(select, options, wanted = select.value) {
  select.replaceChildren(
    ...options.map(({ value, text }) => element("option", { value }, text)));
  if (options.some(({ value }) => value === wanted)) select.value = wanted;
}
