// single_sequence: Séquence unique
// Written by grafwire 0.2.0 with: grafwire plc single-sequence.grafcet --to pascal --modes on --lang en
//
// A GRAFCET (IEC 60848) as a program in Free Pascal. A scan is one
// of the table method (Cordier, "Méthode d'implémentation du GRAFCET", 1998); each of
// its parts says which subroutine of the method it is, SBR 0 to SBR 8.
//
// To try it on scans from a trace of the reference:
//   fpc THIS_FILE -oprogram
//   grafwire run CHART STIMULI --scan 10ms -o trace.csv
//   ./program < trace.csv | diff - trace.csv

{$mode objfpc}{$H+}
program single_sequence_grafcet;

const
    INPUT_COLUMNS = 6;  // Init, AUdur and AUdoux included

type
    TStep = (X0, X1, X2);
    TSteps = set of TStep;

var
    now: Int64;  // the moment of the scan, in us
    // Inputs.
    inputs: record m, a, b, Init, AUdur, AUdoux: Boolean; end;
    Ts: TSteps;      // the situation
    Tp: TSteps;      // the situation that the scan began with
    Ta, Td: TSteps;  // to activate, to deactivate
    // The conditions of the transitions.
    Tt: record t_0, t_1, t_2: Boolean; end;

// SBR 0: before the first scan, the initial situation
procedure start;
begin
    // initial step 0
    Ts := Ts + [X0];
    Tp := Tp + [X0];
end;

// SBR 1: the situation the scan begins with; work tables cleared
procedure begin_scan;
begin
    Tp := Ts;
    Ta := [];
    Td := [];
end;

// SBR 3: transition conditions
procedure test_conditions;
begin
    // (0) 0 -> 1 : m
    Tt.t_0 := inputs.m;
    // (1) 1 -> 2 : a
    Tt.t_1 := inputs.a;
    // (2) 2 -> 0 : b
    Tt.t_2 := inputs.b;
end;

// SBR 4: evolution, rules 2 to 5
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
    // Init: initial steps
    if inputs.Init then
        Ts := Ts + [X0];
    // Init: all other steps
    if inputs.Init then
        Ts := Ts - [X1..X2];
end;

// SBR 5: orders and enclosures
procedure obey_orders;
begin
    // AUdur: every step
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

// From here on: scans read from standard input, a line each, with the moment in ms and the inputs as
// 0 or 1 (the first line, and further columns, are passed over); the trace goes to standard output in
// the columns of the reference. In a machine, read its inputs and its clock instead.

var
    line: string;
    at: SizeInt;  // in the line
    row: Int64;
    step: TStep;
    i: Integer;
    values: array[1..INPUT_COLUMNS] of Boolean;

procedure fail;
begin
    WriteLn(StdErr, 'line ', row, ': expected a moment in ms, whole in us, and ', INPUT_COLUMNS,
        ' inputs');
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

// From ms, as `0.5`, to us.
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
