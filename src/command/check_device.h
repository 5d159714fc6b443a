#pragma once

#include <memory>
#include <optional>
#include <string>

#include "check/scanned_device.h"
#include "command/command.h"

namespace grafwire {

/// A program to be compared with a GRAFCET scan by scan, read from a file.
class DeviceToCheck {
  public:
    virtual ~DeviceToCheck() = default;
    virtual const ScannedDevice& device() const = 0;
    /// A witness in words.
    virtual std::string tell(const Witness& witness, Language language) const = 0;
};

/// Whether `path` names a file of programs (by its extension) rather than a netlist.
bool is_device_file(const std::string& path);

/// The program of a file, with messages shown; null after an error. `program` names one of several
/// in the file. The GRAFCET must outlive it.
std::unique_ptr<DeviceToCheck> load_device(const std::string& path, const std::string& program,
                                           const LoadedGrafcet& loaded, Language language);

}  // namespace grafwire
