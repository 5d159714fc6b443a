#include "s7/generate/relations.h"

namespace grafwire::s7 {

bool is_complement(Relation relation) {
    return relation == Relation::not_equal || relation == Relation::less ||
           relation == Relation::greater;
}

Compare compare_of(Relation relation) {
    if (relation == Relation::equal) return Compare::equal;
    return relation == Relation::less_equal ? Compare::less_equal : Compare::greater_equal;
}

Relation mirrored(Relation relation) {
    switch (relation) {
        case Relation::less:
            return Relation::greater;
        case Relation::less_equal:
            return Relation::greater_equal;
        case Relation::greater:
            return Relation::less;
        case Relation::greater_equal:
            return Relation::less_equal;
        case Relation::equal:
        case Relation::not_equal:
            break;
    }
    return relation;
}

bool holds(std::int64_t left, Relation relation, std::int64_t right) {
    switch (relation) {
        case Relation::equal:
            return left == right;
        case Relation::not_equal:
            return left != right;
        case Relation::less:
            return left < right;
        case Relation::less_equal:
            return left <= right;
        case Relation::greater:
            return left > right;
        case Relation::greater_equal:
            return left >= right;
    }
    return false;
}

}  // namespace grafwire::s7
