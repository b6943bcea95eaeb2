#pragma once

#include <cstddef>

/// Allocations of this program so far, by operator new.
std::size_t allocations();
