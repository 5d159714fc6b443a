#pragma once

namespace grafwire {

/// Why a file that the library has closed since the last call is not whole, as in errno; 0 where
/// all are. The library itself takes no notice.
int fst_writing_error();

}  // namespace grafwire
