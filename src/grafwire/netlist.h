#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grafwire/equations.h"
#include "grafwire/read.h"

namespace grafwire::api {

/// A netlist for a chart. Copies are cheap and share it; it never changes.
class Netlist {
  public:
    Chart chart() const;
    bool is_clocked() const;
    std::size_t cell_count() const;
    std::vector<std::string> inputs() const;
    std::vector<std::string> outputs() const;

    struct Parts;  ///< of the library
    explicit Netlist(std::shared_ptr<const Parts> parts) : parts_(std::move(parts)) {}
    const Parts& parts() const { return *parts_; }

  private:
    std::shared_ptr<const Parts> parts_;  ///< never null
};

/// The names of the styles: `gates`, `nand`, …
std::vector<std::string> styles();

struct NetlistOptions {
    std::string style = "nand";  ///< one of styles()
    std::optional<Cdx> cdx;      ///< none: the style's own
    bool modes = true;           ///< with Init, AUdur and AUdoux
};

/// Makes the netlist of a chart. Errors: there is no such style, or it cannot hold the chart.
Result<Netlist> make_netlist(const Chart& chart, const NetlistOptions& options = {});

/// Reads a netlist from elsewhere, in the format `blif` or `json` (Yosys). Its ports carry the
/// names of the chart; an X or output that is missing is an error, all else that does not fit a
/// warning. `starts_initially`: steps that nothing sets at power-up are taken to start in the
/// initial situation, rather than anyhow. `name`: what reports call the text.
Result<Netlist> read_netlist(const Chart& chart, std::string text, std::string_view format,
                             std::string name, bool starts_initially = false);

}  // namespace grafwire::api
