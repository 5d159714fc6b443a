#include "text/version.h"

namespace grafwire {

std::string_view version() {
    return GRAFWIRE_VERSION;
}

}  // namespace grafwire
