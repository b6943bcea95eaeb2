#pragma once

#include <optional>

#include "sim/proto/legacy2014.pb.h"
#include "sim/proto/vision.pb.h"
#include "sim/wire/epoch.h"
#include "sim/world/detection.h"
#include "sim/world/field.h"

namespace wire {

/// All messages under one name; the few names that two families share (Team, RobotId, Vector2) need theirs.
namespace proto {
using namespace matchday::vision;  // NOLINT: that is the purpose
}

/// One camera's detections as SSL-Vision sends them: millimetres, Unix seconds. Reuses the memory of `out`.
///
/// Yellow robots go before blue ones. Every number is rounded to the wire's type.
void encode(const world::Detection& detection, Epoch epoch, proto::SSL_DetectionFrame& out);

/// One camera's detections from the wire, balls in their order, yellow robots before blue ones.
///
/// Tolerant, as real logs need it. An object without a finite position inside 100 m is dropped; a robot
/// number above 15 or missing is "not identified"; an orientation that is not finite is "not determined";
/// confidence and pixels that are not finite are 0. What is more than 256 balls or 64 robots is left out. A
/// frame that is not `usable` gives a Detection without objects. Inverse of `encode` to the bit, for what has
/// been through `encode` once.
world::Detection decode(const proto::SSL_DetectionFrame& frame, Epoch epoch);
/// The same into memory that is used again: no allocation once `out` has grown to the size needed.
void decode(const proto::SSL_DetectionFrame& frame, Epoch epoch, world::Detection& out);

/// The frame says which camera and when: a camera number up to 255 and a capture time between 1970 and 2096.
bool usable(const proto::SSL_DetectionFrame& frame);

/// Field and cameras as SSL-Vision sends them, with every marking under SSL-Vision's name.
///
/// Quarter circles are described by arcs and stretches, as in 2015; a rectangle also by fields 8 and 9.
void encode(const world::Geometry& geometry, proto::SSL_GeometryData& out);

/// Field and cameras from the wire; nothing when the field's size is missing or absurd (below 0.5 m, above
/// 100 m). Of the cameras the first 64.
///
/// The defense area comes from fields 8 and 9, else from arcs, else from the stretches' lines, by name or
/// type, never by the sign of a coordinate. What the message does not say keeps its default.
std::optional<world::Geometry> decode(const proto::SSL_GeometryData& geometry);
/// The same for the message of 2010 to 2014 (log type 2).
std::optional<world::Geometry> decode(const matchday::legacy2014::SSL_GeometryData& geometry);

}  // namespace wire
