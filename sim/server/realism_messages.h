#pragma once

#include <cstddef>
#include <vector>

#include "sim/engine/realism.h"
#include "sim/proto/simulation.pb.h"
#include "sim/wire/problem.h"

namespace server {

/// Changes what the payloads say: matchday.simulation.RealismMatchday (a preset, then single keys) and
/// ER-Force's RealismConfigErForce, whose fields stand for our keys:
///
///   stddev_ball_p, stddev_robot_p              vision.ball_sigma, vision.robot_sigma
///   stddev_robot_phi, stddev_ball_area         vision.orientation_sigma, vision.area_sigma
///   enable_invisible_ball false                vision.visible_share 0
///   ball_visibility_threshold                  vision.visible_share; 0.4 where it is missing
///   camera_overlap                             vision.overlap; both count beyond the middle line
///   dribbler_ball_detections                   vision.false_ball_rate, times robots over cameras: the same
///                                              number, but only half of ours lie on robots
///   missing_ball_detections                    vision.ball_missing
///   missing_robot_detections                   vision.robot_missing
///   object_position_offset                     vision.bias_sigma: theirs is one length, ours one per axis
///   vision_delay, command_delay                vision.delay, radio.latency, to the nearest tick
///   robot_command_loss                         radio.loss
///   camera_position_error                      none: unsupported unless 0
///   robot_response_loss                        none: unsupported unless 0
///   vision_processing_time                     none: unsupported unless 0
///   simulate_dribbling                         none: unsupported if false
///
/// What cannot be obeyed changes nothing and is a problem: code::realism for an unknown key or preset or a
/// bad value, code::unsupported for what has no counterpart here.
///
/// @param robots, cameras  how many there are: ER-Force counts false balls per robot, we per camera
std::vector<wire::Problem> apply(const matchday::simulation::RealismConfig& message, std::size_t robots,
                                 std::size_t cameras, engine::Realism& realism);

}  // namespace server
