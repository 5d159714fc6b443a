// single_sequence : Séquence unique
// Écrit par grafwire 0.2.0 avec : grafwire plc single-sequence.grafcet --to pascal --modes on --lang fr
//
// GRAFCET (CEI 60848), programme en Free Pascal. Une scrutation est
// celle de la méthode des tables (Cordier, « Méthode d'implémentation du GRAFCET », 1998) ;
// chaque partie dit de quel sous-programme de la méthode il s'agit, SBR 0 à SBR 8.
//
// Pour l'essayer sur les scrutations d'une trace de la référence :
//   fpc CE_FICHIER -oprogramme
//   grafwire run GRAFCET STIMULI --scan 10ms -o trace.csv
//   ./programme < trace.csv | diff - trace.csv

{$mode objfpc}{$H+}
program single_sequence_grafcet;

const
    INPUT_COLUMNS = 6;  // avec Init, AUdur et AUdoux

type
    TStep = (X0, X1, X2);
    TSteps = set of TStep;

var
    now: Int64;  // instant de la scrutation, en us
    // Entrées.
    inputs: record m, a, b, Init, AUdur, AUdoux: Boolean; end;
    Ts: TSteps;      // situation
    Tp: TSteps;      // situation en début de scrutation
    Ta, Td: TSteps;  // à activer, à désactiver
    // Réceptivités des transitions.
    Tt: record t_0, t_1, t_2: Boolean; end;

// SBR 0 : avant la première scrutation, situation initiale
procedure start;
begin
    // étape initiale 0
    Ts := Ts + [X0];
    Tp := Tp + [X0];
end;

// SBR 1 : situation en début de scrutation ; tables de travail à 0
procedure begin_scan;
begin
    Tp := Ts;
    Ta := [];
    Td := [];
end;

// SBR 3 : réceptivités
procedure test_conditions;
begin
    // (0) 0 -> 1 : m
    Tt.t_0 := inputs.m;
    // (1) 1 -> 2 : a
    Tt.t_1 := inputs.a;
    // (2) 2 -> 0 : b
    Tt.t_2 := inputs.b;
end;

// SBR 4 : évolution, règles 2 à 5
procedure evolve;
begin
    // (0) 0 -> 1
    if (X0 in Ts) and Tt.t_0 then
    begin
        Ta := Ta + [X1];
        Td := Td + [X0];
    end;
    // (1) 1 -> 2
    if (X1 in Ts) and Tt.t_1 then
    begin
        Ta := Ta + [X2];
        Td := Td + [X1];
    end;
    // (2) 2 -> 0
    if (X2 in Ts) and Tt.t_2 then
    begin
        Ta := Ta + [X0];
        Td := Td + [X2];
    end;
    // Ts = Tp . /Td + Ta
    Ts := (Tp - Td) + Ta;
    // Init : étapes initiales
    if inputs.Init then
        Ts := Ts + [X0];
    // Init : toutes les autres étapes
    if inputs.Init then
        Ts := Ts - [X1..X2];
end;

// SBR 5 : forçages et encapsulations
procedure obey_orders;
begin
    // AUdur : toutes les étapes
    if inputs.AUdur then
        Ts := Ts - [X0..X2];
end;

procedure scan;
begin
    begin_scan;
    test_conditions;
    evolve;
    obey_orders;
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
    WriteLn;
end;

begin
    Write('time_ms,m,a,b,Init,AUdur,AUdoux,X0,X1,X2');
    WriteLn;
    ReadLn(line);
    row := 1;
    while not Eof do
    begin
        Inc(row);
        ReadLn(line);
        read_scan;
        inputs.m := values[1];
        inputs.a := values[2];
        inputs.b := values[3];
        inputs.Init := values[4];
        inputs.AUdur := values[5];
        inputs.AUdoux := values[6];
        if row = 2 then start;
        scan;
        write_row;
    end;
end.
