#include "sim/world/rules/fields.h"

namespace world {

std::vector<NamedField> other_fields() {
  // RoboCup 2014, whose games are in the paper's Figure 9 (R-R15-16): 8090 mm by 6050 mm,
  // everything else as in 2015.
  Field field_2014;
  field_2014.length = 8.09;
  field_2014.width = 6.05;

  // Division A of 2026 (reference "protocol", 5.1): 12 m by 9 m, wider goals, rectangular areas, the
  // penalty mark 8 m from the goal.
  Field division_a;
  division_a.length = 12.0;
  division_a.width = 9.0;
  division_a.goal_width = 1.8;
  division_a.penalty_mark_distance = 8.0;
  division_a.defense_area.shape = DefenseArea::Shape::Rectangle;
  division_a.defense_area.depth = 1.8;
  division_a.defense_area.width = 3.6;

  return {{"field-2014", field_2014}, {"division-a", division_a}};
}

}  // namespace world
