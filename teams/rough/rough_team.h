#pragma once

#include <memory>

#include "teams/reference/reference_team.h"
#include "teams/rough/rudeness.h"

namespace rough {

/// The reference team whose orders pass through `Habits`; the same seed of the host gives the same fouls.
std::unique_ptr<kit::Team> make_team(const kit::Setup& setup, const reference::Parameters& parameters,
                                     const Rudeness& rudeness, bool notes = false);

}  // namespace rough
