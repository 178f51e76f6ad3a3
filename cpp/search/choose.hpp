// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How the superset of two operands is searched.
#pragma once

#include <optional>

#include "table.hpp"
#include "tree_product.hpp"

namespace gcv {

// The superset, prepared to be searched by any number of walks at once: in a table of all of its
// edges, where they are few, or else by the product of the operands' trees. O(n + m + edges of
// the table).
class SearchableSuperset {
 public:
  // The operands stay where they are, and their directions are known.
  explicit SearchableSuperset(const Operands& operands);

  [[nodiscard]] const Operands& operands() const { return operands_; }
  // What searches allow for roundings of relative coordinates.
  [[nodiscard]] double slack() const { return slack_; }
  // One of both.
  [[nodiscard]] const std::optional<SupersetTable>& table() const { return table_; }
  [[nodiscard]] const std::optional<TreeProduct>& product() const { return product_; }

 private:
  const Operands& operands_;
  double slack_;
  std::optional<SupersetTable> table_;
  std::optional<TreeProduct> product_;
};

}  // namespace gcv
