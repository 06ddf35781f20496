# Of the scripts that build, to be sourced: configure FOLDER [words for CMake] prepares a build of this
# package in FOLDER, the dependencies included. Leaves the environment that the build needs.
configure() {
  local folder=$1 arguments output
  shift
  scripts/install_dependencies
  # shellcheck disable=SC1091
  [ -n "${ROS_DISTRO:-}" ] || [ ! -f /opt/ros/noetic/setup.bash ] || {
    set +u; . /opt/ros/noetic/setup.bash; set -u; }
  # The distribution's python3, whichever one stands first on PATH: it is the one that has catkin.
  arguments=(-DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3)
  ! command -v ccache >/dev/null || arguments+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  output=$(cmake -S . -B "$folder" "${arguments[@]}" "$@" 2>&1) || { echo "$output"; return 1; }
}
