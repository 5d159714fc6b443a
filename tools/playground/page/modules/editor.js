// The editor of the chart's text: CodeMirror, with the language of charts.
import {
  Annotation, Compartment, EditorState, EditorView, autocompletion, bracketMatching, closeBrackets,
  closeBracketsKeymap, completionKeymap, defaultKeymap, drawSelection, highlightActiveLine,
  highlightActiveLineGutter, highlightSelectionMatches, highlightSpecialChars, history,
  historyKeymap, keymap, lineNumbers, lintGutter, lintKeymap, searchKeymap, setDiagnostics,
} from "../codemirror.js";
import { grafcetCompletion } from "./completion.js";
import { grafcetColours, grafcetLanguage } from "./grafcet-mode.js";
import { currentLanguage, say } from "./words.js";

const look = EditorView.theme({
  "&": { color: "var(--ink)", backgroundColor: "var(--pane)" },
  ".cm-scroller": { fontFamily: "var(--mono)", lineHeight: "1.55" },
  ".cm-content": { caretColor: "var(--ink)" },
  ".cm-cursor": { borderLeftColor: "var(--ink)" },
  ".cm-gutters": { color: "var(--muted)", backgroundColor: "var(--raised)", borderRight: "1px solid var(--line)" },
  ".cm-activeLine": { backgroundColor: "color-mix(in srgb, var(--accent-soft) 45%, transparent)" },
  ".cm-activeLineGutter": { backgroundColor: "var(--accent-soft)" },
  "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground":
    { backgroundColor: "color-mix(in srgb, var(--accent) 28%, transparent)" },
  ".cm-tooltip, .cm-panels": { color: "var(--ink)", backgroundColor: "var(--raised)", border: "1px solid var(--strong-line)" },
  ".cm-tooltip-autocomplete > ul > li[aria-selected]": { color: "var(--accent-ink)", backgroundColor: "var(--accent)" },
  ".cm-diagnostic-error": { borderLeftColor: "var(--bad)" },
  ".cm-diagnostic-warning": { borderLeftColor: "var(--warn)" },
  ".cm-searchMatch": { backgroundColor: "var(--active)" },
  ".cm-matchingBracket, &.cm-focused .cm-matchingBracket": { backgroundColor: "var(--accent-soft)", outline: "1px solid var(--accent)" },
});

// The words of CodeMirror itself, where it shows any.
const frenchPhrases = {
  "Find": "Rechercher", "Replace": "Remplacer", "next": "suivant", "previous": "précédent",
  "all": "tout", "match case": "respecter la casse", "by word": "mot entier",
  "regexp": "expression", "replace": "remplacer", "replace all": "tout remplacer",
  "close": "fermer", "No diagnostics": "Aucune erreur", "Diagnostics": "Erreurs",
  "Completions": "Propositions", "Control character": "Caractère de commande",
};

// Marks a change that comes from the page, not from who types.
const fromPage = Annotation.define();

// Makes the editor in `parent`. `onChange(text)` is called as one types; `names()` gives what may be
// completed.
export function createEditor(parent, { words, names, onChange }) {
  const language = new Compartment();
  const inLanguage = () => [
    EditorState.phrases.of(currentLanguage() === "fr" ? frenchPhrases : {}),
    EditorView.contentAttributes.of({ "aria-label": say("editor_label"), spellcheck: "false" }),
  ];
  const view = new EditorView({
    parent,
    state: EditorState.create({
      extensions: [
        lineNumbers(), highlightActiveLineGutter(), highlightSpecialChars(), history(),
        drawSelection(), highlightActiveLine(), bracketMatching(), closeBrackets(),
        highlightSelectionMatches(), lintGutter(), autocompletion({
          override: [grafcetCompletion(words, names)], icons: false,
        }),
        keymap.of([...closeBracketsKeymap, ...defaultKeymap, ...searchKeymap, ...historyKeymap,
          ...completionKeymap, ...lintKeymap]),
        grafcetLanguage(words), grafcetColours, look, language.of(inLanguage()),
        EditorView.updateListener.of((update) => {
          const typed = !update.transactions.some((one) => one.annotation(fromPage));
          if (update.docChanged && typed) onChange(view.state.doc.toString());
        }),
      ],
    }),
  });
  return {
    text: () => view.state.doc.toString(),
    // Another text; what is seen of it begins where the chart does, below the remarks at its head.
    setText(text) {
      const anchor = Math.max(text.search(/^grafcet\b/m), 0);
      view.dispatch({
        changes: { from: 0, to: view.state.doc.length, insert: text },
        selection: { anchor }, annotations: fromPage.of(true),
      });
      view.dispatch({ effects: EditorView.scrollIntoView(anchor, { y: "start" }) });
    },
    insert(text) {
      view.dispatch(view.state.replaceSelection(text), { userEvent: "input.type" });
      view.focus();
    },
    // Messages at their places: [{severity, message, from, to}], in UTF-16 units.
    showFindings(findings) {
      const end = view.state.doc.length;
      const marks = findings.filter(({ line }) => line > 0).map(({ severity, message, from, to }) =>
        ({ severity, message, from: Math.min(from, end), to: Math.min(Math.max(from, to), end) }));
      view.dispatch(setDiagnostics(view.state, marks));
    },
    goTo(from) {
      const anchor = Math.min(from, view.state.doc.length);
      view.dispatch({ selection: { anchor }, effects: EditorView.scrollIntoView(anchor, { y: "center" }) });
      view.focus();
    },
    relabel() {
      view.dispatch({ effects: language.reconfigure(inLanguage()) });
    },
    focus: () => view.focus(),
  };
}
