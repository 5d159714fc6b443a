// lift: Monte-charge
// Written by grafwire 0.2.0 with: grafwire plc lift.grafcet --to pascal --modes on --lang en
//
// A GRAFCET (IEC 60848) as a program in Free Pascal. A scan is one
// of the table method (Cordier, "Méthode d'implémentation du GRAFCET", 1998); each of
// its parts says which subroutine of the method it is, SBR 0 to SBR 8.
//
// To try it on scans from a trace of the reference:
//   fpc THIS_FILE -oprogram
//   grafwire run CHART STIMULI --scan 10ms -o trace.csv
//   ./program < trace.csv | diff - trace.csv
//
// Names that are spelt differently in the GRAFCET:
//   arret  arrêt

{$mode objfpc}{$H+}
program lift_grafcet;

const
    INPUT_COLUMNS = 7;  // Init, AUdur and AUdoux included

type
    TStep = (X0, X1, X2, X10, X11, X12);
    TSteps = set of TStep;

    // A time condition t1/e/t2: True once e has been True for t1, False once it has been False for t2.
    TTimeCondition = record
        value: Boolean;
        waits: Boolean;  // e differs from the value
        since: Int64;    // while it waits: the moment since which e differs, in us
    end;

var
    now: Int64;  // the moment of the scan, in us
    // Inputs.
    inputs: record crate, top, arret, int, Init, AUdur, AUdoux: Boolean; end;
    // Outputs.
    outputs: record UP, blow, lamp: Boolean; end;
    Ts: TSteps;      // the situation
    Tp: TSteps;      // the situation that the scan began with
    Ta, Td: TSteps;  // to activate, to deactivate
    Tf1, Tf0: TSteps;  // forced to 1, forced to 0
    Tpulse: TSteps;  // activated in this scan
    // The conditions of the transitions.
    Tt: record t0, t1, t2, t_go, t4, t5: Boolean; end;
    // Edges, True in the scan in which they occur.
    edge: record rise_top, rise_crate: Boolean; end;
    // What the operands of edges were in the scan before.
    memory: record rise_top, rise_crate: Boolean; end;
    // Time conditions.
    time: record t1_5s_top_20ms: TTimeCondition; end;
    // Internal variables.
    vars: record full: Boolean; end;
    // Counters.
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

// SBR 0: before the first scan, the initial situation
procedure start;
begin
    // initial step 0
    Ts := Ts + [X0];
    Tp := Tp + [X0];
    // initial step 10
    Ts := Ts + [X10];
    Tp := Tp + [X10];
    // n
    counters.n := within(0, 0, 3);
    // memory of ↑top
    memory.rise_top := inputs.top;
    // memory of ↑crate
    memory.rise_crate := inputs.crate;
end;

// SBR 1: the situation the scan begins with; work tables cleared
procedure begin_scan;
begin
    Tp := Ts;
    Ta := [];
    Td := [];
    Tf1 := [];
    Tf0 := [];
end;

// SBR 2: edges
procedure find_edges;
begin
    // ↑top
    edge.rise_top := inputs.top and not memory.rise_top;
    // memory of ↑top
    memory.rise_top := inputs.top;
    // ↑crate
    edge.rise_crate := inputs.crate and not memory.rise_crate;
    // memory of ↑crate
    memory.rise_crate := inputs.crate;
end;

// SBR 3: transition conditions
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

// SBR 4: evolution, rules 2 to 5
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
    // Init: initial steps
    if inputs.Init then
        Ts := Ts + [X0, X10];
    // Init: all other steps
    if inputs.Init then
        Ts := Ts - [X1..X2, X11..X12];
end;

// SBR 5: orders and enclosures
procedure obey_orders;
begin
    // forcing orders of step 1
    if (X1 in Ts) then
        Tf0 := Tf0 + [X10..X12];
    // forcing orders of step 2
    if (X2 in Ts) then
    begin
        Tf1 := Tf1 + [X10];
        Tf0 := Tf0 + [X10..X12];
    end;
    // Ts = Ts . /Tf0 + Tf1
    Ts := (Ts - Tf0) + Tf1;
    // AUdur: every step
    if inputs.AUdur then
        Ts := Ts - [X0..X12];
    // Tpulse = Ts . /Tp
    Tpulse := Ts - Tp;
end;

// SBR 5, end: stored actions
procedure run_stored_actions;
begin
    // full on clearing of (5) 12 -> 10
    if (X12 in Tp) and Tt.t5 and not inputs.Init then
        vars.full := False;
    // n on activation of step 11
    if (X11 in Tpulse) then
        counters.n := within(0, counters.n + 1, 3);
    // full on an event in step 12
    if (X12 in Ts) and edge.rise_top then
        vars.full := True;
end;

// SBR 6: time conditions
procedure observe_times;
begin
    // 1.5s/top/20ms
    observe(time.t1_5s_top_20ms, inputs.top, 1500000, 20000);
end;

// SBR 8: outputs
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
