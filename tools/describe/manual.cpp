// Manual pages: one of the program, which lists the commands, and one of each command, with its
// arguments, options, exit statuses and example. They are written in the macros of man(7), which
// both groff and mandoc read; every text goes through roff_text(), so that no character of a help
// is taken for a request or set as another (`-` as a hyphen, `'` as a quotation mark).

#include "describe/manual.h"

#include <fmt/format.h>

#include "command/help.h"
#include "describe/messages.h"
#include "text/joined.h"
#include "text/version.h"

namespace grafwire {

namespace {

namespace say = messages::describe;
namespace help = messages::help;

/// How roff writes a character that it would take for something else.
std::string_view roff_character(char c) {
    switch (c) {
        case '\\':
            return "\\e";
        case '-':
            return "\\-";
        case '\'':
            return "\\(aq";
        case '`':
            return "\\(ga";
        case '^':
            return "\\(ha";
        case '~':
            return "\\(ti";
        default:
            return {};
    }
}

/// A line of text. What begins with a dot would be a request.
std::string roff_text(std::string_view text) {
    std::string out = text.starts_with('.') ? "\\&" : "";
    for (const char c : text) {
        const std::string_view written = roff_character(c);
        if (written.empty()) {
            out += c;
        } else {
            out += written;
        }
    }
    return out;
}

std::string bold(std::string_view text) {
    return "\\fB" + roff_text(text) + "\\fR";
}

std::string italic(std::string_view text) {
    return "\\fI" + roff_text(text) + "\\fR";
}

/// `FILE`, `[FILE]`, `FILE ...`; `--to TEXT`.
std::string in_synopsis(const OptionDescription& option) {
    std::string text = italic(option.value);
    if (!option.names.empty()) text = bold(option.names.back()) + " " + text;
    if (option.may_be_repeated) text += " ...";
    return option.is_required ? text : "[" + text + "]";
}

/// `grafwire-s7-run`.
std::string page_name(const std::vector<std::string>& words) {
    return joined(words, "-");
}

/// The pages of a program in one language.
class Manual {
  public:
    Manual(std::string_view date, Language language) : date_(date), language_(language) {}

    void add(const CommandDescription& command, std::vector<std::string> words);
    std::vector<ManualPage> take() { return std::move(pages_); }

  private:
    void heading(const Message<>& words) {
        text_ += fmt::format(".SH {}\n", roff_text(words.in(language_)));
    }
    /// A paragraph with a tag, which is marked up already.
    void item(const std::string& tag) { text_ += ".TP\n" + tag + '\n'; }
    void line(std::string_view text) { text_ += roff_text(text) + '\n'; }

    void head(const CommandDescription& command, const std::string& name);
    void synopsis(const CommandDescription& command, const std::vector<std::string>& words);
    void list_commands(const CommandDescription& command, const std::string& name);
    void describe(const OptionDescription& option);
    void exit_statuses();
    void see_also(const std::vector<std::string>& words);

    std::string_view date_;
    Language language_;
    std::string text_;  ///< of the page that is being written
    std::vector<ManualPage> pages_;
};

void Manual::head(const CommandDescription& command, const std::string& name) {
    std::string capitals;
    for (const char c : name)
        capitals += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    text_ = ".\\\" -*- coding: utf-8 -*-\n";
    text_ += fmt::format(".TH {} 1 {} \"{}\" \"{}\"\n", roff_text(capitals), date_,
                         roff_text(program_and_version()), say::manual.in(language_));
    heading(say::name);
    std::string_view summary = command.summary;
    if (summary.ends_with('.')) summary.remove_suffix(1);  // whatis(1) has lines, not sentences
    text_ += fmt::format("{} \\- {}\n", roff_text(name), roff_text(summary));
}

void Manual::synopsis(const CommandDescription& command, const std::vector<std::string>& words) {
    heading(say::synopsis);
    text_ += bold(joined(words, " "));
    if (!command.commands.empty()) text_ += ' ' + italic(say::command.in(language_));
    for (const OptionDescription& argument : command.arguments)
        text_ += ' ' + in_synopsis(argument);
    for (const OptionDescription& option : command.options) {
        if (option.is_required) text_ += ' ' + in_synopsis(option);
    }
    text_ += " [" + italic(say::option.in(language_)) + " ...]\n";
}

void Manual::list_commands(const CommandDescription& command, const std::string& name) {
    if (command.commands.empty()) return;
    heading(say::commands);
    for (const CommandDescription& below : command.commands) {
        item(fmt::format(".BR {}\\-{} (1)", roff_text(name), roff_text(below.name)));
        line(below.summary);
    }
}

/// Help has the values of an option in lines below its sentence, or they are listed here.
void Manual::describe(const OptionDescription& option) {
    std::string tag;
    for (const std::string& name : option.names) tag += (tag.empty() ? "" : ", ") + bold(name);
    if (!option.value.empty()) tag += (tag.empty() ? "" : " ") + italic(option.value);
    item(tag);
    std::string_view rest = option.help;
    const bool has_rows = rest.find('\n') != std::string_view::npos;
    for (;;) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        line(rest.substr(0, end));
        if (end == rest.size()) break;
        text_ += ".br\n";
        rest.remove_prefix(end + 1);
    }
    std::vector<std::string> remarks;
    if (!has_rows && !option.values.empty()) {
        remarks.push_back(say::one_of.in(language_, joined(option.values, ", ")));
    }
    if (!option.default_value.empty()) {
        remarks.push_back(say::by_default.in(language_, option.default_value));
    }
    if (option.is_required && !option.names.empty()) {
        remarks.push_back(say::required.in(language_));
    }
    if (option.may_be_repeated) remarks.push_back(say::repeatable.in(language_));
    if (remarks.empty()) return;
    text_ += ".br\n";
    line(joined(remarks, " "));
}

void Manual::exit_statuses() {
    heading(say::exit_status);
    int status = 0;
    for (const Message<>& meaning : help::statuses) {
        item(bold(std::to_string(status++)));
        line(meaning.in(language_));
    }
}

void Manual::see_also(const std::vector<std::string>& words) {
    if (words.size() < 2) return;
    heading(say::see_also);
    const std::vector<std::string> above(words.begin(), words.end() - 1);
    text_ += fmt::format(".BR {} (1)\n", roff_text(page_name(above)));
}

void Manual::add(const CommandDescription& command, std::vector<std::string> words) {
    words.push_back(command.name);
    const std::string name = page_name(words);
    head(command, name);
    synopsis(command, words);
    list_commands(command, name);
    if (!command.arguments.empty()) heading(say::arguments);
    for (const OptionDescription& argument : command.arguments) describe(argument);
    if (!command.options.empty()) heading(say::options);
    for (const OptionDescription& option : command.options) describe(option);
    exit_statuses();
    if (!command.example.empty()) {
        heading(say::example);
        text_ += ".nf\n" + roff_text(command.example) + "\n.fi\n";
    }
    see_also(words);
    pages_.push_back({name + ".1", std::move(text_)});
    for (const CommandDescription& below : command.commands) add(below, words);
}

}  // namespace

std::vector<ManualPage> manual_pages(const CommandDescription& program, std::string_view date,
                                     Language language) {
    Manual manual(date, language);
    manual.add(program, {});
    return manual.take();
}

}  // namespace grafwire
