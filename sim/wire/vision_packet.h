#pragma once

#include <cstddef>
#include <string>

#include "sim/wire/vision.h"

namespace wire {

/// The league's programs read into 8192 bytes; a longer datagram is cut there and then unreadable (reference
/// "protocol", 3.2).
inline constexpr std::size_t max_datagram_size = 8192;

/// One camera's detections as the datagram that a simulator sends: SSL_WrapperPacket with source OTHER.
///
/// Balls that would make it longer than `max_datagram_size` are left out, the last ones
/// first. Overwrites `out`.
void encode_packet(const world::Detection& detection, Epoch epoch, std::string& out);

/// Field and all cameras as such a datagram.
/// @pre few enough cameras for `max_datagram_size`: 40 are 3.9 kB
void encode_packet(const world::Geometry& geometry, std::string& out);

}  // namespace wire
