#pragma once

// English words betray a text that was not translated.

#include <cctype>
#include <set>
#include <sstream>
#include <string>

namespace grafwire::testing {

/// Words of English sentences that are none of French, nor names of commands, options and values.
inline const std::set<std::string> english_words{
    "address",   "an",         "and",         "are",      "at",        "be",      "beside",
    "between",   "both",       "but",         "by",       "cannot",    "cell",    "command",
    "connected", "default",    "delay",       "did",      "directory", "driver",  "each",
    "error",     "every",      "example",     "exit",     "expected",  "file",    "first",
    "float",     "folder",     "for",         "from",     "gate",      "give",    "given",
    "has",       "have",       "here",        "in",       "input",     "inputs",  "into",
    "is",        "it",         "its",         "keep",     "language",  "mean",    "missing",
    "more",      "must",       "name",        "names",    "needs",     "neither", "nor",
    "not",       "nothing",    "of",          "only",     "output",    "outputs", "positionals",
    "print",     "program",    "read",        "received", "required",  "row",     "second",
    "settle",    "several",    "should",      "shows",    "started",   "status",  "step",
    "steps",     "subcommand", "subcommands", "such",     "supported", "takes",   "than",
    "that",      "the",        "there",       "these",    "they",      "this",    "those",
    "time",      "uint",       "usage",       "warning",  "was",       "what",    "when",
    "where",     "which",      "whole",       "width",    "will",      "with",    "without",
    "word",      "write",      "you",         "your"};

/// The English words of a text, apart from what is the same in every language: options, their
/// values in braces, paths, and what stands in quotes or brackets.
inline std::string english_in(const std::string& text) {
    std::string found;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (word.find_first_of("-/.{[\"") == 0 || word.find('/') != std::string::npos) continue;
        if (word.find(":{") != std::string::npos) continue;
        std::string letters;
        for (const char c : word) {
            if (c != ',' && c != ';' && c != ':' && c != '(' && c != ')' && c != '.') {
                letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
            }
        }
        if (english_words.count(letters) != 0) found += word + ' ';
    }
    return found;
}

}  // namespace grafwire::testing
