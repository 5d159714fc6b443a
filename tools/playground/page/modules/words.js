// All words of the page, in English and in French, and what shows them. What the core says (messages,
// reports, stories) comes from its own catalogues.

const catalogue = {
  // the frame
  skip: ["Skip to the work", "Aller au contenu"],
  examples: ["Examples", "Exemples"],
  choose_example: ["Examples…", "Exemples…"],
  export: ["Export", "Exporter"],
  share: ["Link", "Lien"],
  share_title: ["Copy a link that holds the whole chart", "Copier un lien qui contient tout le grafcet"],
  help: ["Keyboard and help", "Clavier et aide"],
  language: ["Français", "English"],
  theme_dark: ["Dark colours", "Couleurs sombres"],
  theme_light: ["Light colours", "Couleurs claires"],
  modes: ["What to do", "Activité"],
  tab_text: ["Text", "Texte"],
  tab_picture: ["Picture", "Dessin"],
  tab_run: ["Run", "Exécuter"],
  tab_check: ["Check", "Vérifier"],
  pictures: ["Pictures", "Dessins"],
  views: ["What is shown", "Ce qui est affiché"],
  view_chart: ["Chart", "Grafcet"],
  view_equations: ["Equations", "Équations"],
  view_wiring: ["Wiring", "Câblage"],
  view_timing: ["Timing", "Chronogramme"],
  fit: ["Fit", "Ajuster"],
  larger: ["Larger", "Agrandir"],
  smaller: ["Smaller", "Réduire"],
  close: ["Close", "Fermer"],
  link_copied: ["The link is copied. It holds the whole chart.", "Le lien est copié. Il contient tout le grafcet."],
  link_in_address: ["The link is in the address bar.", "Le lien est dans la barre d'adresse."],
  link_unreadable: ["The link does not hold a chart that can be read.", "Le lien ne contient pas de grafcet lisible."],
  loading: ["The core is loading …", "Chargement du noyau…"],
  core_failed: ["The core could not be loaded: {why}", "Le noyau n'a pas pu être chargé : {why}"],
  new_chart: ["New chart", "Nouveau grafcet"],
  open_file: ["Open a file…", "Ouvrir un fichier…"],

  // text
  editor_label: ["The chart as text", "Le grafcet sous forme de texte"],
  symbols: ["Symbols", "Symboles"],
  accepted: ["No mistakes. {steps}, {transitions}.", "Aucune erreur. {steps}, {transitions}."],
  steps_one: ["1 step", "1 étape"],
  steps_many: ["{n} steps", "{n} étapes"],
  transitions_one: ["1 transition", "1 transition"],
  transitions_many: ["{n} transitions", "{n} transitions"],
  errors_one: ["1 mistake", "1 erreur"],
  errors_many: ["{n} mistakes", "{n} erreurs"],
  warnings_one: ["1 warning", "1 avertissement"],
  warnings_many: ["{n} warnings", "{n} avertissements"],
  error: ["error", "erreur"],
  warning: ["warning", "avertissement"],
  note: ["note", "remarque"],
  last_valid: ["as it was before the mistake", "état avant l'erreur"],
  kind_input: ["input", "entrée"],
  kind_output: ["output", "sortie"],
  kind_var: ["var", "variable"],
  kind_counter: ["counter", "compteur"],
  kind_step: ["step", "étape"],
  kind_graph: ["graph", "graphe"],
  kind_macro: ["macro-step", "macro-étape"],
  kind_control: ["control input", "entrée de commande"],
  operator_and: ["AND", "ET"],
  operator_or: ["OR", "OU"],
  operator_xor: ["exclusive OR", "OU exclusif"],
  operator_not: ["NOT", "NON"],
  operator_rise: ["rising edge", "front montant"],
  operator_fall: ["falling edge", "front descendant"],
  symbol_arrow: ["from steps to steps", "d'étapes à étapes"],
  symbol_colon: ["under the condition", "sous la réceptivité"],
  operator_other: ["operator", "opérateur"],

  // equations
  eq_steps: ["Equations of the steps", "Équations des étapes"],
  eq_cax: ["Activation and deactivation", "Activation et désactivation"],
  eq_transitions: ["Transitions", "Transitions"],
  eq_outputs: ["Outputs", "Sorties"],
  eq_step: ["Step", "Étape"],
  eq_equation: ["Equation", "Équation"],
  eq_cax_head: ["CAX", "CAX"],
  eq_cdx_head: ["CDX", "CDX"],
  eq_transition: ["Transition", "Transition"],
  eq_steps_head: ["Steps", "Étapes"],
  eq_clearing: ["Clearing condition", "Condition de franchissement"],
  eq_output: ["Output", "Sortie"],

  // run
  restart: ["Restart", "Recommencer"],
  evolve: ["Evolution", "Évolution"],
  until_stable: ["until stable", "jusqu'à stabilité"],
  by_scans: ["scan by scan", "par scrutations"],
  period: ["every", "toutes les"],
  style: ["Wiring", "Câblage"],
  without_gates: ["none", "aucun"],
  power_up: ["Power-up", "Mise sous tension"],
  power_up_known: ["initial situation", "situation initiale"],
  power_up_unknown: ["unknown values (x)", "valeurs inconnues (x)"],
  time_group: ["Time", "Temps"],
  play: ["Play", "Lecture"],
  pause: ["Pause", "Pause"],
  step_once: ["Step", "Pas"],
  step_title: ["On to the end of the next delay", "Jusqu'à la fin de la prochaine temporisation"],
  one_scan: ["One scan", "Une scrutation"],
  one_gate: ["One gate", "Une porte"],
  one_gate_title: ["The next change of a net at this instant", "Le prochain changement d'un fil à cet instant"],
  back: ["Back", "Revenir"],
  speed: ["Speed", "Vitesse"],
  inputs_group: ["Inputs", "Entrées"],
  no_inputs: ["The chart has no inputs.", "Le grafcet n'a pas d'entrées."],
  init_title: ["Init: into the initial situation", "Init : mise en situation initiale"],
  audur_title: ["AUdur: deactivate every step", "AUdur : désactivation de toutes les étapes"],
  audoux_title: ["AUdoux: continuous actions off, the steps stay", "AUdoux : actions continues à 0, les étapes restent"],
  now_group: ["Now", "Maintenant"],
  situation: ["Situation", "Situation"],
  no_step: ["no step is active", "aucune étape active"],
  outputs: ["Outputs", "Sorties"],
  counters: ["Counters", "Compteurs"],
  internal: ["Variables", "Variables"],
  clearable_now: ["Clearable", "Franchissables"],
  waits: ["Enabled", "Validées"],
  none: ["none", "aucune"],
  next_delay: ["Next delay ends", "Prochaine fin de temporisation"],
  rules_group: ["What happens, and by which rule", "Ce qui se passe, et selon quelle règle"],
  wave_group: ["Gate by gate", "Porte par porte"],
  wave_slow: ["Slow motion", "Ralenti"],
  wave_place: ["Change {n} of {all}: at +{ns} ns {net} becomes {value}", "Changement {n} sur {all} : à +{ns} ns, {net} passe à {value}"],
  wave_before: ["Before the first of {all} changes", "Avant le premier de {all} changements"],
  wave_none: ["No net changes at this instant.", "Aucun fil ne change à cet instant."],
  wave_label: ["Place in the wave of changes", "Position dans la vague de changements"],
  gates_differ: ["The gates give another situation: {steps}", "Les portes donnent une autre situation : {steps}"],
  not_settled: ["The gates do not settle.", "Les portes ne se stabilisent pas."],
  style_refused: ["This wiring cannot hold the chart: {why}", "Ce câblage ne convient pas à ce grafcet : {why}"],
  mend_first: ["The text has mistakes; mend them first.", "Le texte contient des erreurs ; corrigez-les d'abord."],
  no_wiring: ["No wiring is shown yet.", "Aucun câblage à afficher pour l'instant."],
  no_timing: ["Nothing has run yet.", "Rien n'a encore été exécuté."],

  // check
  named: ["{name}: {description}", "{name} : {description}"],
  check_group: ["Wiring that is to be proved", "Câblage à prouver"],
  style_label: ["Style", "Style"],
  cdx_label: ["Form of CDX", "Forme de CDX"],
  cdx_own: ["the style's own", "celle du style"],
  delays_label: ["Delays", "Retards"],
  changes_label: ["Changes", "Changements"],
  changes_one: ["one input at a time", "une entrée à la fois"],
  changes_many: ["many at once", "plusieurs à la fois"],
  check_now: ["Check", "Vérifier"],
  stop: ["Stop", "Arrêter"],
  checking: ["Checking: {situations} situations, {cases} cases compared", "Vérification : {situations} situations, {cases} cas comparés"],
  checking_starts: ["Checking …", "Vérification en cours…"],
  stopped: ["Stopped before a verdict.", "Arrêté avant le verdict."],
  equivalent: ["Equivalent", "Équivalent"],
  different: ["Different", "Différent"],
  undecided: ["Undecided", "Indécis"],
  equivalent_says: ["In every case that can be reached the wiring does what the GRAFCET says.", "Dans tous les cas atteignables, le câblage fait ce que dit le GRAFCET."],
  different_says: ["There is a case in which the wiring does something else. Below, the shortest one.", "Il existe un cas où le câblage fait autre chose. Voici le plus court."],
  undecided_says: ["The check ended without a proof and without a difference.", "La vérification s'est terminée sans preuve ni différence."],
  took: ["{seconds} s", "{seconds} s"],
  witness_group: ["The witness, step by step", "Le témoin, pas à pas"],
  first: ["Beginning", "Début"],
  previous: ["Previous", "Précédent"],
  next: ["Next", "Suivant"],
  last: ["Difference", "Différence"],
  witness_place: ["Step {n} of {all}", "Pas {n} sur {all}"],
  report_group: ["Report", "Rapport"],
  out_of_date: ["The text has changed since this verdict.", "Le texte a changé depuis ce verdict."],
  they_part: ["Here they part: {what}", "Ici, ils se séparent : {what}"],
  gives: ["{name}: GRAFCET {expected}, wiring {got}", "{name} : GRAFCET {expected}, câblage {got}"],

  // export
  export_title: ["Export", "Exporter"],
  export_says: ["The same files as those of the command line. Nothing leaves this machine.", "Les mêmes fichiers que ceux de la ligne de commande. Rien ne quitte cette machine."],
  export_chart: ["Chart", "Grafcet"],
  export_equations: ["Equations", "Équations"],
  export_netlist: ["Wiring", "Câblage"],
  export_program: ["Program", "Programme"],
  export_run: ["Run", "Exécution"],
  export_check: ["Proof", "Preuve"],
  chart_text: ["the chart as it is written", "le grafcet tel qu'il est écrit"],
  run_stim: ["the stimuli of this run", "les stimuli de cette exécution"],
  run_needed: ["Run the chart first to export its run.", "Exécutez d'abord le grafcet pour exporter l'exécution."],
  downloaded: ["{name} is downloaded.", "{name} est téléchargé."],
  export_refused: ["{name}: {why}", "{name} : {why}"],

  // help
  help_title: ["Keyboard", "Clavier"],
  key_name_Space: ["Space", "Espace"],
  key_name_Enter: ["Enter", "Entrée"],
  key_modes: ["Text, Run, Check", "Texte, Exécuter, Vérifier"],
  key_complete: ["complete a name or an operator", "compléter un nom ou un opérateur"],
  key_next_error: ["next mistake", "erreur suivante"],
  key_leave: ["leave the editor", "quitter l'éditeur"],
  key_switch: ["switch the 1st to 9th input (in Run)", "basculer la 1re à la 9e entrée (dans Exécuter)"],
  key_play: ["play or pause", "lecture ou pause"],
  key_step: ["step", "pas"],
  key_scan: ["one scan", "une scrutation"],
  key_gate: ["one gate", "une porte"],
  key_back: ["back: take the last command back", "revenir sur la dernière commande"],
  key_witness: ["previous, next step of the witness (in Check)", "pas précédent, suivant du témoin (dans Vérifier)"],
  key_check: ["check", "vérifier"],
  key_export: ["export", "exporter"],
  key_help: ["this help", "cette aide"],
  legend_title: ["What the pictures mark", "Ce que marquent les dessins"],
  legend_active: ["active step", "étape active"],
  legend_enabled: ["enabled transition", "transition validée"],
  legend_clearable: ["clearable transition", "transition franchissable"],
  legend_one: ["net at 1", "fil à 1"],
  legend_zero: ["net at 0", "fil à 0"],
  legend_unknown: ["unknown value", "valeur inconnue"],
  legend_language: ["The language of charts", "Le langage des grafcets"],
  language_says: [
    "`.` is AND, `+` OR, `/` NOT, `↑` and `↓` edges, `5s/X3` a delay. `1 -> 2, 5 : m` is a transition. Everything has an English and a French spelling.",
    "`.` est ET, `+` OU, `/` NON, `↑` et `↓` les fronts, `5s/X3` une temporisation. `1 -> 2, 5 : m` est une transition. Tout s'écrit en anglais ou en français."],
};

const languages = ["en", "fr"];
let language = languages[0];

export function currentLanguage() {
  return language;
}

export function setLanguage(wanted) {
  language = languages.includes(wanted) ? wanted : languages[0];
  document.documentElement.lang = language;
}

// French typography: a no-break space before the double signs of punctuation, and inside guillemets.
function withNoBreakSpaces(text) {
  return text
    .replace(/ (?=[;!?])/g, "\u202f")
    .replace(/ (?=[:»])/g, "\u00a0")
    .replace(/« /g, "«\u00a0");
}

// The words of that name; {n} and the like are replaced by the values.
export function say(name, values = {}) {
  const row = catalogue[name];
  if (!row) throw new Error(`no words are called ${name}`);
  const text = row[languages.indexOf(language)];
  const set = language === "fr" ? withNoBreakSpaces(text) : text;
  return set.replace(/\{(\w+)\}/g, (_, key) => values[key] ?? "");
}

// A number of things: `steps_one`, `steps_many`. In French 0 takes the singular.
export function count(name, n) {
  const isOne = n === 1 || (language === "fr" && n === 0);
  return isOne && n === 0
    ? say(`${name}_one`).replace("1", "0")
    : say(isOne ? `${name}_one` : `${name}_many`, { n });
}

// Gives every element below `root` its words anew: text by data-word, labels by data-label, tips by
// data-tip.
export function relabel(root) {
  for (const element of root.querySelectorAll("[data-word]"))
    element.textContent = say(element.dataset.word);
  for (const element of root.querySelectorAll("[data-label]"))
    element.setAttribute("aria-label", say(element.dataset.label));
  for (const element of root.querySelectorAll("[data-tip]"))
    element.title = say(element.dataset.tip);
}
