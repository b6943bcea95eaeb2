#pragma once

#include <string_view>
#include <vector>

#include "sim/world/field.h"

namespace world {

struct NamedField {
  std::string_view name;
  Field field;
};

/// Fields other than that of 2015, on which every rule set can be played under the name
/// "<rule set>-<name>", such as "ssl-2015-field-2014".
std::vector<NamedField> other_fields();

}  // namespace world
