#include "check/keys.h"

namespace grafwire {

void append_key(std::string& key, const BitTable& bits) {
    const auto& words = bits.words();
    key.append(reinterpret_cast<const char*>(words.data()), words.size() * sizeof(words[0]));
}

}  // namespace grafwire
