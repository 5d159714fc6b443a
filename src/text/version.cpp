#include "text/version.h"

namespace grafwire {

std::string_view version() {
    return GRAFWIRE_VERSION;
}

std::string program_and_version() {
    return "grafwire " + std::string(version());
}

}  // namespace grafwire
