// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace falko_slam {
namespace topics {

// Names before remapping, relative to the node's namespace.
constexpr char kScan[] = "scan";                          ///< sensor_msgs/LaserScan
constexpr char kOdometry[] = "odom";                      ///< nav_msgs/Odometry
constexpr char kTf[] = "tf";                              ///< tf2_msgs/TFMessage
constexpr char kTfStatic[] = "tf_static";                 ///< tf2_msgs/TFMessage, latched
constexpr char kGroundTruth[] = "ground_truth";           ///< geometry_msgs/PoseStamped
constexpr char kEncoders[] = "encoders";                  ///< falko_slam/TricycleEncoders
constexpr char kJointStates[] = "joint_states";           ///< sensor_msgs/JointState
constexpr char kDriveCommand[] = "drive_command";         ///< falko_slam/DriveCommand
constexpr char kOperationPoint[] = "operation_point";     ///< falko_slam/OperationPoint
constexpr char kReflectors[] = "reflectors";              ///< falko_slam/ReflectorArray
constexpr char kGroundTruthPath[] = "ground_truth_path";  ///< nav_msgs/Path, latched
constexpr char kWorldMarkers[] = "world_markers";      ///< visualization_msgs/MarkerArray, latched
constexpr char kFeatures[] = "features";               ///< falko_slam/FeatureArray
constexpr char kFeatureMarkers[] = "feature_markers";  ///< visualization_msgs/MarkerArray
constexpr char kKeypointCloud[] = "keypoint_cloud";    ///< sensor_msgs/PointCloud2

constexpr char kKeyframes[] = "keyframes";         ///< falko_slam/KeyframeArray, latched
constexpr char kConstraints[] = "constraints";     ///< falko_slam/LoopConstraintArray
constexpr char kLoopMarkers[] = "loop_markers";    ///< visualization_msgs/MarkerArray, latched
constexpr char kPose[] = "pose";                   ///< geometry_msgs/PoseWithCovarianceStamped
constexpr char kMap[] = "map";                     ///< nav_msgs/OccupancyGrid, latched
constexpr char kMapMetadata[] = "map_metadata";    ///< nav_msgs/MapMetaData, latched
constexpr char kPath[] = "path";                   ///< nav_msgs/Path, latched
constexpr char kGraphMarkers[] = "graph_markers";  ///< visualization_msgs/MarkerArray

constexpr char kCalibrationMarkers[] = "calibration_markers";  ///< MarkerArray, latched

constexpr char kInitialPose[] = "initialpose";     ///< geometry_msgs/PoseWithCovarianceStamped
constexpr char kLocalizedOdometry[] = "odometry";  ///< nav_msgs/Odometry, in the map
constexpr char kLandmarks[] = "landmarks";         ///< falko_slam/LandmarkArray
constexpr char kMarkers[] = "markers";             ///< visualization_msgs/MarkerArray
constexpr char kStatus[] = "status";               ///< falko_slam/LocalizerStatus, latched

constexpr char kMode[] = "mode";  ///< std_msgs/String, latched, in the private namespace

constexpr char kCalibrate[] = "calibrate";  ///< action, falko_slam/Calibrate

// Services, in the node's private namespace.
constexpr char kGlobalLocalization[] = "global_localization";  ///< falko_slam/GlobalLocalization,
                                                               ///< or std_srvs/Trigger
constexpr char kSaveKeyframes[] = "save_keyframes";            ///< falko_slam/SaveKeyframes
constexpr char kLoadKeyframes[] = "load_keyframes";            ///< falko_slam/LoadKeyframes
constexpr char kDynamicMap[] = "dynamic_map";                  ///< nav_msgs/GetMap
constexpr char kSaveMap[] = "save_map";                        ///< falko_slam/SaveMap
constexpr char kSaveState[] = "save_state";                    ///< falko_slam/SaveState
constexpr char kLoadState[] = "load_state";                    ///< falko_slam/LoadState
constexpr char kPause[] = "pause";                             ///< std_srvs/SetBool
constexpr char kComputeCalibration[] = "compute_calibration";  ///< falko_slam/ComputeCalibration
constexpr char kSetMode[] = "set_mode";                        ///< falko_slam/SetMode
constexpr char kSetPose[] = "set_pose";                        ///< falko_slam/SetPose
constexpr char kReset[] = "reset";                             ///< std_srvs/Trigger

}  // namespace topics
}  // namespace falko_slam
