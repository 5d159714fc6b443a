#include "text/message.h"

namespace grafwire {

// Not in the header: g++ 12 sees writes beyond strings that are not there where these are inlined
// (GCC bug 105651).

Localized::Localized(std::string in_english, std::string in_french)
    : english(std::move(in_english)), french(std::move(in_french)) {}

Localized::Localized(std::string in_both) : english(in_both), french(std::move(in_both)) {}

Localized::Localized(const char* in_both) : english(in_both), french(in_both) {}

}  // namespace grafwire
