// How the language of charts is coloured, by the words of the core: its keywords in both languages
// and its operators in all spellings.
import { HighlightStyle, StreamLanguage, syntaxHighlighting, tags } from "../codemirror.js";

const blank = /^[ \t\r]+/;
const quoted = /^"[^"\n]*"?/;
const number = /^\d+(\.\d+)?(us|ms|s|min|h)?(?![\p{L}\d_])/u;
const word = /^[\p{L}_][\p{L}\p{M}\d_]*/u;
const sign = /^(->|→|:=|\.\.|<>|<=|>=|[↑↓/!.·∧*&+∨|⊕¬=<>≤≥≠:,(){}\[\]-])/u;

// Keywords are read with and without accents.
const bare = (text) => text.normalize("NFD").replace(/\p{M}/gu, "");

export function grafcetLanguage(words) {
  const keywords = new Set(words.keywords.flatMap(({ en, fr }) => `${en} ${fr}`.split(" ")).map(bare));
  const operators = new Set(words.operators.flatMap((operator) => operator.words).map(bare));
  const controls = new Set(words.modes);
  return StreamLanguage.define({
    name: "grafcet",
    languageData: { commentTokens: { line: "#" }, closeBrackets: { brackets: ["(", "{", "[", '"'] } },
    token(stream) {
      if (stream.match(blank)) return null;
      if (stream.peek() === "#") {
        stream.skipToEnd();
        return "comment";
      }
      if (stream.match(quoted)) return "string";
      if (stream.match(number)) return "number";
      const found = stream.match(word);
      if (found) {
        const text = bare(found[0]);
        if (operators.has(text)) return "operator";
        if (keywords.has(text)) return "keyword";
        return controls.has(found[0]) ? "atom" : "variableName";
      }
      const mark = stream.match(sign);
      if (mark) return /[:,(){}\[\]]/.test(mark[0][0]) && mark[0] !== ":=" ? "punctuation" : "operator";
      stream.next();
      return null;
    },
  });
}

const colours = HighlightStyle.define([
  { tag: tags.keyword, color: "var(--keyword)", fontWeight: "600" },
  { tag: tags.operator, color: "var(--operator)" },
  { tag: tags.number, color: "var(--number)" },
  { tag: tags.string, color: "var(--text-literal)" },
  { tag: tags.comment, color: "var(--comment)", fontStyle: "italic" },
  { tag: tags.atom, color: "var(--accent)", fontWeight: "600" },
]);

export const grafcetColours = syntaxHighlighting(colours);
