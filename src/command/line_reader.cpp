#include "command/line_reader.h"

#include <unistd.h>

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

#ifdef GRAFWIRE_HAS_EDITLINE
#include <editline/readline.h>
#endif

namespace grafwire {

namespace {

/// A line as it comes, of any length.
std::optional<std::string> plain_line() {
    std::string line;
    for (int c = std::getc(stdin); c != '\n'; c = std::getc(stdin)) {
        if (c == EOF) return line.empty() ? std::nullopt : std::optional(line);
        line += static_cast<char>(c);
    }
    return line;
}

#ifdef GRAFWIRE_HAS_EDITLINE

/// What the tabulator completes. The library calls a function without context, so it stands here.
std::vector<std::string> words_to_complete;

/// The next word that begins with `text`, from the first on where `state` is 0; as the library asks
/// for it.
char* next_match(const char* text, int state) {
    static std::size_t at = 0;
    if (state == 0) at = 0;
    while (at < words_to_complete.size()) {
        const std::string& word = words_to_complete[at++];
        if (word.compare(0, std::strlen(text), text) == 0) return strdup(word.c_str());
    }
    return nullptr;
}

/// Never names of files: what is typed are inputs.
char** complete(const char* text, int, int) {
    rl_attempted_completion_over = 1;
    return rl_completion_matches(text, next_match);
}

void prepare_editing(std::vector<std::string> words) {
    std::setlocale(LC_CTYPE, "");  // the editor counts characters
    words_to_complete = std::move(words);
    rl_readline_name = "grafwire";
    rl_attempted_completion_function = complete;
    rl_completion_append_character = '\0';
    using_history();
}

std::optional<std::string> edited_line(const std::string& prompt) {
    char* const text = readline(prompt.c_str());
    if (text == nullptr) {
        std::putchar('\n');
        return std::nullopt;
    }
    std::string line(text);
    std::free(text);
    if (!line.empty()) add_history(line.c_str());
    return line;
}

#else

void prepare_editing(const std::vector<std::string>&) {}

std::optional<std::string> edited_line(const std::string& prompt) {
    std::fputs(prompt.c_str(), stdout);
    std::fflush(stdout);
    auto line = plain_line();
    if (!line) std::putchar('\n');
    return line;
}

#endif

}  // namespace

LineReader::LineReader(std::vector<std::string> beginnings)
    : is_terminal_(isatty(STDIN_FILENO) == 1 && isatty(STDOUT_FILENO) == 1) {
    if (is_terminal_) prepare_editing(std::move(beginnings));
}

LineReader::~LineReader() = default;

std::optional<std::string> LineReader::next(const std::string& prompt) {
    return is_terminal_ ? edited_line(prompt) : plain_line();
}

}  // namespace grafwire
