#pragma once

namespace judge {

/// From now on this process, and whatever it starts, has a network of its own: a loopback interface that
/// carries multicast, and nothing else. Files, and sockets made before, stay as they are.
///
/// Without the right to it, in a user namespace of its own (only while the process has one thread).
/// @throws std::invalid_argument with one sentence when the system forbids it
void enter_network_namespace();

/// Says in time, in a child process, whether that would work.
/// @throws std::invalid_argument, as `enter_network_namespace`
void check_network_namespace();

}  // namespace judge
