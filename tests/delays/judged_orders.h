#pragma once

#include <cstddef>
#include <string>

#include "delays/chart_orders.h"
#include "delays/delay_cases.h"
#include "orders/order_case.h"

namespace grafwire::testing {

/// The product and ChartOrders on the same cases, one judged by the other. They share nothing but
/// the scan of the reference.
///
/// Where both speak of the same they agree, case by case. Of edges they do not: to ChartOrders an
/// edge is there for one scan, to the product until all that wait for it have been cleared, as in
/// wiring. There a case that depends on order by the latter alone is not left out, so that the
/// netlist is judged in it. And ChartOrders does not ask whether there is an end, nor what is the
/// same in one in which transitions are cleared for ever (sources), nor about a time condition that
/// falls.
class JudgedOrders {
  public:
    explicit JudgedOrders(const Grafcet& grafcet)
        : grafcet_(grafcet), exhaustive_(grafcet), product_(grafcet) {}

    /// What the product says of a case.
    bool depends_on_order(const ChartCase& item);

    std::size_t dependent() const { return dependent_; }
    /// The first case in which they disagree, in words; empty where there is none.
    const std::string& first_disagreement() const { return first_disagreement_; }

  private:
    const Grafcet& grafcet_;
    ChartOrders exhaustive_;
    OrderCases product_;
    std::size_t dependent_ = 0;
    std::string first_disagreement_;
};

/// All cases that can be reached from the start, Init, AUdur and AUdoux included, in all their
/// inputs; at most so many. False where there are more.
bool for_each_chart_case(const Grafcet& grafcet, std::size_t most,
                         const std::function<void(const ChartCase&)>& visit);

}  // namespace grafwire::testing
