// SPDX-License-Identifier: MIT
// Stands in for the page where there is no Node.js to make it with.
#include "host_sim/report/data_page.h"

namespace fixrad::host {

std::string_view page_template() {
  return {};
}

}  // namespace fixrad::host
