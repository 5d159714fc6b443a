// lift : Monte-charge
// Écrit par grafwire 0.2.0 avec : grafwire plc lift.grafcet --to pascal --modes on --lang fr
//
// GRAFCET (CEI 60848), programme en Free Pascal. Une scrutation est
// celle de la méthode des tables (Cordier, « Méthode d'implémentation du GRAFCET », 1998) ;
// chaque partie dit de quel sous-programme de la méthode il s'agit, SBR 0 à SBR 8.
//
// Pour l'essayer sur les scrutations d'une trace de la référence :
//   fpc CE_FICHIER -oprogramme
//   grafwire run GRAFCET STIMULI --scan 10ms -o trace.csv
//   ./programme < trace.csv | diff - trace.csv
//
// Noms écrits autrement dans le GRAFCET :
//   arret  arrêt

{$mode objfpc}{$H+}
program lift_grafcet;

const
    INPUT_COLUMNS = 7;  // avec Init, AUdur et AUdoux

type
    TStep = (X0, X1, X2, X10, X11, X12);
    TSteps = set of TStep;

    // Temporisation t1/e/t2 : True quand e est True depuis t1, False quand e est False depuis t2.
    TTimeCondition = record
        value: Boolean;
        waits: Boolean;  // e diffère de la valeur
        since: Int64;    // pendant l'attente : l'instant depuis lequel e diffère, en us
    end;

var
    now: Int64;  // instant de la scrutation, en us
    // Entrées.
    inputs: record crate, top, arret, int, Init, AUdur, AUdoux: Boolean; end;
    // Sorties.
    outputs: record UP, blow, lamp: Boolean; end;
    Ts: TSteps;      // situation
    Tp: TSteps;      // situation en début de scrutation
    Ta, Td: TSteps;  // à activer, à désactiver
    Tf1, Tf0: TSteps;  // forcées à 1, forcées à 0
    Tpulse: TSteps;  // activées dans cette scrutation
    // Réceptivités des transitions.
    Tt: record t0, t1, t2, t_go, t4, t5: Boolean; end;
    // Fronts, True dans la scrutation où ils se produisent.
    edge: record rise_top, rise_crate: Boolean; end;
    // Valeurs des opérandes des fronts à la scrutation précédente.
    memory: record rise_top, rise_crate: Boolean; end;
    // Temporisations.
    time: record t1_5s_top_20ms: TTimeCondition; end;
    // Variables internes.
    vars: record full: Boolean; end;
    // Compteurs.
    counters: record n: Int64; end;

function within(low, value, high: Int64): Int64;
begin
    if value < low then Result := low
    else if value > high then Result := high
    else Result := value;
end;

procedure observe(var c: TTimeCondition; e: Boolean; on_delay, off_delay: Int64);
var
    delay: Int64;
begin
    if e = c.value then
    begin
        c.waits := False;
        Exit;
    end;
    if not c.waits then
    begin
        c.waits := True;
        c.since := now;
    end;
    if e then delay := on_delay else delay := off_delay;
    if now - c.since < delay then Exit;
    c.value := e;
    c.waits := False;
end;

// SBR 0 : avant la première scrutation, situation initiale
procedure start;
begin
    // étape initiale 0
    Ts := Ts + [X0];
    Tp := Tp + [X0];
    // étape initiale 10
    Ts := Ts + [X10];
    Tp := Tp + [X10];
    // n
    counters.n := within(0, 0, 3);
    // mémoire de ↑top
    memory.rise_top := inputs.top;
    // mémoire de ↑crate
    memory.rise_crate := inputs.crate;
end;

// SBR 1 : situation en début de scrutation ; tables de travail à 0
procedure begin_scan;
begin
    Tp := Ts;
    Ta := [];
    Td := [];
    Tf1 := [];
    Tf0 := [];
end;

// SBR 2 : fronts
procedure find_edges;
begin
    // ↑top
    edge.rise_top := inputs.top and not memory.rise_top;
    // mémoire de ↑top
    memory.rise_top := inputs.top;
    // ↑crate
    edge.rise_crate := inputs.crate and not memory.rise_crate;
    // mémoire de ↑crate
    memory.rise_crate := inputs.crate;
end;

// SBR 3 : réceptivités
procedure test_conditions;
begin
    // (0) 0 -> 1 : arrêt
    Tt.t0 := inputs.arret;
    // (1) 1 -> 2 : /arrêt ⊕ int
    Tt.t1 := (not inputs.arret) xor inputs.int;
    // (2) 2 -> 0 : 1
    Tt.t2 := True;
    // (go) 10 -> 11 : ↑crate.[n < 3]
    Tt.t_go := edge.rise_crate and (counters.n < 3);
    // (4) 11 -> 12 : 1.5s/top/20ms
    Tt.t4 := time.t1_5s_top_20ms.value;
    // (5) 12 -> 10 : 1
    Tt.t5 := True;
end;

// SBR 4 : évolution, règles 2 à 5
procedure evolve;
begin
    // (0) 0 -> 1
    if (X0 in Ts) and Tt.t0 then
    begin
        Ta := Ta + [X1];
        Td := Td + [X0];
    end;
    // (1) 1 -> 2
    if (X1 in Ts) and Tt.t1 then
    begin
        Ta := Ta + [X2];
        Td := Td + [X1];
    end;
    // (2) 2 -> 0
    if (X2 in Ts) and Tt.t2 then
    begin
        Ta := Ta + [X0];
        Td := Td + [X2];
    end;
    // (go) 10 -> 11
    if (X10 in Ts) and Tt.t_go then
    begin
        Ta := Ta + [X11];
        Td := Td + [X10];
    end;
    // (4) 11 -> 12
    if (X11 in Ts) and Tt.t4 then
    begin
        Ta := Ta + [X12];
        Td := Td + [X11];
    end;
    // (5) 12 -> 10
    if (X12 in Ts) and Tt.t5 then
    begin
        Ta := Ta + [X10];
        Td := Td + [X12];
    end;
    // Ts = Tp . /Td + Ta
    Ts := (Tp - Td) + Ta;
    // Init : étapes initiales
    if inputs.Init then
        Ts := Ts + [X0, X10];
    // Init : toutes les autres étapes
    if inputs.Init then
        Ts := Ts - [X1..X2, X11..X12];
end;

// SBR 5 : forçages et encapsulations
procedure obey_orders;
begin
    // ordres de forçage de l'étape 1
    if (X1 in Ts) then
        Tf0 := Tf0 + [X10..X12];
    // ordres de forçage de l'étape 2
    if (X2 in Ts) then
    begin
        Tf1 := Tf1 + [X10];
        Tf0 := Tf0 + [X10..X12];
    end;
    // Ts = Ts . /Tf0 + Tf1
    Ts := (Ts - Tf0) + Tf1;
    // AUdur : toutes les étapes
    if inputs.AUdur then
        Ts := Ts - [X0..X12];
    // Tpulse = Ts . /Tp
    Tpulse := Ts - Tp;
end;

// SBR 5, fin : actions mémorisées
procedure run_stored_actions;
begin
    // full au franchissement de (5) 12 -> 10
    if (X12 in Tp) and Tt.t5 and not inputs.Init then
        vars.full := False;
    // n à l'activation de l'étape 11
    if (X11 in Tpulse) then
        counters.n := within(0, counters.n + 1, 3);
    // full sur événement à l'étape 12
    if (X12 in Ts) and edge.rise_top then
        vars.full := True;
end;

// SBR 6 : temporisations
procedure observe_times;
begin
    // 1.5s/top/20ms
    observe(time.t1_5s_top_20ms, inputs.top, 1500000, 20000);
end;

// SBR 8 : sorties
procedure drive_outputs;
begin
    // UP
    outputs.UP := (X11 in Ts) and not inputs.top and not inputs.AUdoux;
    // blow
    outputs.blow := (X12 in Ts) and not inputs.AUdoux;
    // lamp
    outputs.lamp := (X1 in Ts) and not inputs.AUdoux;
end;

procedure scan;
begin
    begin_scan;
    find_edges;
    test_conditions;
    evolve;
    obey_orders;
    run_stored_actions;
    observe_times;
    drive_outputs;
end;

// À partir d'ici : lecture des scrutations sur l'entrée standard, une par ligne, avec l'instant en
// ms et les entrées à 0 ou 1 (la première ligne et les colonnes en plus sont ignorées) ; la trace
// sort sur la sortie standard, dans les colonnes de la référence. Sur une machine, lire plutôt
// ses entrées et son horloge.

var
    line: string;
    at: SizeInt;  // dans la ligne
    row: Int64;
    step: TStep;
    i: Integer;
    values: array[1..INPUT_COLUMNS] of Boolean;

procedure fail;
begin
    WriteLn(StdErr, 'ligne ', row, ' : instant en ms attendu (entier en us), puis ', INPUT_COLUMNS,
        ' entrées');
    Halt(1);
end;

function next_field: string;
begin
    Result := '';
    while (at <= Length(line)) and (line[at] <> ',') do
    begin
        Result := Result + line[at];
        Inc(at);
    end;
    Inc(at);
end;

// De ms, comme `0.5`, en us.
function moment_of(const text: string): Int64;
var
    c: Char;
    decimals: Integer;
begin
    Result := 0;
    decimals := -1;
    if (text = '') or (Length(text) > 15) then fail;
    for c in text do
        if (c = '.') and (decimals < 0) then decimals := 0
        else
        begin
            if not (c in ['0'..'9']) or (decimals = 3) then fail;
            Result := 10 * Result + Ord(c) - Ord('0');
            if decimals >= 0 then Inc(decimals);
        end;
    if decimals < 0 then decimals := 0;
    for decimals := decimals to 2 do Result := 10 * Result;
end;

procedure read_scan;
var
    field: string;
    i: Integer;
begin
    at := 1;
    now := moment_of(next_field);
    for i := 1 to INPUT_COLUMNS do
    begin
        field := next_field;
        if (field <> '0') and (field <> '1') then fail;
        values[i] := field = '1';
    end;
end;

procedure write_moment;
var
    fraction, digits: Int64;
begin
    Write(now div 1000);
    fraction := now mod 1000;
    if fraction = 0 then Exit;
    Write('.');
    digits := 100;
    while fraction <> 0 do
    begin
        Write(fraction div digits);
        fraction := fraction mod digits;
        digits := digits div 10;
    end;
end;

procedure write_row;
begin
    write_moment;
    for i := 1 to INPUT_COLUMNS do Write(',', Ord(values[i]));
    for step := Low(TStep) to High(TStep) do Write(',', Ord(step in Ts));
    Write(',', Ord(outputs.UP));
    Write(',', Ord(outputs.blow));
    Write(',', Ord(outputs.lamp));
    Write(',', Ord(vars.full));
    Write(',', counters.n);
    WriteLn;
end;

begin
    Write('time_ms,crate,top,arrêt,int,Init,AUdur,AUdoux,X0,X1,X2,X10,X11,X12,');
    Write('UP,blow,lamp,full,n');
    WriteLn;
    ReadLn(line);
    row := 1;
    while not Eof do
    begin
        Inc(row);
        ReadLn(line);
        read_scan;
        inputs.crate := values[1];
        inputs.top := values[2];
        inputs.arret := values[3];
        inputs.int := values[4];
        inputs.Init := values[5];
        inputs.AUdur := values[6];
        inputs.AUdoux := values[7];
        if row = 2 then start;
        scan;
        write_row;
    end;
end.
