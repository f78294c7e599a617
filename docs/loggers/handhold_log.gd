# SPDX-License-Identifier: Apache-2.0
# Logs hands and objects of a Godot application (4.3 or newer) for `handhold judge-log` (docs/judge-log.md).
# Add it as a node under the XROrigin3D; name the objects to log, and what judge-log must know of each, in the inspector.
extends Node

@export var path := "user://session.jsonl"
## By the logged node's name: {"cube": {"shape": "cube.obj", "mass": 0.1, "friction": 0.46}}.
@export var objects := {}
@export var logged: Array[Node3D] = []
## The joints are those drawn, not those tracked.
@export var drawn_hands := false

var _file: FileAccess


func _ready() -> void:
	process_priority = 1000  # after what moves the objects
	_file = FileAccess.open(path, FileAccess.WRITE)
	_file.store_line(JSON.stringify({"format": "openxr", "drawn_hands": drawn_hands, "objects": objects}))


func _process(_delta: float) -> void:
	var poses := {}
	for node in logged:
		var q := node.global_basis.get_rotation_quaternion()
		poses[node.name] = {"position": _numbers(node.global_position), "orientation": [q.x, q.y, q.z, q.w]}
	var hands := {}
	for side in ["left", "right"]:
		var tracker := XRServer.get_tracker("/user/hand_tracker/" + side) as XRHandTracker
		if tracker and tracker.has_tracking_data:
			hands[side] = {"joints": _joints(tracker)}
	_file.store_line(JSON.stringify({"t": Time.get_ticks_usec() / 1e6, "hands": hands, "objects": poses}))


func _exit_tree() -> void:
	_file.close()


# The 26 joints in OpenXR's order; null where one is not tracked. Godot turns their axes, so that only places are written.
func _joints(tracker: XRHandTracker) -> Array:
	var origin := XRServer.world_origin
	var joints := []
	for joint in XRHandTracker.HAND_JOINT_MAX:
		var place := origin * tracker.get_hand_joint_transform(joint).origin
		var valid := tracker.get_hand_joint_flags(joint) & XRHandTracker.HAND_JOINT_FLAG_POSITION_VALID
		joints.append({"position": _numbers(place), "radius": tracker.get_hand_joint_radius(joint)} if valid else null)
	return joints


func _numbers(v: Vector3) -> Array:
	return [v.x, v.y, v.z]
