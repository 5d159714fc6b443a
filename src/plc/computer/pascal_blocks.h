#pragma once

#include <string_view>

namespace grafwire::pascal {

// The parts of a program in Pascal that are the same for every chart. An @ stands for a text in the
// language of the reader (with_texts).

inline constexpr std::string_view time_type = R"(
    // @time_condition
    TTimeCondition = record
        value: Boolean;
        waits: Boolean;  // @e_differs
        since: Int64;    // @differs_since
    end;
)";

inline constexpr std::string_view within_function = R"(
function within(low, value, high: Int64): Int64;
begin
    if value < low then Result := low
    else if value > high then Result := high
    else Result := value;
end;
)";

inline constexpr std::string_view observe_procedure = R"(
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
)";

inline constexpr std::string_view reading_and_writing = R"(
// @reads_scans

var
    line: string;
    at: SizeInt;  // @in_the_line
    row: Int64;
    step: TStep;
    i: Integer;
    values: array[1..INPUT_COLUMNS] of Boolean;

procedure fail;
begin
    WriteLn(StdErr, '@bad_line');
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

// @from_ms
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
)";

}  // namespace grafwire::pascal
