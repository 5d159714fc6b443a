// What may be completed: names of the chart, keywords in both languages, and operators under all
// their names. An operator that no keyboard has is found under what it is called: `rise`, `front`.
import { currentLanguage, say } from "./words.js";

const before = /[\p{L}_][\p{L}\p{M}\d_]*$/u;

// The kind of a completion shows as an icon; CodeMirror knows these.
const icons = {
  output: "property", step: "class", macro: "class", graph: "namespace",
};

function nameOptions(names) {
  return names.map(({ text, kind }) => ({
    label: text,
    type: icons[kind] ?? "variable",
    detail: say(`kind_${kind}`),
    boost: 2,
  }));
}

const bare = (text) => text.normalize("NFD").replace(/\p{M}/gu, "");

// A word with accents is found without them too.
function keywordOptions(keywords) {
  return keywords.flatMap(({ en, fr }) => [
    { label: en, type: "keyword", detail: fr },
    { label: fr, type: "keyword", detail: en },
    { label: bare(fr), displayLabel: fr, apply: fr, type: "keyword", detail: en },
  ]).filter(({ label, displayLabel }) => label !== displayLabel);
}

function operatorOptions(operators) {
  return operators.flatMap(({ name, symbols, words }) =>
    [...symbols, ...words].map((spelling) => ({
      label: spelling,
      type: "keyword",
      detail: spelling === symbols[0] ? meaning(name) : `${meaning(name)} = ${symbols[0]}`,
      boost: -1,
    })));
}

const known = new Set(["and", "or", "xor", "not", "rise", "fall"]);
const meaning = (name) => say(known.has(name) ? `operator_${name}` : "operator_other");

// Words under which operators are looked for though they are not spelled so.
const called = {
  en: { rise: ["rising"], fall: ["falling"] },
  fr: { rise: ["front_montant", "montant"], fall: ["front_descendant", "descendant"] },
};

function calledOptions(operators) {
  return operators.flatMap(({ name, symbols, words }) =>
    [...words, ...(called[currentLanguage()][name] ?? [])].map((word) => ({
      label: word,
      displayLabel: `${symbols[0]}  ${word}`,
      apply: symbols[0],
      type: "keyword",
      detail: meaning(name),
      boost: 1,
    })));
}

function withoutDoubles(options) {
  const seen = new Set();
  return options.filter(({ label, apply = label }) => {
    const key = `${label} ${apply}`;
    return !seen.has(key) && seen.add(key);
  });
}

// `names()`: those of the chart as it was last read, [{text, kind}].
export function grafcetCompletion(words, names) {
  return (context) => {
    const line = context.state.doc.lineAt(context.pos);
    if (line.text.slice(0, context.pos - line.from).includes("#")) return null;
    const started = context.matchBefore(before);
    if (!started && !context.explicit) return null;
    return {
      from: started ? started.from : context.pos,
      options: withoutDoubles([
        ...nameOptions(names()),
        ...calledOptions(words.operators),
        ...keywordOptions(words.keywords),
        ...operatorOptions(words.operators),
      ]),
      validFor: /^[\p{L}_][\p{L}\p{M}\d_]*$/u,
    };
  };
}
