#pragma once

namespace grafwire {

/// The language of reports and pictures. Machine formats do not depend on it.
enum class Language { english, french };

}  // namespace grafwire
