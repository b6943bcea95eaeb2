#pragma once

#include <cstddef>

/// Allocations of this program so far: every malloc, calloc, realloc and aligned form,
/// whoever calls it (operator new, protobuf, Bullet). From glibc's own entry points;
/// not for sanitizer builds, which have theirs.
std::size_t allocations();

/// Prints the calls that lead to each allocation from now on to standard error, for finding the culprit.
void trace_allocations(bool on);
