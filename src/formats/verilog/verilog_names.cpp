// Escaped identifiers hold nearly every name as it is (IEEE 1364-2005, 3.7.1: any printable ASCII
// character but white space, and in practice UTF-8). What they cannot hold, or what tools take for
// something else within them, is written with percent signs.

#include "formats/verilog/verilog_names.h"

#include <algorithm>
#include <iterator>

#include "formats/shared/append.h"
#include "formats/shared/net_spelling.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

// In the order of bytes, for binary search.
// clang-format off
constexpr std::string_view keywords[] = {
    "accept_on", "alias", "always", "always_comb", "always_ff", "always_latch", "and", "assert",
    "assign", "assume", "automatic", "before", "begin", "bind", "bins", "binsof", "bit", "break",
    "buf", "bufif0", "bufif1", "byte", "case", "casex", "casez", "cell", "chandle", "checker",
    "class", "clocking", "cmos", "config", "const", "constraint", "context", "continue", "cover",
    "covergroup", "coverpoint", "cross", "deassign", "default", "defparam", "design", "disable",
    "dist", "do", "edge", "else", "end", "endcase", "endchecker", "endclass", "endclocking",
    "endconfig", "endfunction", "endgenerate", "endgroup", "endinterface", "endmodule",
    "endpackage", "endprimitive", "endprogram", "endproperty", "endsequence", "endspecify",
    "endtable", "endtask", "enum", "event", "eventually", "expect", "export", "extends", "extern",
    "final", "first_match", "for", "force", "foreach", "forever", "fork", "forkjoin", "function",
    "generate", "genvar", "global", "highz0", "highz1", "if", "iff", "ifnone", "ignore_bins",
    "illegal_bins", "implements", "implies", "import", "incdir", "include", "initial", "inout",
    "input", "inside", "instance", "int", "integer", "interconnect", "interface", "intersect",
    "join", "join_any", "join_none", "large", "let", "liblist", "library", "local", "localparam",
    "logic", "longint", "macromodule", "matches", "medium", "modport", "module", "nand", "negedge",
    "nettype", "new", "nexttime", "nmos", "nor", "noshowcancelled", "not", "notif0", "notif1",
    "null", "or", "output", "package", "packed", "parameter", "pmos", "posedge", "primitive",
    "priority", "program", "property", "protected", "pull0", "pull1", "pulldown", "pullup",
    "pulsestyle_ondetect", "pulsestyle_onevent", "pure", "rand", "randc", "randcase",
    "randsequence", "rcmos", "real", "realtime", "ref", "reg", "reject_on", "release", "repeat",
    "restrict", "return", "rnmos", "rpmos", "rtran", "rtranif0", "rtranif1", "s_always",
    "s_eventually", "s_nexttime", "s_until", "s_until_with", "scalared", "sequence", "shortint",
    "shortreal", "showcancelled", "signed", "small", "soft", "solve", "specify", "specparam",
    "static", "string", "strong", "strong0", "strong1", "struct", "super", "supply0", "supply1",
    "sync_accept_on", "sync_reject_on", "table", "tagged", "task", "this", "throughout", "time",
    "timeprecision", "timeunit", "tran", "tranif0", "tranif1", "tri", "tri0", "tri1", "triand",
    "trior", "trireg", "type", "typedef", "union", "unique", "unique0", "unsigned", "until",
    "until_with", "untyped", "use", "uwire", "var", "vectored", "virtual", "void", "wait",
    "wait_order", "wand", "weak", "weak0", "weak1", "while", "wildcard", "wire", "with", "within",
    "wor", "xnor", "xor"
};
// clang-format on

/// A simple identifier (IEEE 1364-2005, 3.7).
bool is_simple(std::string_view name) {
    if (name.empty() || (!is_ascii_letter(name.front()) && name.front() != '_')) return false;
    for (const char c : name) {
        if (!is_ascii_letter(c) && !is_digit(c) && c != '_' && c != '$') return false;
    }
    return true;
}

/// What no escaped identifier can hold, and the two characters that preprocessors stop at.
bool is_unsafe(char c) {
    return is_control_or_blank(c) || c == '`' || c == '"';
}

bool is_asterisk(char c) {
    return c == '*';
}

}  // namespace

bool is_verilog_keyword(std::string_view word) {
    return std::binary_search(std::begin(keywords), std::end(keywords), word);
}

void spell_verilog(std::string& out, std::string_view name) {
    if (is_simple(name) && !is_verilog_keyword(name)) {
        out.append(name);
        return;
    }
    out.push_back('\\');
    // The preprocessor of Icarus does not know escaped identifiers: it takes quotation marks, `/*`
    // and `(*` in them for the beginning of a text or a comment, and all up to the end of that,
    // over many lines, for a part of it. A port named `*…` it takes for `.*`.
    for (std::size_t at = 0; at < name.size(); ++at) {
        const bool begins_comment =
            name[at] == '*' && (at == 0 || name[at - 1] == '/' || name[at - 1] == '(');
        append_percent_escaped(out, name.substr(at, 1), begins_comment ? is_asterisk : is_unsafe);
    }
    out.push_back(' ');
}

void append_verilog_with_suffix(std::string& out, std::string_view spelled,
                                std::string_view suffix) {
    if (spelled.back() == ' ') {
        append(out, spelled.substr(0, spelled.size() - 1), suffix, ' ');
    } else {
        append(out, spelled, suffix);
    }
}

void append_verilog_text(std::string& out, std::string_view text) {
    for (const char c : text) {
        if (c == '"' || c == '\\') out.push_back('\\');
        if (c == '%') out.push_back('%');
        out.push_back(is_control_or_blank(c) ? ' ' : c);
    }
}

void append_verilog_comment(std::string& out, std::string_view text) {
    constexpr std::string_view obeyed[] = {"ambit",     "cadence", "coverage",
                                           "exemplar",  "pragma",  "synopsys",
                                           "synthesis", "vcs",     "verilator"};
    const std::string_view word = text.substr(std::min(text.find_first_not_of(" *"), text.size()));
    out.append("// ");
    for (const std::string_view tool : obeyed) {
        if (word.starts_with(tool)) out.append("- ");
    }
    append_comment(out, text);
    out.push_back('\n');
}

namespace {

/// A name for a parameter, with `$` added where a net or a port is called that.
std::string free_parameter(const Netlist& netlist, std::string parameter) {
    const auto has_that_name = [&](const Port& port) { return port.name == parameter; };
    const auto is_taken = [&] {
        for (std::size_t i = 0; i < netlist.net_count(); ++i) {
            if (netlist.names[static_cast<NetId>(i)] == parameter) return true;
        }
        return std::any_of(netlist.outputs.begin(), netlist.outputs.end(), has_that_name);
    };
    while (is_taken()) parameter += '$';
    return parameter;
}

}  // namespace

std::string verilog_scan_parameter(const Netlist& netlist) {
    return free_parameter(netlist, "SCAN_PS");
}

std::string verilog_gate_parameter(const Netlist& netlist) {
    return free_parameter(netlist, "GATE_NS");
}

}  // namespace grafwire
