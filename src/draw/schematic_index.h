#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "draw/schematic_view.h"

namespace grafwire {

/// Where the name of a net stands: the sheet of the gate that makes it, 0 where it comes from
/// outside, and the sheets on which it is read, in their order; counted from 1.
struct IndexEntry {
    NetId net = no_net;
    std::size_t made_on = 0;
    std::vector<std::size_t> read_on;
};

/// A column of the index of names.
class IndexColumn {
  public:
    IndexColumn(const SchematicView& view, std::vector<IndexEntry> entries);

    double width() const { return width_; }
    double height() const;
    void draw(SchematicPens& pens, Point at) const;

  private:
    const SchematicView* view_;
    std::vector<IndexEntry> entries_;
    double made_at_ = 0;
    double read_at_ = 0;
    double width_ = 0;
};

/// The index in columns of so many entries at most: in the order of names, a net beside its
/// complement, numbers by their value.
std::vector<IndexColumn> index_columns(const SchematicView& view, std::vector<IndexEntry> entries,
                                       std::size_t most);

}  // namespace grafwire
