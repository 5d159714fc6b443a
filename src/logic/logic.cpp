#include "logic/logic.h"

namespace grafwire {

char digit_of(Logic value) {
    if (value == Logic::unknown) return 'x';
    return value == Logic::one ? '1' : '0';
}

}  // namespace grafwire
