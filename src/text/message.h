#pragma once

// What the program says to people exists in English and in French. Each folder lists its sentences
// in one file, messages.h, both languages side by side; the compiler checks that both take the same
// arguments. A sentence is made in both languages at once, for who makes it does not know who will
// read it: a reader of files does not ask for the language of the terminal.

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace grafwire {

/// The language of reports and pictures. Machine formats do not depend on it.
enum class Language { english, french };

/// A finished sentence, in both languages. No text becomes one by itself: whoever has a text in one
/// language only has to say why that is enough.
struct Localized {
    std::string english;
    std::string french;

    Localized() = default;
    Localized(std::string in_english, std::string in_french);
    /// What is the same in both: a name, a number, a formula, or words quoted from another program,
    /// which speaks one language only.
    static Localized same_in_both(std::string text);

    const std::string& in(Language language) const {
        return language == Language::french ? french : english;
    }
};

/// A name as it is quoted in a message, a long one cut short with an ellipsis: 'name', « nom ».
Localized quoted(std::string_view name);

/// The texts one after the other, with the separator between them.
Localized joined(const std::vector<Localized>& texts, std::string_view separator);

/// How an argument of a message enters its sentence: as it is, or in the language of the sentence.
template <class Argument>
struct MessageArgument {
    using Shown = Argument;
    static const Argument& in(const Argument& argument, Language) { return argument; }
};
template <>
struct MessageArgument<Localized> {
    using Shown = std::string;
    static const std::string& in(const Localized& argument, Language language) {
        return argument.in(language);
    }
};

/// One row of a catalogue: a sentence with places for arguments, in the notation of {fmt}.
///
///     inline constexpr Message<std::string> unknown_step{"there is no step {}",
///                                                        "il n'y a pas d'étape {}"};
///     diagnostics.error(code::unknown_name, where, unknown_step(name));
template <class... Arguments>
struct Message {
    template <class Argument>
    using Shown = typename MessageArgument<Argument>::Shown;

    fmt::format_string<const Shown<Arguments>&...> english;
    fmt::format_string<const Shown<Arguments>&...> french;

    std::string in(Language language, const Arguments&... arguments) const {
        return fmt::format(language == Language::french ? french : english,
                           MessageArgument<Arguments>::in(arguments, language)...);
    }
    Localized operator()(const Arguments&... arguments) const {
        return {in(Language::english, arguments...), in(Language::french, arguments...)};
    }
};

/// A sentence that counts something, which is its first argument: English says "0 steps, 1 step, 2
/// steps", French "0 étape, 1 étape, 2 étapes".
template <class... Arguments>
struct CountedMessage {
    Message<std::size_t, Arguments...> one;
    Message<std::size_t, Arguments...> many;

    std::string in(Language language, std::size_t count, const Arguments&... arguments) const {
        const bool is_one = language == Language::french ? count < 2 : count == 1;
        return (is_one ? one : many).in(language, count, arguments...);
    }
    Localized operator()(std::size_t count, const Arguments&... arguments) const {
        return {in(Language::english, count, arguments...),
                in(Language::french, count, arguments...)};
    }
};

}  // namespace grafwire
