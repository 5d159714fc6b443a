// Sentences are made in both languages at once (see message.h); here is what is not a template.

#include "text/message.h"

#include "text/messages.h"
#include "text/utf8.h"

namespace grafwire {

// Not in the header: g++ 12 sees writes beyond strings that are not there where these are inlined
// (GCC bug 105651).

Localized::Localized(std::string in_english, std::string in_french)
    : english(std::move(in_english)), french(std::move(in_french)) {}

Localized Localized::same_in_both(std::string text) {
    std::string french = text;
    return {std::move(text), std::move(french)};
}

Localized quoted(std::string_view name) {
    return messages::text::quoted_name(shortened(name));
}

Localized joined(const std::vector<Localized>& texts, std::string_view separator) {
    Localized result;
    for (const Localized& text : texts) {
        for (const auto part : {&Localized::english, &Localized::french}) {
            if (&text != &texts.front()) result.*part += separator;
            result.*part += text.*part;
        }
    }
    return result;
}

}  // namespace grafwire
